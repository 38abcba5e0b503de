// Modes with and without static correction: figures of an independent computation, and theory.

#include <cmath>

#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"
#include "support/program.hpp"

namespace response_test {

using namespace boxbeam;
using namespace boxbeam::charts;
using test::error_of;

TEST_CASE("charts of the response: static correction is what makes few modes enough",
          "[charts][response][unsanitized]") {
  const TopicResult result = response(reference_scenes(), {true});
  REQUIRE(result.charts.size() == 4);
  CHECK(test::failures_in(result) == 0);

  // Root moment of a cantilever by one mode, computed independently: 11 to 14 % without, 2e-5 to
  // 4e-4 with static correction up to r = 0.3.
  const Chart& below = test::chart_named(result, "response-below-resonance");
  for (const char* r : {"r = 0.1", "r = 0.3"}) {
    const double alone = error_of(below, std::string("modes alone, ") + r, 1);
    CHECK(alone > 0.11);
    CHECK(alone < 0.14);
    const double with = error_of(below, std::string("modes with static correction, ") + r, 1);
    CHECK(with > 2e-5);
    CHECK(with < 4e-4);
    CHECK(error_of(below, std::string("direct, ") + r, 64) < 1e-13);
  }
  // What static correction leaves of the modes left out is r^2 (omega_1/omega_j)^2 of them.
  CHECK(error_of(below, "modes with static correction, r = 0.3", 4) /
            error_of(below, "modes with static correction, r = 0.1", 4) ==
        Approx(9.0).epsilon(0.15));

  // Beyond the first mode two are needed; the same figures for r = 2: some percent with one mode,
  // 1.5e-4 with three.
  const Chart& beyond = test::chart_named(result, "response-beyond-resonance");
  const std::string at_2 = "modes with static correction, r = 2";
  CHECK(error_of(beyond, at_2, 1) > 0.03);
  CHECK(error_of(beyond, at_2, 3) == Approx(1.5e-4).epsilon(0.25));

  // The drill truck: 24 modes are enough with, not without; the direct solution is that of all.
  const Chart& sweep = test::chart_named(result, "response-sweep");
  REQUIRE(default_point(sweep) != nullptr);
  CHECK(default_point(sweep)->error <= sweep.needed_high);
  CHECK(error_of(sweep, "modes alone", 24) > sweep.needed_high);
  CHECK(sweep.series.back().points.front().error < 1e-10);

  CHECK(test::errors_of(response(reference_scenes(), {true})) == test::errors_of(result));
}

TEST_CASE("charts of the response of another case, and of one without elastic links",
          "[charts][response]") {
  const TopicResult boom = response(
      scenes_of(read_project(test::project_file("sections/templates/flexible.toml"))), {true});
  REQUIRE(boom.charts.size() == 4);
  CHECK(test::failures_in(boom) == 0);
  CHECK(test::chart_named(boom, "response-joints").series.back().points.front().error < 1e-10);
  const TopicResult rigid =
      response(scenes_of(read_project(test::project_file("sections/sledge-rig/rig.toml"))), {true});
  CHECK(rigid.charts.size() == 2);
}

}  // namespace response_test
