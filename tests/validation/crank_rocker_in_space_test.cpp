// A crank and a rocker in space with a rod between balls (RSSR), by the closed form of the rod's
// length.

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace crank_rocker_in_space_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;
using test::add;
using test::check_balance;
using test::closing;
using test::joint_of;
using test::set_mass;

TEST_CASE("A crank and a rocker in space follow the closed form of their rod's length") {
  // Crank of radius 0.3 m about z, rocker of radius 0.7 m about a line parallel to x at (0, 1, 0.2)
  // m, rod 1.1 m between balls: (b - c)^2 = l^2 is A cos psi + B sin psi = C.
  constexpr double r = 0.3, R = 0.7, l = 1.1;
  const Vector3d pivot(0.1, 1.0, 0.2);
  Mechanism mechanism;
  mechanism.gravity = {0.0, -9.81, 0.0};
  Joint crank = joint_of("crank", JointKind::revolute, ground, Vector3d::Zero(), Vector3d::UnitZ());
  crank.driver = HarmonicDriver{0.2, 1.5, 2.0, 0.3, {}};
  const int a = add(mechanism, crank, false);
  const int b = add(
      mechanism, joint_of("rocker", JointKind::revolute, ground, pivot, Vector3d::UnitX()), true);
  mechanism.joints.back().start = 0.5;
  mechanism.closing.push_back(
      closing("rod", ClosingKind::distance, {a, {r, 0.0, 0.0}}, {b, {0.0, 0.0, R}}));
  mechanism.closing.back().length = PolynomialDriver{{l}};
  set_mass(mechanism.bodies[0], 3.0, {0.1, 0.0, 0.0}, {0.01, 0.02, 0.03});
  set_mass(mechanism.bodies[1], 5.0, {0.0, 0.1, 0.3}, {0.4, 0.3, 0.2});
  const Chain chain(mechanism);
  const auto psi_at = [&](double time) {
    const double phi = driver_at(mechanism.joints[0].driver, time).value;
    const Vector3d d = Vector3d(r * std::cos(phi), r * std::sin(phi), 0.0) - pivot;
    // c - pivot = R (0, -sin psi, cos psi)
    const double A = d.z(), B = -d.y();
    const double C = (d.squaredNorm() + R * R - l * l) / (2.0 * R);
    const double one = std::atan2(B, A), turn = std::acos(C / std::hypot(A, B));
    return std::pair(one + turn, one - turn);  // the two branches
  };
  const auto [plus, minus] = psi_at(0.0);
  const double start = chain.at(0.0).coordinates[1].value;
  const bool is_plus = std::abs(std::remainder(start - plus, full_turn)) <
                       std::abs(std::remainder(start - minus, full_turn));
  const auto exact = [&](double time) {
    const auto both = psi_at(time);
    return is_plus ? both.first : both.second;
  };
  for (int i = 0; i <= 60; ++i) {
    const double time = 0.05 * i + 0.01, h = 1e-4;
    const State state = chain.at(time);
    CHECK(std::abs(std::remainder(state.coordinates[1].value - exact(time), full_turn)) < 1e-12);
    const double rate = std::remainder(exact(time + h) - exact(time - h), full_turn) / (2.0 * h);
    CHECK(state.coordinates[1].rate == Approx(rate).margin(1e-6));
    const double acceleration = (std::remainder(exact(time + h) - exact(time), full_turn) -
                                 std::remainder(exact(time) - exact(time - h), full_turn)) /
                                (h * h);
    CHECK(state.coordinates[1].acceleration == Approx(acceleration).margin(1e-5));
    check_balance(chain, time);
  }
}

}  // namespace crank_rocker_in_space_test
