// The N-four-bar of two loops passes positions where all links lie flat and three motions cross.
// However often one looks at it on its way, it stays on its own.

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "catch.hpp"
#include "charts/known_motions.hpp"

namespace singular_passage_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr int loops = 2;

double error_of(const State& state) {
  const Attachment tip{0, {0.5, 0.0}};
  return (position_of(tip, state.q) - charts::n_four_bar_tip_at(loops, state.time)).norm();
}

}  // namespace

TEST_CASE("singular positions are passed on the same motion, wherever it is looked at") {
  const Mechanism mechanism = charts::n_four_bar(loops);
  constexpr double end = 4.0;  // four flat positions
  double worst = 0.0;
  for (int instants = 1; instants < 200; instants += instants < 20 ? 1 : 9) {
    FreeSolver solver(mechanism);
    State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
    for (int i = 1; i <= instants; ++i) {
      state = solver.advance(end * i / instants, state);
      CAPTURE(instants, state.time);
      REQUIRE(error_of(state) < 1e-5);
      worst = std::max(worst, error_of(state));
    }
  }
  INFO("largest error " << worst << " m");
  CHECK(worst > 0.0);
}

TEST_CASE("states within a passage are interpolated, and the way goes on from its end") {
  // Flat at a quarter of the turn: from the exact motion, theta = pi/2.
  const Mechanism mechanism = charts::n_four_bar(loops);
  double flat = 0.5, above = 0.8;
  while (above - flat > 1e-12) {
    const double middle = 0.5 * (flat + above);
    (charts::n_four_bar_tip_at(loops, middle).y() > 0.0 ? flat : above) = middle;
  }
  for (const double beside : {0.0, 1e-9, 1e-6, 1e-4, -1e-7}) {
    CAPTURE(beside);
    FreeSolver solver(mechanism);
    const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
    const State at = solver.advance(flat + beside, first);
    CHECK(error_of(at) < 1e-7);
    CHECK(at.residual < 1e-7);
    // The motion is smooth: rates are those of a turn, theta'^2 = 1 + 2 k (1 - cos(theta)) and
    // theta'' = k sin(theta), clockwise.
    const double k = 9.81 * (0.5 * (loops + 1) + loops) / ((loops + 1) / 3.0 + loops);
    const Eigen::Vector2d tip = charts::n_four_bar_tip_at(loops, at.time);
    CHECK(at.v[2] == Approx(-std::sqrt(1.0 + 2.0 * k * (1.0 - tip.y()))).epsilon(1e-6));
    CHECK(at.a[2] == Approx(-k * tip.x()).epsilon(1e-3));
    CHECK(at.v[5] == Approx(at.v[2]).epsilon(1e-6));
    CHECK(error_of(solver.advance(flat + 1e-5, at)) < 1e-7);
    CHECK(error_of(solver.advance(1.5, at)) < 1e-6);
  }
}

}  // namespace singular_passage_test
