// Toggles located in long double, against closed forms.

#include "boxbeam/study/toggle.hpp"

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "catch.hpp"
#include "stability/benches.hpp"
#include "study/charts.hpp"

using namespace boxbeam;
using namespace boxbeam::study;

TEST_CASE("the toggle of the four-bar, to the digits of a long double (law of cosines)") {
  const ToggleScene scene = four_bar_before_toggle();
  CHECK(static_cast<double>(std::abs(scene.toggle.value - test::FourBar{}.limit())) < 2e-18);
  CHECK(scene.toggle.side == 1);
  double distance = 1e-3;
  const planar::Mechanism there = scene.before(distance);
  CHECK(distance == Approx(1e-3).epsilon(1e-12));
  const InstantIn<long double> exact = scene.exact(distance);
  const long double phi = scene.toggle.value - static_cast<long double>(distance);
  CHECK(static_cast<double>(
            std::abs(exact.v[8] - test::posture_of(test::FourBar{}, phi, 1).rocker_rate)) < 1e-14);
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
