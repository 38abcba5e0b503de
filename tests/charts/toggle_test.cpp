// Toggles located in long double, against closed forms.

#include "charts/toggle.hpp"

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "charts/chart_values.hpp"
#include "stability/benches.hpp"

namespace toggle_test {

using namespace boxbeam;
using namespace boxbeam::charts;

TEST_CASE("the toggle of the four-bar, to the digits of a long double (law of cosines)") {
  const ToggleScene scene = four_bar_before_toggle();
  CHECK(static_cast<double>(std::abs(scene.toggle.value - test::FourBar{}.limit())) < 2e-18);
  CHECK(scene.toggle.side == 1);
  const auto place = scene.place(1e-3);
  REQUIRE(place);
  CHECK(place->distance == Approx(1e-3).epsilon(1e-12));
  const long double phi = scene.toggle.value - static_cast<long double>(place->distance);
  const long double rate = test::posture_of(test::FourBar{}, phi, 1).rocker_rate;
  CHECK(static_cast<double>(std::abs(place->exact.v[8] - rate)) < 1e-14);
}

TEST_CASE("close to a toggle the exact state is still that of the closed form") {
  // The loss of velocities is that of round-off, here 2^-64, over the distance.
  const ToggleScene scene = four_bar_before_toggle();
  for (const double share : {1e-1, 1e-6, 1e-9, 1e-12}) {
    const auto place = scene.place(share);
    REQUIRE(place);
    const long double phi = scene.toggle.value - static_cast<long double>(place->distance);
    const long double rate = test::posture_of(test::FourBar{}, phi, 1).rocker_rate;
    INFO("distance " << place->distance);
    CHECK(static_cast<double>(std::abs(place->exact.v[8] / rate - 1.0L)) < 1e-16 + 1e-18 / share);
  }
}

TEST_CASE("the toggle of the sledge rig is where its upper rod is stretched (Pythagoras)") {
  // 3 m and 0.5 m to a line 3 m above the pivot: x = sqrt(3.5^2 - 3^2).
  const ToggleScene scene = toggle_scene_of(reference_scenes());
  CHECK(static_cast<double>(std::abs(scene.toggle.value - std::sqrt(3.25L))) < 1e-17);
}

TEST_CASE("a crank that turns round has no toggle: the four-bar stands in for it") {
  CHECK(toggle_scene_of(test::shipped_scene("slider-crank-press/press.toml")).name ==
        four_bar_before_toggle().name);
}

}  // namespace toggle_test
