#include "verdict_notes.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "bent_flanges.hpp"
#include "boxbeam/mechanism/recorded/loads.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

constexpr int parts = 8;  // of a stretch, at whose ends d is looked at
constexpr double much = 0.05;

struct Hidden {
  double moment = 0.0, s = 0.0;
  Stress stress;       ///< of it, in the extreme fibre
  double share = 0.0;  ///< of what is wanted against yielding
  const char* shear = "";
};

/// d at the parts of all stretches, of loads that given cut forces make: their couples along the
/// beam are what V adds to M and the given M has not.
Eigen::VectorXd left_out_by(const BeamLoads& loads, std::size_t axis) {
  Eigen::VectorXd d(static_cast<Eigen::Index>(loads.lines.size() * parts));
  double sum = 0.0;
  Eigen::Index at = 0;
  for (const LineLoad& line : loads.lines) {
    const auto& m = line.couple[axis];
    const auto until = [&](double x) { return x * (m.c[0] + 0.5 * m.c[1] * x); };
    for (int k = 1; k <= parts; ++k) d[at++] = sum + until(line.length.value() * k / parts);
    sum += until(line.length.value());
  }
  return d;
}

/// The stress of a moment of one in the extreme fibre [1/m^3], the larger one of both sides.
double stress_per_moment(const Project& project, Length s, std::size_t axis) {
  double most = 0.0;
  for (const Side side : {Side::before, Side::behind}) {
    const Section section = section_at(project.beam, {s, side});
    const SectionProperties of = properties_of(section);
    const Extent extent = extent_of(section.outer);
    const auto far = [](Length low, Length high) {
      return std::max(std::abs(low.value()), std::abs(high.value()));
    };
    most = std::max(most, axis == 1 ? far(extent.z_low, extent.z_high) / of.I_y.value()
                                    : far(extent.y_low, extent.y_high) / of.I_z.value());
  }
  return most;
}

Stress least_yield_at(const Project& project, Length s) {
  std::vector<Length> plates = thicknesses_of(section_at(project.beam, {s, Side::behind}));
  const PlateOf plate =
      first_to_yield(plates_around(project, s, *std::max_element(plates.begin(), plates.end())));
  return *yield_strength_of(*plate.material, plate.thickness);
}

/// Where the moments of a situation leave out most, with its load factor.
Hidden most_hidden_in(const Project& project, const SituationRun& run, std::size_t axis) {
  const recorded::ChannelLoads& of = run.loads.recorded_loads();
  const Eigen::VectorXd constant = left_out_by(of.constant, axis);
  std::vector<Eigen::VectorXd> units;
  for (const BeamLoads& unit : of.units) units.push_back(left_out_by(unit, axis));
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(constant.size());
  for (std::size_t i = 0; i < of.channels->times.size(); ++i) {
    Eigen::VectorXd d = constant;
    for (std::size_t k = 0; k < units.size(); ++k) d += of.channels->values[k][i] * units[k];
    largest = largest.cwiseMax(d.cwiseAbs());
  }
  Hidden most;
  Eigen::Index at = 0;
  for (const LineLoad& line : of.constant.lines) {
    for (int k = 1; k <= parts; ++k, ++at) {
      const double moment = run.situation->load_factor * largest[at];
      if (!(moment > 0.0)) continue;
      const Length s =
          std::min(Length(line.start + line.length * (double(k) / parts)), project.beam.length());
      const Stress stress = si<Stress>(moment * stress_per_moment(project, s, axis));
      if (!(stress > most.stress)) continue;
      const StrengthDemand& demand = project.strength;
      most = {moment, s.value(), stress,
              (demand.required * demand.gamma_M0 * stress / least_yield_at(project, s)),
              axis == 1 ? "V_z" : "V_y"};
    }
  }
  return most;
}

double largest_use_by_yield(const std::vector<CheckResult>& checks) {
  double most = 0.0;
  for (const CheckResult& of : checks) {
    if (of.check.criterion == Criterion::yield) most = std::max(most, of.check.utilisation());
  }
  return most;
}

}  // namespace

GivenCutsFound look_at_given_cuts(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<CheckResult>& checks) {
  GivenCutsFound found;
  const auto* const given = std::get_if<recorded::Loads>(&project.mechanism);
  if (given == nullptr || !given->as_cuts || !project.given_stresses.empty()) return found;
  for (const std::size_t axis : {std::size_t{1}, std::size_t{2}}) {
    Hidden most;
    for (const SituationRun& run : runs) {
      const Hidden here = most_hidden_in(project, run, axis);
      if (here.share > most.share) most = here;
    }
    const bool tires = project.fatigue.asked && most.stress > hardly_changes;
    if (!(most.share > much) && !tires) continue;
    const std::string what = fmt::format(
        "{} makes a bending moment at s = {:.4g} m that differs by {:.4g} kN m, {:.3g} MPa, from "
        "the given one, which is linear between stations",
        most.shear, most.s, 1e-3 * most.moment, 1e-6 * most.stress.value());
    const std::string hint =
        "more stations between, twice where a moment jumps, or the other sign of a column";
    if (most.share > much && largest_use_by_yield(checks) + most.share > 1.0)
      found.gates.push_back({"", "", fmt::format("{}: {}", what, hint), true});
    else
      found.not_judged.push_back(
          {tires && !(most.share > much) ? Criterion::fatigue : Criterion::yield,
           "given cut forces", fmt::format("{}: {}", what, hint)});
  }
  return found;
}

}  // namespace boxbeam
