// Sobol indices beside closed forms: Ishigami's function and Sobol's g-function by their
// published variances, a sum of normal variables by hand; and what their bounds are worth.

#include "boxbeam/study/sobol_indices.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/study_summary.hpp"
#include "catch.hpp"

namespace sobol_indices_test {

using namespace boxbeam;

namespace {

using Function = std::function<double(const std::vector<double>&)>;

std::string uniform(const std::string& name, double min, double max) {
  return fmt::format("[variables.{}]\ndistribution = \"uniform\"\nmin = {}\nmax = {}\n", name, min,
                     max);
}

std::string normal(const std::string& name, double mean, double sd) {
  return fmt::format("[variables.{}]\ndistribution = \"normal\"\nmean = {}\nsd = {}\n", name, mean,
                     sd);
}

std::string head(std::size_t samples, const char* sampling = "sobol", int seed = 1) {
  return fmt::format("[study]\nsamples = {}\nsampling = \"{}\"\nseed = {}\n", samples, sampling,
                     seed);
}

const std::string foot = "[results]\ncolumns = [\"f = 1\"]\n[indices]\n";

IndexPlan plan_of(const Study& study) {
  IndexPlan plan{{}, study.indices->resamples, study.seed};
  for (const Variable& variable : study.variables) plan.variables.push_back(variable.name);
  return plan;
}

std::vector<double> values_of(const Study& study, const Function& f) {
  const DesignSpace space(study);
  std::vector<double> values;
  for (std::size_t i = 0; i < space.size(); ++i) {
    std::vector<double> x;
    for (const Setting& setting : space.at(i)) x.push_back(setting.number);
    values.push_back(f(x));
  }
  return values;
}

SobolIndices indices_of(const std::string& text, const Function& f) {
  const Study study = parse_study("study.toml", text);
  return sobol_indices_of(values_of(study, f), plan_of(study));
}

bool holds(const BoundedEstimate& of, double exact) { return of.low <= exact && exact <= of.high; }

double ishigami(const std::vector<double>& x) {
  return std::sin(x[0]) + 7.0 * std::pow(std::sin(x[1]), 2) +
         0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

std::string three_angles() {
  using std::numbers::pi;
  return uniform("a", -pi, pi) + uniform("b", -pi, pi) + uniform("c", -pi, pi);
}

// a = 7, b = 0.1: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2 and its parts (Ishigami, Homma 1990).
constexpr double ishigami_first[] = {0.3139052, 0.4424111, 0.0};
constexpr double ishigami_total[] = {0.5575889, 0.4424111, 0.2436837};

}  // namespace

TEST_CASE("indices of Ishigami's function", "[study]") {
  const SobolIndices indices = indices_of(head(8192) + three_angles() + foot, ishigami);
  CHECK(indices.samples == 8192);
  CHECK(indices.left_out == 0);
  CHECK(indices.variance == Approx(13.8445879).epsilon(0.01));
  REQUIRE(indices.of.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    const auto& [first, total] = indices.of[i];
    CHECK(first.value == Approx(ishigami_first[i]).margin(0.01));
    CHECK(total.value == Approx(ishigami_total[i]).margin(0.01));
    CHECK(holds(first, ishigami_first[i]));
    CHECK(holds(total, ishigami_total[i]));
    CHECK(first.high - first.low < 0.06);
  }
}

TEST_CASE("indices of Sobol's g-function, a = 0, 9, 99", "[study]") {
  // V_i = 1/(3 (1 + a_i)^2), V = product of (1 + V_i) - 1.
  const double a[] = {0.0, 9.0, 99.0};
  const std::string text =
      head(4096) + uniform("x", 0, 1) + uniform("y", 0, 1) + uniform("z", 0, 1) + foot;
  const SobolIndices indices = indices_of(text, [&](const std::vector<double>& x) {
    double product = 1.0;
    for (std::size_t i = 0; i < 3; ++i)
      product *= (std::abs(4.0 * x[i] - 2.0) + a[i]) / (1.0 + a[i]);
    return product;
  });
  const double first[] = {0.9867118, 0.0098671, 0.0000987};
  const double total[] = {0.9900339, 0.0131566, 0.0001320};
  CHECK(indices.variance == Approx(0.3378224).epsilon(0.01));
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(holds(indices.of[i].first, first[i]));
    CHECK(holds(indices.of[i].total, total[i]));
    CHECK(indices.of[i].total.value == Approx(total[i]).epsilon(0.02));
  }
}

TEST_CASE("of a sum each variable has the part of its variance", "[study]") {
  // 3 x + 2 y - z with standard deviations 1, 2, 0.5: variances 9, 16, 0.25.
  const std::string text =
      head(4096) + normal("x", 5.0, 1.0) + normal("y", -1.0, 2.0) + normal("z", 0.0, 0.5) + foot;
  const auto sum = [](const std::vector<double>& x) { return 3.0 * x[0] + 2.0 * x[1] - x[2]; };
  const SobolIndices indices = indices_of(text, sum);
  const double parts[] = {9.0 / 25.25, 16.0 / 25.25, 0.25 / 25.25};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(indices.of[i].first.value == Approx(parts[i]).margin(0.005));
    CHECK(indices.of[i].total.value == Approx(parts[i]).margin(0.005));
    CHECK(holds(indices.of[i].first, parts[i]));
    CHECK(holds(indices.of[i].total, parts[i]));
  }
  // Nor does it matter from where and in what unit the result is counted.
  const SobolIndices other =
      indices_of(text, [&](const std::vector<double>& x) { return 1e6 - 1e-3 * sum(x); });
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(other.of[i].first.value == Approx(indices.of[i].first.value).epsilon(1e-5));
    CHECK(other.of[i].total.high == Approx(indices.of[i].total.high).epsilon(1e-5));
  }
}

