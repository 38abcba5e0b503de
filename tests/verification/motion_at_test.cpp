// States of a motion at asked times only.

#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "catch.hpp"
#include "charts/known_motions.hpp"

namespace motion_at_test {

using namespace boxbeam;

namespace {

Project n_four_bar_over(int loops, double duration) {
  Project project;
  planar::Mechanism mechanism = charts::n_four_bar(loops);
  mechanism.bodies.front().points = {{"B0", {0.5, 0.0}}};
  mechanism.duration.length = duration;
  project.beam_body = planar::ground;
  project.mechanism = mechanism;
  return project;
}

}  // namespace

// The exact solution: IFToMM benchmark A02, by quadrature (see n_four_bar_test.cpp). Over the
// singular position, which it passes at 0.97 s for N = 2, a step may err by 1e-6.
TEST_CASE("N-four-bar at 1 s, for every duration: no further than it must is integrated") {
  for (const double duration : {1.0, 2.0, 7.0, 21.0}) {
    const MotionResult motion = motion_of(n_four_bar_over(2, duration), {1.0, 0.5, 1.0});
    REQUIRE(motion.states.size() == 3);
    CHECK(motion.states[0].time == 1.0);
    CHECK(motion.states[1].time == 0.5);
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
      const Eigen::Vector2d& tip = motion.states[i].points.front().position;
      CHECK(tip.x() == Approx(-0.195020301949435094).margin(2e-6));
      CHECK(tip.y() == Approx(-0.980799205662173833).margin(2e-6));
    }
    const Eigen::Vector2d early = charts::n_four_bar_tip_at(2, 0.5);
    CHECK((motion.states[1].points.front().position - early).norm() < 1e-8);
  }
}

TEST_CASE("N-four-bar with 40 loops at 1 s") {
  const MotionResult motion = motion_of(n_four_bar_over(40, 20.0), {1.0});
  const Eigen::Vector2d exact = charts::n_four_bar_tip_at(40, 1.0);
  CHECK((motion.states.front().points.front().position - exact).norm() < 2e-6);
}

TEST_CASE("a time outside the motion is refused with how long it lasts") {
  CHECK_THROWS_WITH(motion_of(n_four_bar_over(2, 1.0), {1.5}), Catch::Contains("0 s to 1 s"));
  CHECK_THROWS_WITH(motion_of(n_four_bar_over(2, 1.0), {-0.5}), Catch::Contains("0 s to 1 s"));
}

}  // namespace motion_at_test
