// Motion of the sledge rig: closed form, balance of power, following a branch, failing clearly.

#include "boxbeam/mechanism/planar/motion.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace motion_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double period = 1.0 / 0.7;

}  // namespace

TEST_CASE("positions of the rig by intersecting circles (hand formula)") {
  const Mechanism& mechanism = planar_of(test::rig());
  for (int i = 0; i < 24; ++i) {
    const double time = period * i / 24.0;
    const State state = test::rig_state(time);
    // B lies on the circle of 3.0 m about O and of 0.5 m about A; the drawn one is left of OA.
    const Eigen::Vector2d A(0.5 + 0.25 * std::sin(2.0 * std::numbers::pi * 0.7 * time), 3.0);
    const double d = A.norm();
    const double along = (d * d + 3.0 * 3.0 - 0.5 * 0.5) / (2.0 * d);
    const double across = std::sqrt(9.0 - along * along);
    const Eigen::Vector2d u = A / d;
    const Eigen::Vector2d B = along * u + across * Eigen::Vector2d(-u.y(), u.x());
    const double angle = std::atan2(B.y(), B.x());
    const Eigen::Vector2d C = -3.2 / 3.0 * B;
    const double E_x = C.x() + std::sqrt(0.685 * 0.685 - (C.y() + 3.2) * (C.y() + 3.2));
    CHECK(state.q[2] == Approx(angle).epsilon(1e-13));
    CHECK(state.q[6] == Approx(A.x()).margin(1e-13));
    CHECK(state.q[12] == Approx(E_x).margin(1e-12));
    CHECK(branch_of(mechanism, state.q) == std::vector<int>{1, 1});
  }
}

TEST_CASE("power of the driver is the rate of kinetic and potential energy, at 100 instants") {
  const Mechanism& mechanism = planar_of(test::rig());
  const Motion motion = solve_motion(mechanism, 100);
  const int exciter = joint_index(mechanism, "exciter");
  double largest_power = 0.0;
  double largest_gap = 0.0;
  for (const State& state : motion.states) {
    double rate = 0.0;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
      const Body& body = mechanism.bodies[i];
      const auto k = static_cast<Eigen::Index>(3 * i);
      const Eigen::Vector2d v = state.v.segment<2>(k);
      rate +=
          body.mass * v.dot(state.a.segment<2>(k)) + body.inertia * state.v[k + 2] * state.a[k + 2];
      rate -= body.mass * mechanism.gravity.dot(v);
    }
    double power = 0.0;
    for (const Reaction& reaction : reactions_of(mechanism, state)) {
      if (reaction.joint != exciter) continue;
      power += reaction.force.dot(velocity_of({reaction.on, reaction.point}, state.q, state.v));
    }
    largest_power = std::max(largest_power, std::abs(power));
    largest_gap = std::max(largest_gap, std::abs(power - rate));
  }
  CHECK(largest_power > 1e4);
  CHECK(largest_gap < 1e-9 * largest_power);
}

TEST_CASE("velocities and accelerations are the time derivatives of the positions") {
  const Mechanism& mechanism = planar_of(test::rig());
  InstantSolver solver(mechanism);
  const State here = test::rig_state(0.2);
  const double h = 1e-4;
  const State before = solver.solve_near(0.2 - h, here);
  const State behind = solver.solve_near(0.2 + h, here);
  CHECK(((behind.q - before.q) / (2.0 * h) - here.v).lpNorm<Eigen::Infinity>() < 1e-6);
  CHECK(((behind.v - before.v) / (2.0 * h) - here.a).lpNorm<Eigen::Infinity>() < 1e-5);
}

TEST_CASE("an instant does not depend on where it is solved from") {
  const Mechanism& mechanism = planar_of(test::rig());
  const State direct = test::rig_state(1.071);
  const Motion motion = solve_motion(mechanism);
  StateFinder finder(mechanism, motion);
  const State followed = finder.at(1.071);
  const State one_period_later = finder.at(1.071 + period);
  CHECK((direct.q - followed.q).lpNorm<Eigen::Infinity>() < 1e-12);
  CHECK((direct.lambda - followed.lambda).lpNorm<Eigen::Infinity>() < 1e-6);
  CHECK((one_period_later.q - followed.q).lpNorm<Eigen::Infinity>() < 1e-11);
}

TEST_CASE("a wrong sketch is no reason for a wrong branch") {
  Mechanism mechanism = planar_of(test::rig());
  mechanism.bodies[1].sketch.angle = 3.0;  // the upper rod drawn the other way round
  mechanism.bodies[3].sketch.angle = 3.1;  // and the lower one
  InstantSolver solver(mechanism);
  const State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
  CHECK(branch_of(mechanism, state.q) == std::vector<int>{1, 1});
}

