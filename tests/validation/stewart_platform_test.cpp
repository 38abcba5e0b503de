// A platform on six cylinders.

#include <Eigen/Geometry>
#include <cmath>
#include <utility>
#include <vector>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace stewart_platform_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::add;
using test::check_balance;
using test::closing;
using test::joint_of;
using test::set_mass;

TEST_CASE("Six cylinders hold a platform where their lengths say") {
  // The lengths follow from the platform's motion, and the motion from the lengths.
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -9.81};
  int body = ground;
  for (int k = 0; k < 3; ++k)
    body = add(mechanism,
               joint_of("shift", JointKind::prismatic, body, Vector3d::Zero(), Vector3d::Unit(k)),
               true);
  for (int k = 2; k >= 0; --k)
    body =
        add(mechanism,
            joint_of("turn", JointKind::revolute, body, Vector3d::Zero(), Vector3d::Unit(k)), true);
  mechanism.joints[2].start = 0.9;
  set_mass(mechanism.bodies.back(), 200.0, {0.02, -0.05, 0.1}, {12.0, 15.0, 20.0});
  // About it the lengths are polynomials of degree five through the motion's exact ones.
  const auto pose = [](double t) {
    return std::pair(rotation_about({0.1 * t, -0.2 * t * t, 0.3 * t}),
                     Vector3d(0.2 * t, 0.1 * t * t, 1.0 + 0.15 * t));
  };
  for (int leg = 0; leg < 6; ++leg) {
    const double at = full_turn / 6.0 * leg;
    const double low = at + (leg % 2 == 0 ? 0.35 : -0.35), high = at - (leg % 2 == 0 ? 0.2 : -0.2);
    const Vector3d base(1.2 * std::cos(low), 1.2 * std::sin(low), 0.0);
    const Vector3d top(0.7 * std::cos(high), 0.7 * std::sin(high), 0.0);
    ClosingJoint joint = closing("leg", ClosingKind::distance, {ground, base}, {body, top});
    const auto [R, p] = pose(0.4);
    joint.length = PolynomialDriver{{(p + R * top - base).norm()}};
    mechanism.closing.push_back(joint);
  }
  const Chain chain(mechanism);
  const State state = chain.at(0.0);
  const auto [R, p] = pose(0.4);
  CHECK((state.bodies.back().position - p).norm() < 1e-11);
  CHECK((state.bodies.back().R_WB - R).norm() < 1e-11);
  // At rest the six forces along the legs carry the weight: 6 equations of a free body.
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  Vector3d force = mechanism.gravity * 200.0, moment = Vector3d::Zero();
  const Vector3d centre = position_of(state, {body, mechanism.bodies.back().centre});
  for (std::size_t leg = 0; leg < 6; ++leg) {
    force += joints[6 + leg].force;
    moment += (position_of(state, mechanism.closing[leg].b) - centre).cross(joints[6 + leg].force);
    CHECK(joints[6 + leg].moment.norm() == 0.0);
  }
  CHECK(force.norm() < 1e-8);
  CHECK(moment.norm() < 1e-8);
  check_balance(chain, 0.0);
}

}  // namespace stewart_platform_test
