// Spinning bodies on trees of joints, against their closed forms: steady precession, the free
// symmetric top; and a free body of three different inertias, whose energy and angular momentum
// stay.

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"
#include "support/random_tree.hpp"

namespace spinning_body_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

constexpr double mass = 30.0;
constexpr double I_1 = 1.7;   // about the axle, z of the body
constexpr double I_2 = 0.95;  // across it

/// A body of revolution that turns about z of the world (precession), leans by a fixed angle and
/// spins about its own z: frame, frame, body.
Mechanism top(double precession, double lean, double spin) {
  Mechanism mechanism;
  mechanism.bodies.resize(3);
  mechanism.bodies[2].mass = mass;
  mechanism.bodies[2].inertia = Vector3d(I_2, I_2, I_1).asDiagonal();
  mechanism.joints.resize(3);
  for (int i = 0; i < 3; ++i) {
    Joint& joint = mechanism.joints[static_cast<std::size_t>(i)];
    joint.kind = JointKind::revolute;
    joint.parent = i - 1;
    joint.axis = i == 1 ? Vector3d::UnitX() : Vector3d::UnitZ();
  }
  mechanism.joints[0].driver = RateDriver{0.4, precession};
  mechanism.joints[1].driver = PolynomialDriver{{lean}};
  mechanism.joints[2].driver = RateDriver{-1.1, spin};
  return mechanism;
}

}  // namespace

TEST_CASE("a wheel spinning at w_2 on an axle that turns at w_1 across it: M = I_1 w_1 w_2") {
  // Meriam and Kraige, Engineering Mechanics: Dynamics, gyroscopic motion with steady precession.
  const double w_1 = 0.6, w_2 = 180.0;
  const Mechanism mechanism = top(w_1, std::acos(0.0), w_2);
  const Chain chain(mechanism);
  for (const double time : {0.0, 0.37, 2.0}) {
    const State state = chain.at(time);
    const std::vector<Wrench> joints = chain.joint_wrenches(state);
    const Vector3d axle = state.bodies[2].R_WB.col(2);
    const Vector3d moment = I_1 * w_1 * w_2 * Vector3d::UnitZ().cross(axle);
    CHECK((joints[2].moment - moment).norm() < 1e-13 * I_1 * w_1 * w_2);
    const InertiaLoad load = inertia_of(mechanism, state, 2);
    CHECK((load.gyroscopic + moment).norm() < 1e-13 * I_1 * w_1 * w_2);
    CHECK((load.moment + moment).norm() < 1e-13 * I_1 * w_1 * w_2);
    // The drives give no power: neither the turn nor the spin changes.
    CHECK(std::abs(joints[0].moment.z()) < 1e-13 * I_1 * w_1 * w_2);
    CHECK(std::abs(joints[2].moment.dot(axle)) < 1e-13 * I_1 * w_1 * w_2);
  }
}

TEST_CASE("steady precession of a leaning top: the moment about the line of nodes") {
  // M = w_p sin(b) (I_1 (w_s + w_p cos b) - I_2 w_p cos b): Meriam and Kraige, same chapter. The
  // gyroscopic part is that with the spin, I_1 w_s w_p sin b.
  for (const double lean : {0.2, 1.0, 2.0, 2.9}) {
    for (const double spin : {-40.0, 0.0, 3.0, 250.0}) {
      const double w_p = 1.3;
      const Mechanism mechanism = top(w_p, lean, spin);
      const Chain chain(mechanism);
      const State state = chain.at(0.8);
      const Vector3d nodes = state.bodies[1].R_WB.col(0);
      const double expected =
          w_p * std::sin(lean) * (I_1 * (spin + w_p * std::cos(lean)) - I_2 * w_p * std::cos(lean));
      const double size = 1e-13 * (std::abs(expected) + 1.0);
      CHECK((chain.joint_wrenches(state)[2].moment - expected * nodes).norm() < size);
      const InertiaLoad load = inertia_of(mechanism, state, 2);
      CHECK((load.moment + expected * nodes).norm() < size);
      CHECK((load.gyroscopic + I_1 * spin * w_p * std::sin(lean) * nodes).norm() < size);
    }
  }
}