TEST_CASE("a mechanism that cannot be assembled is refused with time and residual") {
  Mechanism mechanism = planar_of(test::rig());
  test::exciter_of(mechanism).mean = 5.0;  // the blade out of reach
  InstantSolver solver(mechanism);
  try {
    solver.solve_from_sketch(0.0, sketch_of(mechanism));
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().time.value() == 0.0);
    CHECK(error.failure().residual.value() > 1e-3);
  }
}

TEST_CASE("a motion that reaches the end of its reach is refused, not continued") {
  // Rods of 0.5 m at a stroke of 1.302776 m just reach (the distance of O and A is then 3.5 m:
  // 0.5 + x = sqrt(3.5^2 - 3^2)); a little more does not.
  Mechanism mechanism = planar_of(test::rig());
  const double just = std::sqrt(3.5 * 3.5 - 9.0) - 0.5;
  HarmonicDriver& driver = test::exciter_of(mechanism);
  driver.amplitude = just + 1e-3;
  CHECK_THROWS_AS(solve_motion(mechanism), AnalysisError);
}

TEST_CASE("more equations than coordinates, or fewer, are refused") {
  Mechanism mechanism = planar_of(test::rig());
  mechanism.joints.pop_back();
  CHECK_THROWS_AS(InstantSolver(mechanism), AnalysisError);
}

TEST_CASE("sharp peaks get more instants") {
  Mechanism mechanism = planar_of(test::rig());
  const std::size_t smooth = solve_motion(mechanism).states.size();
  HarmonicDriver& driver = test::exciter_of(mechanism);
  driver.amplitude = std::sqrt(3.5 * 3.5 - 9.0) - 0.5 - 2e-3;  // 2 mm from the end of the reach
  CHECK(smooth == 96);
  CHECK(solve_motion(mechanism).states.size() > smooth);
}

TEST_CASE("a heavily damped free motion is found between its instants as at them") {
  // J omega' = -c omega: omega = omega_0 exp(-c t/J), with c/J = 200/s. Backwards in time this
  // grows: states are found from the instant before, never from the one behind.
  Mechanism mechanism;
  mechanism.bodies = {Body{"wheel", 1.0, 0.5, {}, {}}};
  mechanism.bodies[0].start_velocity = {0.0, 0.0, 3.0};
  mechanism.joints = {{"axle", Pin{{0, {0.0, 0.0}}, {}}}};
  mechanism.forces = {{"brake", TorsionSpring{{0}, {}, 0.0, 0.0, 100.0}}};
  mechanism.duration = {0.0, 0.2};
  const Motion motion = solve_motion(mechanism, 8);
  StateFinder finder(mechanism, motion);
  for (const double time : {0.001, 0.024, 0.026, 0.1, 0.13, 0.199}) {
    CHECK(finder.at(time).v[2] == Approx(3.0 * std::exp(-200.0 * time)).margin(1e-9));
  }
}

TEST_CASE("a time that holds more waves than can be resolved is refused, not aliased") {
  Mechanism mechanism = planar_of(test::rig());
  mechanism.duration.length = 24576.0 * period;
  try {
    solve_motion(mechanism);
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().what.find("24576 waves") != std::string::npos);
  }
}

TEST_CASE("a body that turns faster than can be resolved is named") {
  // A wheel of 1 m drives a pinion of 0.1 mm: 1e4 times as fast.
  Mechanism mechanism;
  mechanism.bodies = {Body{"wheel", 1.0, 0.5, {}, {}}, Body{"pinion", 1.0, 0.5, {}, {}}};
  mechanism.bodies[1].sketch.centre = {1.0001, 0.0};
  mechanism.joints = {{"axle", Pin{{0, {0.0, 0.0}}, {}}},
                      {"shaft", Pin{{1, {0.0, 0.0}}, {ground, {1.0001, 0.0}}}},
                      {"mesh", Gear{{0, {0.0, 0.0}}, {1, {0.0, 0.0}}, 1.0, 1e-4}},
                      {"motor", Driven{{0}, Coordinate::angle, RateDriver{0.0, 1.0}}}};
  CHECK_THROWS_WITH(solve_motion(mechanism),
                    Catch::Contains("body pinion") && Catch::Contains("up to 1e+04 rad/s"));
}

TEST_CASE("a torsion spring that is wound up with every turn makes no closed motion") {
  Mechanism mechanism;
  mechanism.bodies = {Body{"wheel", 1.0, 0.5, {}, {}}};
  mechanism.joints = {{"axle", Pin{{0, {0.0, 0.0}}, {}}},
                      {"motor", Driven{{0}, Coordinate::angle, RateDriver{0.0, 5.0}}}};
  CHECK(solve_motion(mechanism, 16).closed);
  mechanism.forces = {{"spring", TorsionSpring{{0}, {}, 1e-3, 0.0, 0.0}}};
  CHECK_THROWS_AS(solve_motion(mechanism, 16), AnalysisError);
  mechanism.duration.length = 2.0;
  CHECK_FALSE(solve_motion(mechanism, 16).closed);
}

