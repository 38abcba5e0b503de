// Motion under forces against closed forms: the simple pendulum of the IFToMM library of
// computational benchmark problems (A01), oscillators, sliding with friction.

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "catch.hpp"
#include "charts/known_motions.hpp"

namespace pendulum_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

constexpr double g = 9.81;

/// A body of mass m on a horizontal line, at x with velocity v.
Mechanism block(double m, double x, double v, const Friction& friction = {}) {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  mechanism.bodies = {Body{"block", m, 0.4, {}, {{x, 0.0}, 0.0}, {v, 0.0, 0.0}}};
  mechanism.joints = {{"line", Slider{{0}, {ground, {0.0, 0.0}}, 0.0, 0.0, friction}}};
  return mechanism;
}

/// A spring (and damper) from a wall at x = -length to the block, relaxed with the block at 0.
AppliedForce spring_to_wall(double stiffness, double damping) {
  const double length = 2.0;
  return {"spring", Spring{{0}, {ground, {-length, 0.0}}, stiffness, length, damping}};
}

double unprojected_residual(double tolerance, double time) {
  const Mechanism mechanism = charts::simple_pendulum();
  FreeSolver solver(mechanism, tolerance, false);
  const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  return solver.advance(time, first).residual;
}

}  // namespace

TEST_CASE("simple pendulum: A01 at 1 s and 10 s, and the period") {
  // Exact, by elliptic functions.
  const Eigen::Vector2d at_1(0.98629175113187532, -0.16501085312554117);
  const Eigen::Vector2d at_10(-0.27508746257611686, -0.96141920509912506);
  const double period = 2.3678419475762374;
  const Mechanism mechanism = charts::simple_pendulum();
  FreeSolver solver(mechanism);
  const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  const State one = solver.advance(1.0, first);
  const State ten = solver.advance(10.0, one);
  const State back = solver.advance(period, first);
  const double error_1 = (one.q.head<2>() - at_1).norm();
  const double error_10 = (ten.q.head<2>() - at_10).norm();
  const double error_period = (back.q.head<2>() - Eigen::Vector2d(-1.0, 0.0)).norm();
  INFO("1 s: " << error_1 << ", 10 s: " << error_10 << ", period: " << error_period);
  // Reached: 9e-12, 1.7e-10 and 1.5e-11 m.
  CHECK(error_1 < 1e-10);
  CHECK(error_10 < 2e-9);
  CHECK(error_period < 2e-10);
  // Energy: v^2/2 + g y = 0; with it the pin pulls 3 m g times the depth, towards itself.
  for (const State& state : {one, ten, back}) {
    const double y = state.q[1];
    CHECK(std::abs(0.5 * state.v.head<2>().squaredNorm() + g * y) < 1e-9 * g);
    const Reaction pin = reactions_of(mechanism, state).front();
    CHECK((pin.force - 3.0 * g * y * state.q.head<2>()).norm() < 1e-8 * g);
    // Newton: pin and weight give the acceleration.
    CHECK((pin.force + mechanism.gravity - state.a.head<2>()).norm() < 1e-12 * g);
  }
}

TEST_CASE("simple pendulum: the error falls with the tolerance") {
  const Eigen::Vector2d at_10(-0.27508746257611686, -0.96141920509912506);
  double before = 1.0;
  const Mechanism mechanism = charts::simple_pendulum();
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    FreeSolver solver(mechanism, tolerance);
    const State first = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
    const double error = (solver.advance(10.0, first).q.head<2>() - at_10).norm();
    INFO("tolerance " << tolerance << ": " << error);
    CHECK(error < 0.1 * before);
    before = error;
  }
}

TEST_CASE("constraint drift grows without projection and not with it") {
  // Negative control: the accelerations alone hold the constraint only as well as the integrator
  // holds its tolerance, and worse the longer it runs.
  const double short_run = unprojected_residual(1e-8, 10.0);
  const double long_run = unprojected_residual(1e-8, 100.0);
  INFO("without projection: " << short_run << " after 10 s, " << long_run << " after 100 s");
  CHECK(short_run > 1e-11);
  CHECK(long_run > 5.0 * short_run);

  const Mechanism mechanism = charts::simple_pendulum();
  FreeSolver solver(mechanism, 1e-8);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  double worst = 0.0;
  for (int i = 1; i <= 1000; ++i) {
    state = solver.advance(0.1 * i, state);
    worst = std::max(worst, state.residual);
    // The velocity is along the circle as well.
    worst = std::max(worst, std::abs(state.q.head<2>().dot(state.v.head<2>())));
  }
  INFO("with projection: " << worst);
  CHECK(worst < 1e-13);
}

TEST_CASE("mass and spring: free oscillation") {
  // x = A cos(omega t) + v/omega sin(omega t), omega^2 = k/m.
  const double m = 2.5, k = 400.0, A = 0.1, v = 0.7;
  const double omega = std::sqrt(k / m);
  Mechanism mechanism = block(m, A, v);
  mechanism.forces = {spring_to_wall(k, 0.0)};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  double worst = 0.0;
  for (int i = 1; i <= 50; ++i) {
    state = solver.advance(0.1 * i, state);
    const double t = state.time;
    const double x = A * std::cos(omega * t) + v / omega * std::sin(omega * t);
    const double rate = -A * omega * std::sin(omega * t) + v * std::cos(omega * t);
    worst = std::max({worst, std::abs(state.q[0] - x), std::abs(state.v[0] - rate) / omega,
                      std::abs(state.a[0] + omega * omega * x) / (omega * omega)});
    CHECK(state.lambda[0] == Approx(-m * g).epsilon(1e-12));
  }
  INFO("largest error " << worst);
  CHECK(worst < 3e-10);
}

