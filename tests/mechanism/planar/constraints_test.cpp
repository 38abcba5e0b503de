// The constraint equations and their derivatives, by central differences and by hand.

#include "boxbeam/mechanism/planar/constraints.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

namespace constraints_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

/// Every kind of joint and driver there is, on three bodies; not a mechanism that moves.
Mechanism all_joints() {
  Mechanism mechanism;
  mechanism.bodies.resize(3);
  const Attachment p0{0, {0.3, -0.2}};
  const Attachment p1{1, {-0.4, 0.1}};
  const Attachment p2{2, {0.2, 0.5}};
  const HarmonicDriver driver{0.2, 0.3, 4.0, 0.5, {{0.1, 9.0, 0.2}}};
  mechanism.joints = {
      {"pin", Pin{p0, p1}},
      {"ground pin", Pin{{ground, {1.0, 2.0}}, p2}},
      {"slider", Slider{p1, {ground, {0.1, 0.2}}, 0.7, 0.3}},
      {"coupling", AngleCoupling{{0}, {2}, 1.5, 0.2}},
      {"x", Driven{p0, Coordinate::x, driver}},
      {"y", Driven{p2, Coordinate::y, driver}},
      {"angle", Driven{{1}, Coordinate::angle, driver}},
      {"moving slider", Slider{p1, p0, 0.4, -0.3}},
      {"slot", PinInSlot{p2, p1, -0.6}},
      {"pin of the ground in a slot", PinInSlot{{ground, {0.3, 0.4}}, p1, -0.6}},
      {"rigid", Rigid{p0, p2, 0.8}},
      {"distance", Distance{p0, p1, 1.3}},
      {"distance from the ground", Distance{{ground, {3.0, -1.0}}, p1, 0.7}},
      {"gear", Gear{p0, p1, 0.3, 0.5, 0.1}},
      {"annulus", Gear{p2, {ground, {0.4, 0.3}}, 0.3, -0.9, 0.0}},
      {"rack", Rack{p0, p2, 0.5, 0.2, 0.1}},
      {"relative angle", Driven{p0, Coordinate::angle, driver, p2}},
      {"length", Driven{p0, Coordinate::length, StepDriver{1.0, 2.0, 0.1, 0.9}, p2}},
      {"rate", Driven{{2}, Coordinate::angle, RateDriver{0.3, 2.0}}},
      {"polynomial", Driven{{2}, Coordinate::angle, PolynomialDriver{{0.3, 2.0, -1.0, 0.5}}}}};
  return mechanism;
}

Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(random); });
}

Eigen::VectorXd phi_at(const Mechanism& mechanism, double time, const Eigen::VectorXd& q) {
  ConstraintEquations equations(mechanism);
  equations.set_time(time);
  equations.set_position(q);
  Eigen::VectorXd phi(equations.rows());
  equations.evaluate(phi);
  return phi;
}

}  // namespace

TEST_CASE("the Jacobian is the central difference of the constraints") {
  const Mechanism mechanism = all_joints();
  std::mt19937 random(1);
  ConstraintEquations equations(mechanism);
  equations.set_time(0.3);
  Eigen::VectorXd phi(equations.rows());
  std::vector<double> values;
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd q = random_vector(9, random);
    equations.set_position(q);
    equations.evaluate(phi, values);
    const Eigen::MatrixXd jacobian = equations.pattern().dense(values);
    CHECK((phi - phi_at(mechanism, 0.3, q)).norm() == 0.0);
    const double h = 1e-5;
    for (Eigen::Index k = 0; k < 9; ++k) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(9, k);
      const Eigen::VectorXd difference =
          (phi_at(mechanism, 0.3, q + step) - phi_at(mechanism, 0.3, q - step)) / (2.0 * h);
      CHECK((difference - jacobian.col(k)).lpNorm<Eigen::Infinity>() < 1e-8);
    }
  }
}

TEST_CASE("the right sides are the time derivatives of the constraints along a motion") {
  // q(t) = q + v t + a t^2/2: dPhi/dt = J v - nu, d2Phi/dt2 = J a - gamma, at any q, v, a.
  const Mechanism mechanism = all_joints();
  std::mt19937 random(2);
  ConstraintEquations equations(mechanism);
  const Eigen::Index rows = equations.rows();
  Eigen::VectorXd phi(rows), nu(rows), gamma(rows);
  std::vector<double> values;
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd q = random_vector(9, random);
    const Eigen::VectorXd v = random_vector(9, random);
    const Eigen::VectorXd a = random_vector(9, random);
    const double time = 0.4;
    const auto along = [&](double dt) {
      return phi_at(mechanism, time + dt, q + dt * v + 0.5 * dt * dt * a);
    };
    equations.set_time(time);
    equations.set_position(q);
    equations.evaluate(phi, values);
    const Eigen::MatrixXd jacobian = equations.pattern().dense(values);
    equations.velocity_right_side(nu);
    equations.acceleration_right_side(v, gamma);
    const double h = 1e-4;
    const Eigen::VectorXd first = (along(h) - along(-h)) / (2.0 * h);
    const Eigen::VectorXd second_derivative = (along(h) - 2.0 * along(0.0) + along(-h)) / (h * h);
    CHECK((first - (jacobian * v - nu)).lpNorm<Eigen::Infinity>() < 1e-5);
    CHECK((second_derivative - (jacobian * a - gamma)).lpNorm<Eigen::Infinity>() < 1e-4);
  }
}

TEST_CASE("a position reached by small moves is evaluated as one that is set") {
  const Mechanism mechanism = all_joints();
  std::mt19937 random(4);
  ConstraintEquations moved(mechanism);
  moved.set_time(0.3);
  Eigen::VectorXd phi(moved.rows());
  for (const double size : {1e-12, 1e-6, 9e-4, 0.3}) {
    Eigen::VectorXd q = random_vector(9, random);
    moved.set_position(q);
    for (int i = 0; i < 3; ++i) {
      q += 0.5 * size * random_vector(9, random);
      moved.move_position(q);
    }
    moved.evaluate(phi);
    CHECK((phi - phi_at(mechanism, 0.3, q)).lpNorm<Eigen::Infinity>() < 5e-15);
  }
}

TEST_CASE("a point's velocity and acceleration are derivatives of its position") {
  std::mt19937 random(3);
  const Attachment point{0, {0.7, -0.4}};
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd q = random_vector(3, random);
    const Eigen::VectorXd v = random_vector(3, random);
    const Eigen::VectorXd a = random_vector(3, random);
    const auto along = [&](double dt) -> Eigen::Vector2d {
      return position_of(point, q + dt * v + 0.5 * dt * dt * a);
    };
    const double h = 1e-4;
    CHECK(((along(h) - along(-h)) / (2.0 * h) - velocity_of(point, q, v)).norm() < 1e-6);
    CHECK(((along(h) - 2.0 * along(0.0) + along(-h)) / (h * h) - acceleration_of(point, q, v, a))
              .norm() < 1e-5);
  }
}

TEST_CASE("a point of the ground does not move") {
  const Attachment fixed{ground, {1.0, 2.0}};
  const Eigen::VectorXd q = Eigen::VectorXd::Ones(3);
  CHECK(position_of(fixed, q) == Eigen::Vector2d(1.0, 2.0));
  CHECK(velocity_of(fixed, q, q).norm() == 0.0);
  CHECK(acceleration_of(fixed, q, q, q).norm() == 0.0);
}

}  // namespace constraints_test