TEST_CASE("what repeats and what ends have no time in common without a duration") {
  Mechanism mechanism = planar_of(test::rig());
  mechanism.forces = {
      {"push", PointForce{{4, {0.0, 0.0}}, 0.0, false, StepDriver{0.0, 1.0, 0.0, 0.05}}}};
  CHECK_THROWS_AS(time_span_of(mechanism), AnalysisError);
  mechanism.duration.length = 1.0;
  CHECK_FALSE(time_span_of(mechanism).closed);
}

TEST_CASE("a body that nothing holds has three freedoms") {
  Mechanism mechanism;
  mechanism.bodies = {Body{"stone", 1.0, 0.5, {}, {}}};
  const DegreesOfFreedom freedom = degrees_of_freedom_of(mechanism, Eigen::VectorXd::Zero(3));
  CHECK(freedom.by_rank == 3);
  CHECK(freedom.undriven == 3);
  CHECK(condition_of(mechanism, Eigen::VectorXd::Zero(3)) == 0.0);
  // It falls: y = -g t^2/2.
  mechanism.gravity = {0.0, -9.81};
  mechanism.duration.length = 2.0;
  const Motion motion = solve_motion(mechanism, 8);
  CHECK(motion.end.q[1] == Approx(-0.5 * 9.81 * 4.0).epsilon(1e-10));
  // No joint has a force that would ask for more instants.
  const Motion resolved = solve_motion(mechanism);
  CHECK(resolved.states.front().lambda.size() == 0);
  CHECK(resolved.end.q[1] == Approx(-0.5 * 9.81 * 4.0).epsilon(1e-10));
}

TEST_CASE("multipliers are called unique only where they are so all along the motion") {
  // A planet of half its annulus' radius rolls; a point of its rim runs on a straight line
  // (Cardan's circles) and is guided there once more. At the start the guide's repetition does not
  // touch the arm's pins, a little later it does.
  Mechanism mechanism;
  mechanism.bodies = {Body{"arm", 1.0, 0.1, {}, {{0.5, 0.0}, 0.0}},
                      Body{"planet", 1.0, 0.1, {}, {{1.0, 0.0}, 0.0}}};
  mechanism.joints = {{"O", Pin{{0, {-0.5, 0.0}}, {}}},
                      {"A", Pin{{0, {0.5, 0.0}}, {1, {0.0, 0.0}}}},
                      {"mesh", Gear{{1}, {}, 1.0, -2.0, 0.0}},
                      {"line", PinInSlot{{1, {1.0, 0.0}}, {}, 0.0}},
                      {"motor", Driven{{0}, Coordinate::angle, RateDriver{0.0, 2.0}}}};
  // The mesh's offset that belongs to the start, from its own equation there.
  ConstraintEquations equations(mechanism);
  equations.set_time(0.0);
  equations.set_position(sketch_of(mechanism));
  Eigen::VectorXd phi(equations.rows());
  equations.evaluate(phi);
  std::get<Gear>(mechanism.joints[2].kind).offset = phi[4];
  const Motion motion = solve_motion(mechanism, 48);
  CHECK(motion.freedom.redundant == 1);
  CHECK_FALSE(is_unique(motion.freedom, 0));
  CHECK_FALSE(is_unique(motion.freedom, 1));
  CHECK_FALSE(is_unique(motion.freedom, 2));
  CHECK_FALSE(is_unique(motion.freedom, 3));
}

TEST_CASE("an instant that lies in a change point is found where the motion has passed it") {
  // A massless parallelogram whose crank lies flat at two of the 48 instants: the coupler keeps its
  // angle.
  Mechanism mechanism;
  mechanism.bodies = {Body{"crank", 0.0, 0.0, {}, {{0.0, 0.25}, 1.57}},
                      Body{"coupler", 0.0, 0.0, {}, {{0.5, 0.5}, 0.0}},
                      Body{"rocker", 0.0, 0.0, {}, {{1.0, 0.25}, 1.57}}};
  mechanism.joints = {
      {"O", Pin{{0, {-0.25, 0.0}}, {ground, {0.0, 0.0}}}},
      {"A", Pin{{0, {0.25, 0.0}}, {1, {-0.5, 0.0}}}},
      {"B", Pin{{1, {0.5, 0.0}}, {2, {0.25, 0.0}}}},
      {"C", Pin{{2, {-0.25, 0.0}}, {ground, {1.0, 0.0}}}},
      {"motor", Driven{{0}, Coordinate::angle, RateDriver{0.5 * std::numbers::pi, 2.0}}}};
  const Motion motion = solve_motion(mechanism, 48);
  StateFinder finder(mechanism, motion);
  CHECK(motion.change_points.size() >= 2);
  for (const std::size_t i : {11U, 12U, 13U, 36U}) {
    CHECK(std::abs(finder.at(motion.states[i].time).q[5]) < 1e-9);
  }
}

}  // namespace motion_test