TEST_CASE("bounds hold the exact indices as often as they say, and are no wider", "[study]") {
  constexpr int seeds = 60;
  std::size_t inside = 0, all = 0;
  double width = 0.0, sum = 0.0, squares = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SobolIndices indices =
        indices_of(head(400, "random", seed) + three_angles() + foot, ishigami);
    for (std::size_t i = 0; i < 3; ++i) {
      inside += holds(indices.of[i].first, ishigami_first[i]) ? 1 : 0;
      inside += holds(indices.of[i].total, ishigami_total[i]) ? 1 : 0;
      all += 2;
    }
    const BoundedEstimate& of = indices.of[0].total;
    width += (of.high - of.low) / seeds;
    sum += of.value / seeds;
    squares += of.value * of.value / seeds;
  }
  // 95 % of them; six of one seed hang together, so that their standard error is 2 % at most.
  CHECK(static_cast<double>(inside) > 0.89 * static_cast<double>(all));
  // Two times 1.96 standard deviations of what independent samples say; that of 60 is known to 9 %.
  CHECK(width == Approx(3.92 * std::sqrt(squares - sum * sum)).epsilon(0.28));
}

TEST_CASE("each sample is a block: two designs, and one with a variable of each", "[study]") {
  for (const char* sampling : {"random", "latin hypercube", "sobol"}) {
    CAPTURE(sampling);
    const Study study = parse_study("study.toml", head(16, sampling) + three_angles() + foot);
    const DesignSpace space(study);
    REQUIRE(space.size() == 16 * 5);
    for (std::size_t k = 0; k < 16; ++k) {
      const std::vector<Setting> a = space.at(5 * k), b = space.at(5 * k + 1);
      for (std::size_t j = 0; j < 3; ++j) {
        const std::vector<Setting> mixed = space.at(5 * k + 2 + j);
        for (std::size_t i = 0; i < 3; ++i)
          CHECK(mixed[i].number == (i == j ? b[i].number : a[i].number));
      }
      // The sequence begins in the corner and the middle, the same of both.
      bool differs = k < 2;
      for (std::size_t i = 0; i < 3; ++i) differs = differs || a[i].number != b[i].number;
      CHECK(differs);
    }
  }
}

