// Orders and floors are those of the rules: Davis and Rabinowitz, Methods of Numerical Integration
// (1984), 2.1 to 2.7.

#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "charts/topics.hpp"
#include "support/program.hpp"

namespace cut_forces_test {

using namespace boxbeam;
using namespace boxbeam::charts;

namespace {

constexpr double round_off = 1e-15;

Scenes rig_with(const std::vector<std::string>& changes) {
  return scenes_of(read_project(test::project_file("sections/sledge-rig/rig.toml"), changes));
}

}  // namespace

TEST_CASE("cut forces on the rig: exact to round-off, trapezoids of order 2, jumps of order 1",
          "[charts]") {
  const TopicResult result = cut_forces(reference_scenes(), {true});
  REQUIRE(result.not_applicable.empty());

  const Chart& moment = test::chart_named(result, "cut-forces-moment");
  REQUIRE(test::defaults_of(moment).size() == 1);
  CHECK(test::defaults_of(moment)[0].error < round_off);
  // Only the height of the box tapers: q is quadratic, the moment's integrand cubic, which
  // Simpson's rule and two Gauss points take exactly.
  CHECK(test::error_at(test::series_of(moment, "Gauss"), 1) > 1e-4);
  CHECK(test::error_at(test::series_of(moment, "Gauss"), 2) < round_off);
  CHECK(test::error_at(test::series_of(moment, "Simpson"), 1) < round_off);
  CHECK(test::order_between(test::series_of(moment, "masses"), 4, 1024) == Approx(2).margin(0.05));
  CHECK(test::order_between(test::series_of(moment, "trapezoids"), 4, 1024) ==
        Approx(2).margin(0.05));
  // Trapezoids in turn and masses in the middles err to opposite sides; both are there.
  CHECK(test::error_at(test::series_of(moment, "trapezoids"), 1) < 1e-2);

  const Chart& jumps = test::chart_named(result, "cut-forces-jumps");
  REQUIRE(test::defaults_of(jumps).size() == 1);
  CHECK(test::defaults_of(jumps)[0].error < round_off);
  // A jump anywhere in a part costs h^1 in the force and is felt as such, whatever the rule.
  for (const char* rule : {"Gauss", "Simpson", "stations"}) {
    CAPTURE(rule);
    const Series& series = test::series_of(jumps, rule);
    CHECK(test::error_at(series, 1024) > 1e6 * round_off);
    CHECK(test::order_between(series, 4, 1024) == Approx(1).margin(0.6));
  }

  const Chart& peak = test::chart_named(result, "cut-forces-peak");
  REQUIRE(test::defaults_of(peak).size() == 1);
  CHECK(test::defaults_of(peak)[0].error < peak.needed_low);
  // A peak midway between stations: h^2/8 of its curvature; a parabola leaves its third derivative.
  CHECK(test::order_between(test::series_of(peak, "equal stations"), 16, 64) ==
        Approx(3).margin(0.1));
  CHECK(test::order_between(peak.series.back(), 16, 64) == Approx(2).margin(0.1));
}

TEST_CASE("cut forces where q is cubic: Simpson's order is 4, three Gauss points are exact",
          "[charts]") {
  // Width and walls taper as well as the height: A is quadratic, the acceleration linear.
  const Scenes scenes = rig_with({"sections.A2.width=900 mm", "sections.A2.flange=20 mm"});
  const TopicResult result = cut_forces(scenes, {true});
  const Chart& moment = test::chart_named(result, "cut-forces-moment");
  const Series& simpson = test::series_of(moment, "Simpson");
  CHECK(test::order_between(simpson, 1, 16) == Approx(4).margin(0.1));
  const Series& gauss = test::series_of(moment, "Gauss");
  CHECK(test::error_at(gauss, 2) > 1e-8);
  CHECK(test::error_at(gauss, 2) < test::error_at(gauss, 1));
  for (const double points : {3.0, 4.0, 5.0}) CHECK(test::error_at(gauss, points) < round_off);
  CHECK(test::defaults_of(moment)[0].error < round_off);
}

TEST_CASE("cut forces of an even beam have no chart of jumps, of two runs the same errors",
          "[charts]") {
  const Scenes scenes =
      scenes_of(read_project(test::project_file("sections/landing-gear/gear.toml")));
  const TopicResult once = cut_forces(scenes, {true});
  CHECK_THROWS_AS(test::chart_named(once, "cut-forces-jumps"), std::out_of_range);
  CHECK(test::errors_of(once) == test::errors_of(cut_forces(scenes, {true})));
}

}  // namespace cut_forces_test
