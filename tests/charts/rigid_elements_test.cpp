// Orders and errors of rigid finite elements in the charts: against closed forms, and figures of an
// independent implementation of both forms and of Hermite elements.

#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/flexible/modes.hpp"
#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "charts/hermite_beam.hpp"
#include "charts/reference_beam.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"
#include "support/program.hpp"

namespace rigid_elements_test {

using namespace boxbeam;
using namespace boxbeam::charts;
using flexible::Element;
using test::error_of;

namespace {

constexpr const char* richardson = "classical, extrapolated (Richardson)";
constexpr const char* hermite = "Hermite finite elements";

double order(const Chart& chart, const std::string& method, double coarse, double fine) {
  return test::order_between(test::series_of(chart, method), coarse, fine);
}

}  // namespace

TEST_CASE("roots and root moments of the cantilever are those of the books", "[charts][rfem]") {
  // Tables of cos(x) cosh(x) = -1.
  const double tabulated[] = {1.8751040687119612, 4.6940911329741746, 7.8547574382376126,
                              10.995540734875467};
  for (int k = 1; k <= 4; ++k) {
    CHECK(static_cast<double>(cantilever_root(k)) == Approx(tabulated[k - 1]).epsilon(1e-15));
  }
  // Amplification of the root moment, computed independently: r = 0.1, 0.3, 0.6, 0.9.
  const long double first = std::pow(cantilever_root(1), 2);
  const std::pair<double, double> amplification[] = {
      {0.1, 1.011}, {0.3, 1.112}, {0.6, 1.638}, {0.9, 5.85}};
  for (const auto& [r, value] : amplification) {
    CHECK(static_cast<double>(cantilever_root_moment(r * first)) == Approx(value).epsilon(1e-3));
  }
}

TEST_CASE("the initial value method on the elements has the beam's answers in the limit",
          "[charts][rfem]") {
  const flexible::Mechanism mechanism = unit_cantilever(256, Element::corrected);
  const flexible::Structure structure = structure_of(mechanism);
  const ChainReference chain(structure);
  const long double first = std::pow(cantilever_root(1), 2);
  CHECK(static_cast<double>(chain.first_omega(first) / first) == Approx(1.0).margin(1e-8));
  for (const long double r : {0.3L, 2.0L}) {
    // What the clamp does to the beam is opposite to what the force does.
    const auto moment = static_cast<double>(chain.root_moment(r * first).real());
    CHECK(-moment == Approx(static_cast<double>(cantilever_root_moment(r * first))).epsilon(1e-7));
  }
}

TEST_CASE("charts of rigid elements: published errors, orders 2, 3 and 4, statically exact",
          "[charts][rfem]") {
  const TopicResult result = rigid_elements(reference_scenes(), {true});
  REQUIRE(result.charts.size() == 5);
  CHECK(test::failures_in(result) == 0);

  const Chart& frequency = test::chart_named(result, "rfem-frequency");
  struct Row {
    double parts, classical, corrected, hermite;
  };
  for (const Row& row : {Row{4, 1.45e-2, 8.7e-4, 3.3e-5}, Row{8, 3.60e-3, 1.05e-4, 2.1e-6},
                         Row{16, 8.97e-4, 1.30e-5, 1.3e-7}, Row{32, 2.24e-4, 1.6e-6, 8e-9}}) {
    CAPTURE(row.parts);
    CHECK(error_of(frequency, "classical", row.parts) == Approx(row.classical).epsilon(5e-3));
    CHECK(error_of(frequency, "corrected", row.parts) == Approx(row.corrected).epsilon(1e-2));
    CHECK(error_of(frequency, hermite, row.parts) == Approx(row.hermite).epsilon(3e-2));
  }
  CHECK(error_of(frequency, richardson, 16) == Approx(2.8e-6).epsilon(2e-2));
  for (const char* name : {"rfem-frequency", "rfem-frequency-3"}) {
    const Chart& chart = test::chart_named(result, name);
    CHECK(order(chart, "classical", 16, 32) == Approx(2.0).margin(0.02));
    CHECK(order(chart, "corrected", 16, 32) == Approx(3.0).margin(0.1));
    CHECK(order(chart, richardson, 16, 32) == Approx(4.0).margin(0.2));
    CHECK(order(chart, hermite, 16, 32) == Approx(4.0).margin(0.05));
  }

  // Too stiff by 1/(4 n^2) by theory; the extrapolation of that is exact.
  const Chart& deflection = test::chart_named(result, "rfem-deflection");
  for (const double n : {2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
    CHECK(error_of(deflection, "classical", n) == Approx(0.25 / (n * n)).epsilon(1e-11));
    CHECK(error_of(deflection, "corrected", n) < 1e-14);
    if (n > 2.0) CHECK(error_of(deflection, richardson, n) < 1e-14);
  }

  const Chart& moment = test::chart_named(result, "rfem-root-moment");
  for (const char* r : {"0.3", "0.9"}) {
    const std::string where = std::string(", r = ") + r;
    CHECK(order(moment, "classical" + where, 16, 32) == Approx(2.0).margin(0.05));
    CHECK(order(moment, "corrected" + where, 16, 32) == Approx(3.0).margin(0.1));
  }
  // Near resonance the moment has the frequency's error 2 r^2/(1 - r^2) times.
  const double amplified = 2.0 * 0.81 / 0.19;
  for (const double n : {16.0, 32.0}) {
    CHECK(error_of(moment, "corrected, r = 0.9", n) ==
          Approx(amplified * error_of(frequency, "corrected", n)).epsilon(0.05));
  }

  // The exact form leaves round-off, with fewer unknowns than two parts of others have at the first
  // frequency; near resonance that of the frequency, amplified.
  for (const char* name : {"rfem-frequency", "rfem-frequency-3", "rfem-deflection"}) {
    CHECK(test::series_of(test::chart_named(result, name), "exact").points.front().error < 1e-12);
  }
  CHECK(*test::series_of(frequency, "exact").points.front().operations <= 4.0);
  for (const char* where : {"exact, r = 0.3", "exact, r = 0.9"}) {
    CHECK(test::series_of(moment, where).points.front().error < 1e-12);
  }

  for (const Chart& chart : result.charts) {
    CAPTURE(chart.name);
    REQUIRE(default_point(chart) != nullptr);
    CHECK(default_point(chart)->error <= chart.needed_high);
  }
  CHECK(test::errors_of(rigid_elements(reference_scenes(), {true})) == test::errors_of(result));
}

TEST_CASE("charts of rigid elements of another case, and of one without elastic links",
          "[charts][rfem]") {
  const Scenes scenes =
      scenes_of(read_project(test::project_file("sections/templates/flexible.toml")));
  const TopicResult result = rigid_elements(scenes, {true});
  CHECK(test::failures_in(result) == 0);
  const Chart& chart = test::chart_named(result, "rfem-reactions");
  CHECK(default_point(chart)->error <= chart.needed_high);
  CHECK(error_of(chart, "classical", 16) < 0.2 * error_of(chart, "classical", 4));
  // A case of rigid bodies has no such joints; the beam of the other charts is none of a case.
  const TopicResult rigid = rigid_elements(
      scenes_of(read_project(test::project_file("sections/sledge-rig/rig.toml"))), {true});
  CHECK(rigid.charts.size() == 4);
}

}  // namespace rigid_elements_test