TEST_CASE("samples without a result are left out, what does not vary has no indices", "[study]") {
  const std::string text = head(256) + three_angles() + foot;
  const Study study = parse_study("study.toml", text);
  const IndexPlan plan = plan_of(study);
  std::vector<double> values = values_of(study, ishigami);
  // The first 64 samples are a quarter of them in every way of the sequence.
  for (std::size_t k = 0; k < 192; ++k)
    values[5 * (64 + k) + k % 5] = std::numeric_limits<double>::quiet_NaN();
  const SobolIndices rest = sobol_indices_of(values, plan);
  CHECK(rest.samples == 64);
  CHECK(rest.left_out == 192);
  values.resize(64UL * 5);
  const SobolIndices alone = sobol_indices_of(values, plan);
  CHECK(rest.of[1].total.value == alone.of[1].total.value);
  CHECK(rest.of[1].total.low == alone.of[1].total.low);

  const SobolIndices flat = indices_of(text, [](const std::vector<double>&) { return 355e6; });
  CHECK(flat.samples == 256);
  CHECK(flat.of.empty());
  // Rounding is no variance.
  const SobolIndices rounded =
      indices_of(text, [](const std::vector<double>& x) { return 355e6 + 1e-8 * x[0]; });
  CHECK(rounded.of.empty());
  CHECK(indices_of(head(8) + three_angles() + foot, ishigami).of.empty());
}

TEST_CASE("statistics of a study gather what indices need", "[study]") {
  const Study study = parse_study("study.toml", head(64) + three_angles() + foot);
  const IndexPlan plan = plan_of(study);
  const DesignSpace space(study);
  StudyStatistics statistics({{"a", ""}, {"b", ""}, {"c", ""}, {"f", ""}, {"word", ""}}, 3, true,
                             plan);
  std::vector<double> values;
  for (std::size_t i = 0; i < space.size(); ++i) {
    std::vector<double> x;
    std::vector<std::string> cells;
    for (const Setting& setting : space.at(i)) {
      x.push_back(setting.number);
      cells.push_back(fmt::format("{}", setting.number));
    }
    const bool fails = i == 7;
    values.push_back(fails ? std::numeric_limits<double>::quiet_NaN() : ishigami(x));
    cells.push_back(fails ? "" : fmt::format("{}", values.back()));
    cells.emplace_back(fails ? "" : "pass");
    statistics.take(cells, fails ? "it cannot be built" : "ok");
  }
  StudySummary summary;
  statistics.put_into(summary);
  REQUIRE(summary.indices.size() == 1);
  CHECK(summary.indices[0].column.name == "f");
  CHECK(summary.indices[0].indices.left_out == 1);
  const SobolIndices expected = sobol_indices_of(values, plan);
  CHECK(summary.indices[0].indices.of[2].first.value == expected.of[2].first.value);
}

TEST_CASE("studies of which no indices can be had say why", "[study]") {
  struct Broken {
    std::string text, says;
  };
  const std::string ab = normal("a", 0, 1) + normal("b", 0, 1);
  const std::string result = "[results]\ncolumns = [\"f = a\"]\n";
  const std::vector<Broken> all = {
      {head(64) + ab + "[correlation]\n\"a,b\" = 0.3\n" + foot, "independent variables"},
      {head(64) + ab + "[variables.c]\nvalues = [1, 2]\n" + foot, "several values"},
      {head(64) + "[variables.a]\nvalues = [1]\n" + foot, "no variable scatters"},
      {"[study]\n" + ab + foot, "how many designs"},
      {head(64) + ab + result + "[indices]\nresamples = 3\n", "resamples"},
      {head(64) + ab + result + "[indices]\nresample = 300\n", "resample"},
      {head(64) + ab + "[results]\ncolumns = [\"beam.mass\"]\n[indices]\n", "no case"},
      {head(64) + ab + "[results]\ncolumns = [\"f = a + q\"]\n[indices]\n", "\"q\""},
      {head(64) + ab + "[results]\ncolumns = [\"f = a + \"]\n[indices]\n", "write a formula"},
      {head(64) + ab + "[results]\ncolumns = [\"f = a\", \"f = b\"]\n[indices]\n", "twice"},
      {head(64) + ab + "[results]\ncolumns = [\"a = b\"]\n[indices]\n", "a variable and a column"},
  };
  for (const Broken& broken : all) {
    CAPTURE(broken.text, broken.says);
    try {
      parse_study("study.toml", broken.text);
      FAIL("it was read");
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Catch::Contains(broken.says));
    }
  }
}

}  // namespace sobol_indices_test
