// A coupler on three equal cranks, one more than it needs, against hand formulas: what is
// redundant, and positions in which cranks lie on one line.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/closed_forms.hpp"

namespace parallel_cranks_test {

using namespace boxbeam;
using namespace boxbeam::planar;
using namespace test::closed_forms;

namespace {

/// Three equal cranks (0, 1, 2) and the coupler 3 that they carry; massless. A force stands on the
/// coupler.
Mechanism three_cranks(const std::array<Eigen::Vector2d, 3>& pivots, double r, const Driver& driver,
                       const Eigen::Vector2d& load) {
  const double theta = driver_at(driver, 0.0).value;
  Mechanism mechanism;
  const char* names[] = {"crank 0", "crank 1", "crank 2"};
  for (std::size_t i = 0; i < 3; ++i) {
    mechanism.bodies.push_back(bar(names[i], r, 0.0, pivots[i], theta));
  }
  mechanism.bodies.push_back(Body{"coupler", 0.0, 0.0, {}, {r * unit_of(theta), 0.0}});
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& pivot = pivots[static_cast<std::size_t>(i)];
    mechanism.joints.push_back(
        {"fixed " + std::to_string(i), Pin{{i, {-0.5 * r, 0.0}}, {ground, pivot}}});
    mechanism.joints.push_back(
        {"moving " + std::to_string(i), Pin{{i, {0.5 * r, 0.0}}, {3, pivot}}});
  }
  mechanism.joints.push_back({"motor", Driven{{0}, Coordinate::angle, driver}});
  if (load.norm() > 0.0) {
    mechanism.forces = {{"load", PointForce{{3, {0.1, 0.2}},
                                            std::atan2(load.y(), load.x()),
                                            false,
                                            HarmonicDriver{load.norm(), 0.0, 0.0, 0.0, {}}}}};
  }
  return mechanism;
}

/// The coupler moves along a circle of the cranks' radius without turning.
Errors coupler_errors(const Motion& motion, double r, const RateDriver& driver) {
  Errors errors;
  for (const State& state : motion.states) {
    const DriverState theta = driver_at(driver, state.time);
    const Eigen::Vector2d e = unit_of(theta.value), n = left_of(e);
    const double w = theta.rate;
    errors.add(state, 9, {r * e.x(), r * w * n.x(), -r * w * w * e.x()});
    errors.add(state, 10, {r * e.y(), r * w * n.y(), -r * w * w * e.y()});
    errors.add(state, 11, {});
    for (int crank = 1; crank < 3; ++crank) errors.add_angle(state, crank, {theta.value, w, 0.0});
  }
  return errors;
}

}  // namespace

TEST_CASE("parallelogram with a third crank off the line: one redundancy, nowhere singular") {
  const double r = 0.3, omega = 5.0;
  const RateDriver driver{0.35, omega};
  const Eigen::Vector2d load(40.0, -70.0);
  const Mechanism mechanism =
      three_cranks({Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}, {0.4, 0.6}}, r, driver, load);
  const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
  CHECK(freedom.gruebler == 0);  // 12 - 12
  CHECK(freedom.by_rank == 1);
  CHECK(freedom.redundant == 1);
  CHECK(freedom.drivers == 1);
  CHECK(freedom.undriven == 0);
  // The coupler can be held in tension by its three cranks, and by nothing else: all pins take
  // part, the driver does not.
  CHECK(freedom.repeating == std::vector<int>{0, 1, 2, 3, 4, 5});
  for (int joint = 0; joint < 6; ++joint) CHECK_FALSE(is_unique(freedom, joint));
  CHECK(is_unique(freedom, 6));

  const Motion motion = solve_motion(mechanism, 144);
  const Errors errors = coupler_errors(motion, r, driver);
  double moment_error = 0.0;
  for (const State& state : motion.states) {
    // The driver's moment by virtual work, whatever the cranks share.
    const Reaction motor = reaction_on(mechanism, state, "motor", 0);
    const Eigen::Vector2d n = left_of(unit_of(driver_at(driver, state.time).value));
    moment_error = std::max(moment_error, std::abs(motor.moment + r * load.dot(n)));
  }
  CHECK(errors.q < 1e-13);
  CHECK(errors.v < 1e-12);
  CHECK(errors.a < 1e-10);
  CHECK(moment_error < 1e-11);
  CHECK(motion.change_points.empty());
  CHECK(worst_imbalance(mechanism, motion) < 1e-12);
}

TEST_CASE("three cranks off a line: nothing happens where two of them are a flat parallelogram") {
  // Two of the cranks alone would be at a change point where they lie along their pivots' line; the
  // third keeps the whole regular (its condition stays below 50 all around). So an instant exactly
  // there is like any other, and the shares of the load in the cranks stay of its size.
  const double r = 0.3, omega = 5.0;
  const Eigen::Vector2d load(40.0, -70.0);
  const std::array<Eigen::Vector2d, 3> pivots = {Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}, {0.4, 0.6}};
  for (const double flat : {0.0, std::atan2(0.6, 0.4), std::atan2(0.6, -0.6)}) {
    const RateDriver driver{flat - 0.25 * pi, omega};
    const Mechanism mechanism = three_cranks(pivots, r, driver, load);
    const Motion motion = solve_motion(mechanism, 144);  // every 2.5 degrees, `flat` among them
    const Errors errors = coupler_errors(motion, r, driver);
    double largest = 0.0, condition = 0.0;
    for (const State& state : motion.states) {
      condition = std::max(condition, condition_of(mechanism, state.q));
      for (const Reaction& reaction : reactions_of(mechanism, state)) {
        largest = std::max(largest, reaction.force.norm());
      }
    }
    INFO("flat at " << flat << ": errors " << errors.q << ", " << errors.v << ", " << errors.a
                    << "; largest force " << largest << " N; condition " << condition);
    CHECK(condition < 50.0);
    CHECK(errors.v < 1e-12);
    CHECK(errors.a < 1e-10);
    CHECK(largest < 20.0 * load.norm());
    CHECK(motion.change_points.empty());
    CHECK_NOTHROW(solve_motion(mechanism));
  }
}

TEST_CASE("parallelogram with a third crank on the line: through the flat position") {
  // Where all pivots lie on one line, the flat position loses rank: a change point, twice per turn.
  const double r = 0.3, omega = 5.0;
  const std::array<Eigen::Vector2d, 3> pivots = {
      Eigen::Vector2d(0.0, 0.0), {1.0, 0.0}, {0.45, 0.0}};
  for (const double start : {0.35, 0.0}) {  // beside the flat position, and in it
    const RateDriver driver{start, omega};
    const Mechanism mechanism = three_cranks(pivots, r, driver, {0.0, 0.0});
    if (start > 0.0) {
      const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
      CHECK(freedom.gruebler == 0);
      CHECK(freedom.by_rank == 1);
      CHECK(freedom.redundant == 1);
      CHECK(is_unique(freedom, 6));
    } else {
      // Each crank could start out on its own.
      const DegreesOfFreedom flat = degrees_of_freedom_of(mechanism, sketch_of(mechanism));
      CHECK(flat.by_rank > 1);
      CHECK(flat.redundant > 1);
    }
    const Motion motion = solve_motion(mechanism, 144);
    const Errors errors = coupler_errors(motion, r, driver);
    // Within half a milliradian of a change point only ten digits of a velocity are left.
    CHECK(errors.q < 1e-11);
    CHECK(errors.v < 1e-8);
    CHECK(errors.a < 1e-4);
    CHECK(motion.change_points.size() >= 2);
  }
}

}  // namespace parallel_cranks_test
