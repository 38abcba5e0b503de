// Applied forces and friction in sliders, by hand formulas.

#include "boxbeam/mechanism/planar/forces.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"

namespace forces_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double pi = std::numbers::pi;

/// Two bodies without joints, anywhere.
struct Pair {
  Mechanism mechanism;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(6);

  Pair() {
    mechanism.bodies.resize(2);
    q << 1.0, 2.0, 0.5, -0.4, 0.3, -1.1;
    v << 0.2, -0.3, 0.7, 0.1, 0.4, -0.5;
  }
};

/// A block of mass m on a horizontal rail, pushed away by a massless rod of 1 m whose upper end is
/// driven down the y axis: at t = 0 the rod stands at 45 degrees, and the block moves to the right.
Mechanism pushed_block(double coefficient) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -10.0};
  const double s = std::sqrt(0.5);
  mechanism.bodies = {Body{"block", 3.0, 0.0, {}, {{s, 0.0}, 0.0}},
                      Body{"head", 0.0, 0.0, {}, {{0.0, s}, 0.0}}};
  Slider rail{{0}, {}, 0.0, 0.0, {}};
  rail.friction.coulomb = coefficient;
  rail.friction.creep = 1e-9;
  mechanism.joints = {{"rail", rail},
                      {"column", Slider{{1}, {}, 0.5 * pi, 0.0}},
                      {"rod", Distance{{0}, {1}, 1.0}},
                      {"press", Driven{{1}, Coordinate::y, PolynomialDriver{{s, -0.5}}}}};
  return mechanism;
}

}  // namespace

TEST_CASE("spring and damper between two points: force along them, opposite on both") {
  Pair pair;
  const Attachment a{0, {0.2, 0.1}};
  const Attachment b{1, {-0.3, 0.4}};
  pair.mechanism.forces = {{"spring", Spring{a, b, 500.0, 0.8, 40.0}}};
  const Eigen::Vector2d d = position_of(b, pair.q) - position_of(a, pair.q);
  const Eigen::Vector2d rate = velocity_of(b, pair.q, pair.v) - velocity_of(a, pair.q, pair.v);
  const double pull = 500.0 * (d.norm() - 0.8) + 40.0 * d.normalized().dot(rate);
  const auto loads = applied_loads_of(pair.mechanism, 0.0, pair.q, pair.v);
  REQUIRE(loads.size() == 2);
  CHECK((loads[0].vector - pull * d.normalized()).norm() < 1e-12 * std::abs(pull));
  CHECK((loads[0].vector + loads[1].vector).norm() == 0.0);
}

TEST_CASE("power of applied forces is the rate of what they store and lose") {
  // Q . v = -d(k (d - d0)^2/2)/dt - c d'^2, likewise for the torsion spring; force and couple give
  // their own power. The rate of the stored energy by a central difference.
  Pair pair;
  const Attachment a{0, {0.2, 0.1}};
  const Attachment b{1, {-0.3, 0.4}};
  pair.mechanism.forces = {{"spring", Spring{a, b, 500.0, 0.8, 0.0}},
                           {"torsion", TorsionSpring{a, b, 70.0, 0.2, 0.0}}};
  const auto energy = [&](const Eigen::VectorXd& q) {
    const double stretch = (position_of(b, q) - position_of(a, q)).norm() - 0.8;
    const double twist = q[2] - q[5] - 0.2;
    return 250.0 * stretch * stretch + 35.0 * twist * twist;
  };
  Eigen::VectorXd Q = Eigen::VectorXd::Zero(6);
  add_applied_forces(pair.mechanism, 0.0, pair.q, pair.v, Q);
  const double h = 1e-5;
  const double rate = (energy(pair.q + h * pair.v) - energy(pair.q - h * pair.v)) / (2.0 * h);
  CHECK(Q.dot(pair.v) == Approx(-rate).epsilon(1e-8));

  pair.mechanism.forces = {{"push", PointForce{a, 0.3, true, HarmonicDriver{5.0, 2.0, 3.0, 0.4}}},
                           {"couple", Couple{a, b, PolynomialDriver{{4.0, 1.0}}}}};
  Q.setZero();
  add_applied_forces(pair.mechanism, 0.7, pair.q, pair.v, Q);
  const double size = 5.0 + 2.0 * std::sin(3.0 * 0.7 + 0.4);
  const Eigen::Vector2d force = size * Eigen::Vector2d(std::cos(0.8), std::sin(0.8));
  const double power = force.dot(velocity_of(a, pair.q, pair.v)) + 4.7 * (pair.v[2] - pair.v[5]);
  CHECK(Q.dot(pair.v) == Approx(power).epsilon(1e-13));
}

TEST_CASE("a block pushed by a rod against friction (hand formula)") {
  // At 45 degrees: x' = 0.5, x'' = -(x'^2 + y'^2)/x = -0.5/sqrt(1/2); rod force S from
  // S cos - mu N = m x'', N = m g + S sin.
  Mechanism mechanism = pushed_block(0.3);
  InstantSolver solver(mechanism);
  const State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
  const double c = std::sqrt(0.5);
  const double acceleration = -0.5 / c;
  CHECK(state.v[0] == Approx(0.5).epsilon(1e-12));
  CHECK(state.a[0] == Approx(acceleration).epsilon(1e-12));
  const double S = (3.0 * acceleration + 0.3 * 30.0) / (c - 0.3 * c);
  const double N = 30.0 + S * c;
  for (const Reaction& reaction : reactions_of(mechanism, state)) {
    if (reaction.joint != 0) continue;
    CHECK(reaction.force.y() == Approx(N).epsilon(1e-12));
    CHECK(reaction.force.x() == Approx(-0.3 * N).epsilon(1e-9));
  }
}

TEST_CASE("friction that locks is refused, not guessed") {
  // mu tan(45 deg) above one: the harder the rod pushes, the more the rail holds.
  Mechanism mechanism = pushed_block(1.2);
  InstantSolver solver(mechanism);
  try {
    solver.solve_from_sketch(0.0, sketch_of(mechanism));
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().where == "joint rail");
    CHECK(error.failure().what.find("locks") != std::string::npos);
  }
}

TEST_CASE("a moment taken by the two ends of a guide presses twice") {
  // A force F at height h above a guided block: moment F h, taken by a guide of length l with
  // 2 F h/l on its two ends together, more than the weight: friction mu 2 F h/l.
  Mechanism mechanism;
  mechanism.gravity = {0.0, -10.0};
  mechanism.bodies = {Body{"block", 1.0, 0.0, {}, {}}};
  Slider rail{{0}, {}, 0.0, 0.0, {}};
  rail.friction.coulomb = 0.1;
  rail.friction.creep = 1e-9;
  rail.friction.guide = 0.2;
  mechanism.joints = {{"rail", rail}, {"motor", Driven{{0}, Coordinate::x, RateDriver{0.0, 1.0}}}};
  mechanism.forces = {{"high", PointForce{{0, {0.0, 0.5}}, 0.0, false, PolynomialDriver{{40.0}}}}};
  InstantSolver solver(mechanism);
  const State state = solver.solve_from_sketch(0.0, sketch_of(mechanism));
  const double friction = 0.1 * 2.0 * 40.0 * 0.5 / 0.2;
  // The driver balances friction and the force: on the block -lambda of its row.
  CHECK(-state.lambda[2] == Approx(friction - 40.0).epsilon(1e-9));
}

}  // namespace forces_test