TEST_CASE("mass, spring and damper: decaying oscillation") {
  // x = e^(-delta t) (A cos(w t) + (v + delta A)/w sin(w t)), delta = c/2m, w^2 = k/m - delta^2.
  const double m = 2.5, k = 400.0, c = 9.0, A = 0.1, v = 0.7;
  const double delta = c / (2.0 * m);
  const double w = std::sqrt(k / m - delta * delta);
  Mechanism mechanism = block(m, A, v);
  mechanism.forces = {spring_to_wall(k, c)};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  double worst = 0.0;
  for (int i = 1; i <= 30; ++i) {
    state = solver.advance(0.1 * i, state);
    const double t = state.time;
    const double B = (v + delta * A) / w;
    const double x = std::exp(-delta * t) * (A * std::cos(w * t) + B * std::sin(w * t));
    const double rate =
        -delta * x + std::exp(-delta * t) * w * (B * std::cos(w * t) - A * std::sin(w * t));
    worst = std::max({worst, std::abs(state.q[0] - x), std::abs(state.v[0] - rate) / w});
  }
  INFO("largest error " << worst);
  CHECK(worst < 3e-10);
}

TEST_CASE("torsion pendulum: a wheel on a spring of turn") {
  // phi = phi_0 cos(omega t), omega^2 = c/J.
  const double J = 0.3, c = 50.0, phi_0 = 2.0;
  Mechanism mechanism;
  mechanism.bodies = {Body{"wheel", 1.0, J, {}, {{0.0, 0.0}, phi_0}}};
  mechanism.joints = {{"axle", Pin{{0}, {ground}}}};
  mechanism.forces = {{"spring", TorsionSpring{{0}, {ground}, c, 0.0, 0.0}}};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  for (int i = 1; i <= 30; ++i) {
    state = solver.advance(0.1 * i, state);
    CHECK(std::abs(state.q[2] - phi_0 * std::cos(std::sqrt(c / J) * state.time)) < 1e-9);
  }
}

TEST_CASE("mass and spring driven by a harmonic force") {
  // From rest: x = F/(m (omega^2 - W^2)) (sin(W t) - W/omega sin(omega t)).
  const double m = 2.5, k = 400.0, F = 30.0, W = 9.0;
  const double omega = std::sqrt(k / m);
  Mechanism mechanism = block(m, 0.0, 0.0);
  mechanism.forces = {spring_to_wall(k, 0.0),
                      {"shaker", PointForce{{0}, 0.0, false, HarmonicDriver{0.0, F, W, 0.0, {}}}}};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  double worst = 0.0;
  for (int i = 1; i <= 50; ++i) {
    state = solver.advance(0.1 * i, state);
    const double t = state.time;
    const double x =
        F / (m * (omega * omega - W * W)) * (std::sin(W * t) - W / omega * std::sin(omega * t));
    worst = std::max(worst, std::abs(state.q[0] - x));
  }
  INFO("largest error " << worst);
  CHECK(worst < 3e-10);
}

TEST_CASE("a block on a plane is slowed by Coulomb friction") {
  // v = v_0 - mu g t, x = v_0 t - mu g t^2/2; with a tiny creep velocity up to (creep/v)^2/2.
  const double mu = 0.3, v_0 = 3.0;
  const Mechanism mechanism = block(7.0, 0.0, v_0, Friction{mu, 0.0, 1e-6, 0.0});
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  const double stop = v_0 / (mu * g);
  double worst = 0.0;
  for (int i = 1; i <= 9; ++i) {
    state = solver.advance(0.1 * i * stop, state);
    const double t = state.time;
    worst = std::max({worst, std::abs(state.v[0] - (v_0 - mu * g * t)),
                      std::abs(state.q[0] - (v_0 * t - 0.5 * mu * g * t * t)),
                      std::abs(state.a[0] + mu * g)});
    // The reaction holds the friction: -mu times the weight along the plane.
    const Reaction plane = reactions_of(mechanism, state).front();
    CHECK((plane.force - Eigen::Vector2d(-mu, 1.0) * 7.0 * g).norm() < 1e-9 * 7.0 * g);
  }
  INFO("largest error " << worst);
  CHECK(worst < 1e-10);
}

TEST_CASE("a block on an incline, with Coulomb and viscous friction") {
  // m v' = m g (sin a - mu cos a) - c v: v = v_e (1 - e^(-c t/m)) from rest; it starts sliding as
  // soon as the creep velocity is passed.
  const double m = 3.0, mu = 0.2, c = 4.0, slope = 0.5, v_0 = 0.1;
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  const Eigen::Vector2d down(std::cos(-slope), std::sin(-slope));
  mechanism.bodies = {
      Body{"block", m, 0.4, {}, {{0.0, 0.0}, -slope}, {v_0 * down.x(), v_0 * down.y(), 0.0}}};
  mechanism.joints = {
      {"line", Slider{{0}, {ground, {0.0, 0.0}}, -slope, -slope, Friction{mu, c, 1e-7, 0.0}}}};
  FreeSolver solver(mechanism);
  State state = solver.start(0.0, sketch_of(mechanism), start_velocity_of(mechanism));
  const double v_end = m * g * (std::sin(slope) - mu * std::cos(slope)) / c;
  for (int i = 1; i <= 10; ++i) {
    state = solver.advance(0.2 * i, state);
    const double decay = std::exp(-c * state.time / m);
    const double v = v_end + (v_0 - v_end) * decay;
    const double x = v_end * state.time + (v_0 - v_end) * m / c * (1.0 - decay);
    CHECK(std::abs(state.v.head<2>().dot(down) - v) < 1e-9);
    CHECK(std::abs(state.q.head<2>().dot(down) - x) < 1e-9);
  }
}

}  // namespace pendulum_test
