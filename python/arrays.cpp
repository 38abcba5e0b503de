#include "arrays.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/project/named_resistance.hpp"

namespace boxbeam::python {
namespace {

namespace py = pybind11;

std::span<const double> samples_of(const Samples& samples, const char* name) {
  if (samples.ndim() != 1) throw py::value_error(fmt::format("{} is no array of one row", name));
  return {samples.data(), static_cast<std::size_t>(samples.size())};
}

template <class Kind>
Kind kind_named(const std::string& name, std::initializer_list<std::pair<const char*, Kind>> kinds,
                const char* what) {
  std::string known;
  for (const auto& [word, kind] : kinds) {
    if (name == word) return kind;
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", word);
  }
  throw InputError(fmt::format("{} \"{}\" is not known", what, name), "write one of " + known);
}

CountingRule rule_named(const std::string& counting, const std::string& residue) {
  return {kind_named<Counting>(counting,
                               {{"astm", Counting::astm},
                                {"4-point", Counting::four_point},
                                {"periodic", Counting::periodic}},
                               "counting"),
          kind_named<Residue>(residue,
                              {{"half-cycles", Residue::half_cycles},
                               {"repeated", Residue::repeated},
                               {"discard", Residue::discard}},
                              "residue")};
}

/// Range, mean and count of every cycle [Pa].
py::tuple rainflow(const Samples& history, const std::string& counting,
                   const std::string& residue) {
  const std::span<const double> samples = samples_of(history, "the history");
  std::vector<double> range, mean, count;
  {
    const py::gil_scoped_release others_run;
    const CountingRule rule = rule_named(counting, residue);
    if (const auto bad = find_uncountable(samples))
      throw InputError(fmt::format("sample {} of the history is {}, which cannot be counted", *bad,
                                   samples[*bad]),
                       "leave out what is no finite number");
    RainflowCounter counter(rule, [&](const CycleBatch& batch) {
      range.insert(range.end(), batch.range.begin(), batch.range.end());
      mean.insert(mean.end(), batch.mean.begin(), batch.mean.end());
      count.insert(count.end(), batch.range.size(), batch.count);
    });
    counter.push(samples);
    counter.finish();
  }
  return py::make_tuple(array_of(std::move(range)), array_of(std::move(mean)),
                        array_of(std::move(count)));
}

/// What the cycles of a spectrum do: damage, safety factor, equivalent range [Pa], curve.
py::tuple damage(const Samples& ranges, const Samples& means, const Samples& counts,
                 const std::string& detail, std::optional<double> thickness, double gamma_Ff,
                 double gamma_Mf, const std::string& loading, bool stress_relieved, bool shear) {
  const std::span<const double> range = samples_of(ranges, "ranges");
  const std::span<const double> mean = samples_of(means, "means");
  const std::span<const double> count = samples_of(counts, "counts");
  if (range.size() != mean.size() || range.size() != count.size())
    throw py::value_error("ranges, means and counts are not as many");
  const py::gil_scoped_release others_run;
  for (const double factor : {gamma_Ff, gamma_Mf})
    if (!(factor > 0.0) || !std::isfinite(factor))
      throw InputError("a partial factor is not above zero", "write 1.35");
  if (thickness && (!(*thickness > 0.0) || !std::isfinite(*thickness)))
    throw InputError("the thickness is not above zero", "write it in m: 0.02");
  const FatigueDemand demand{
      kind_named<Loading>(
          loading, {{"spectrum", Loading::spectrum}, {"constant", Loading::constant_amplitude}},
          "loading"),
      gamma_Ff, gamma_Mf};
  const NamedResistance resistance =
      resistance_named(detail, shear ? StressKind::shear : StressKind::direct,
                       thickness ? std::optional(si<Length>(*thickness)) : std::nullopt);
  std::vector<Cycle> cycles;
  cycles.reserve(range.size());
  for (std::size_t i = 0; i < range.size(); ++i) {
    if (!(range[i] >= 0.0) || !std::isfinite(range[i]) || !std::isfinite(mean[i]) ||
        !(count[i] >= 0.0) || !std::isfinite(count[i]))
      throw InputError(fmt::format("cycle {} has a range or count that is no number above zero", i),
                       "leave it out");
    cycles.push_back({si<Stress>(range[i]), si<Stress>(mean[i]), count[i]});
  }
  if (stress_relieved) cycles = compression_reduced(std::move(cycles));
  const double sum = damage_of(cycles, resistance.curve, demand);
  const double factor = largest_factor(cycles, resistance.curve, demand);
  const double equivalent = equivalent_range(sum, resistance.curve, demand).value();
  const py::gil_scoped_acquire again;
  return py::make_tuple(sum, factor, equivalent,
                        fmt::format("{}: {}", resistance.curve.code, resistance.curve.name));
}

}  // namespace

py::dict columns_of(std::vector<MotionColumn>&& columns) {
  struct AsObject {
    std::size_t instants;
    py::object operator()(MotionColumn::Numbers& of) const {
      std::vector<std::size_t> shape{instants};
      shape.insert(shape.end(), of.shape.begin(), of.shape.end());
      return array_of(std::move(of.values)).attr("reshape")(shape);
    }
    py::object operator()(const MotionColumn::Words& of) const { return py::cast(of); }
    py::object operator()(const MotionColumn::Truths& of) const { return py::cast(of); }
    py::object operator()(MotionColumn::Below& of) const { return columns_of(std::move(of)); }
  };
  py::dict named;
  for (MotionColumn& column : columns)
    named[py::str(column.name)] = std::visit(AsObject{column.instants}, column.of);
  return named;
}

void add_fatigue(py::module_& module) {
  module.def("rainflow", rainflow);
  module.def("damage", damage);
}

}  // namespace boxbeam::python
