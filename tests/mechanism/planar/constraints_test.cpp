// The constraint equations and their derivatives, by central differences and by hand.

#include "boxbeam/mechanism/planar/constraints.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

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
  const HarmonicDriver driver{0.2, 0.3, 4.0, 0.5};
  mechanism.joints = {{"pin", Pin{p0, p1}},
                      {"ground pin", Pin{{ground, {1.0, 2.0}}, p2}},
                      {"slider", Slider{p1, {0.1, 0.2}, 0.7, 0.3}},
                      {"coupling", AngleCoupling{{0}, {2}, 1.5, 0.2}},
                      {"x", Driven{p0, Coordinate::x, driver}},
                      {"y", Driven{p2, Coordinate::y, driver}},
                      {"angle", Driven{{1}, Coordinate::angle, driver}}};
  return mechanism;
}

Eigen::VectorXd random_vector(Eigen::Index size, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(random); });
}

Eigen::VectorXd phi_at(const Mechanism& mechanism, double time, const Eigen::VectorXd& q) {
  Eigen::VectorXd phi(mechanism.equations());
  evaluate_constraints(mechanism, time, q, phi);
  return phi;
}

}  // namespace

TEST_CASE("the Jacobian is the central difference of the constraints") {
  const Mechanism mechanism = all_joints();
  std::mt19937 random(1);
  Eigen::VectorXd phi(mechanism.equations());
  Eigen::MatrixXd jacobian(mechanism.equations(), mechanism.coordinates());
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd q = random_vector(9, random);
    evaluate_constraints(mechanism, 0.3, q, phi, jacobian);
    CHECK((phi - phi_at(mechanism, 0.3, q)).norm() == 0.0);
    const double h = 1e-5;
    for (Eigen::Index k = 0; k < 9; ++k) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(9, k);
      const Eigen::VectorXd difference =
          (phi_at(mechanism, 0.3, q + step) - phi_at(mechanism, 0.3, q - step)) / (2.0 * h);
      CHECK((difference - jacobian.col(k)).lpNorm<Eigen::Infinity>() < 1e-9);
    }
  }
}

TEST_CASE("the right sides are the time derivatives of the constraints along a motion") {
  // q(t) = q + v t + a t^2/2: dPhi/dt = J v - nu, d2Phi/dt2 = J a - gamma, at any q, v, a.
  const Mechanism mechanism = all_joints();
  std::mt19937 random(2);
  const Eigen::Index rows = mechanism.equations();
  Eigen::VectorXd phi(rows), nu(rows), gamma(rows);
  Eigen::MatrixXd jacobian(rows, 9);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd q = random_vector(9, random);
    const Eigen::VectorXd v = random_vector(9, random);
    const Eigen::VectorXd a = random_vector(9, random);
    const double time = 0.4;
    const auto along = [&](double dt) {
      return phi_at(mechanism, time + dt, q + dt * v + 0.5 * dt * dt * a);
    };
    evaluate_constraints(mechanism, time, q, phi, jacobian);
    velocity_right_side(mechanism, time, nu);
    acceleration_right_side(mechanism, time, q, v, gamma);
    const double h = 1e-4;
    const Eigen::VectorXd first = (along(h) - along(-h)) / (2.0 * h);
    const Eigen::VectorXd second_derivative = (along(h) - 2.0 * along(0.0) + along(-h)) / (h * h);
    CHECK((first - (jacobian * v - nu)).lpNorm<Eigen::Infinity>() < 1e-5);
    CHECK((second_derivative - (jacobian * a - gamma)).lpNorm<Eigen::Infinity>() < 1e-4);
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