TEST_CASE("a free symmetric top precesses about its angular momentum: no joint gives a moment") {
  // precession L/I_2, spin L cos(b) (1/I_1 - 1/I_2): Goldstein, Classical Mechanics, chapter 5.
  for (const double lean : {0.1, 0.9, 1.5, 2.6}) {
    const double L = 25.0;
    const Mechanism mechanism = top(L / I_2, lean, L * std::cos(lean) * (1.0 / I_1 - 1.0 / I_2));
    const Chain chain(mechanism);
    for (const double time : {0.0, 0.21, 1.7}) {
      const State state = chain.at(time);
      for (const Wrench& joint : chain.joint_wrenches(state)) {
        CHECK(joint.moment.norm() < 1e-13 * L * L / I_2);
        CHECK(joint.force.norm() < 1e-12);
      }
      const BodyMotion& body = state.bodies[2];
      const Vector3d momentum =
          body.R_WB * mechanism.bodies[2].inertia * body.R_WB.transpose() * body.omega;
      CHECK((momentum - L * Vector3d::UnitZ()).norm() < 1e-13 * L);
    }
  }
}

TEST_CASE("a free body of three inertias, integrated, keeps energy and angular momentum") {
  // Euler's equations by the module's inertia moment; Runge, Kutta and Munthe-Kaas of fourth order
  // on rotations: each step goes from R by the rotation about a vector u with
  // u' = omega - u x omega/2 + u x (u x omega)/12 (world axes). Spin about the middle axis, which
  // turns over again and again.
  Mechanism mechanism;
  test::Chance chance(51);
  const Eigen::Matrix3d axes = chance.rotation();
  const Vector3d principal(1.0, 2.0, 2.9);
  mechanism.bodies.resize(1);
  mechanism.bodies[0].mass = 1.0;
  mechanism.bodies[0].inertia = axes * principal.asDiagonal() * axes.transpose();
  mechanism.joints.resize(1);
  const Eigen::Matrix3d inertia = mechanism.bodies[0].inertia;

  State state = Chain(mechanism).at(0.0);
  BodyMotion& body = state.bodies[0];
  body.omega = axes * Vector3d(0.02, 2.5, 0.01);
  const auto momentum = [&]() -> Vector3d {
    return body.R_WB * inertia * body.R_WB.transpose() * body.omega;
  };
  const auto energy = [&] { return 0.5 * body.omega.dot(momentum()); };
  const Vector3d first_momentum = momentum();
  const double first_energy = energy();

  const double h = 0.5e-3;
  double worst = 0.0, lowest = 1.0;
  for (int step = 0; step < 20000; ++step) {
    const Eigen::Matrix3d R = body.R_WB;
    const Vector3d omega = body.omega;
    Vector3d u_sum = Vector3d::Zero(), omega_sum = Vector3d::Zero();
    Vector3d u_rate = Vector3d::Zero(), omega_rate = Vector3d::Zero();
    for (int stage = 0; stage < 4; ++stage) {
      const double to = stage == 0 ? 0.0 : stage == 3 ? h : 0.5 * h;
      const double weight = stage == 1 || stage == 2 ? h / 3.0 : h / 6.0;
      const Vector3d u = to * u_rate;
      body.R_WB = rotation_about(u) * R;
      body.omega = omega + to * omega_rate;
      body.alpha.setZero();
      // No joint moment: I alpha is what inertia puts on the body where alpha is zero.
      const Vector3d moment = inertia_of(mechanism, state, 0).moment;
      u_rate = body.omega - 0.5 * u.cross(body.omega) + u.cross(u.cross(body.omega)) / 12.0;
      omega_rate = body.R_WB * inertia.inverse() * body.R_WB.transpose() * moment;
      u_sum += weight * u_rate;
      omega_sum += weight * omega_rate;
    }
    body.R_WB = composed(rotation_about(u_sum), R);
    body.omega = omega + omega_sum;
    worst = std::max({worst, std::abs(energy() / first_energy - 1.0),
                      (momentum() - first_momentum).norm() / first_momentum.norm()});
    lowest = std::min(lowest, (body.R_WB * axes.col(1)).dot(first_momentum.normalized()));
  }
  CHECK(lowest < -0.9);  // it did turn over
  CHECK(worst < 1e-10);
}

}  // namespace spinning_body_test
