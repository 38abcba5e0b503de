#pragma once

#include "support/spatial_balance.hpp"

namespace test {

/// The spatial slider-crank of the IFToMM library of computational benchmark problems: crank 0.08 m
/// about x at (0, 0.1, 0.12) m, rod 0.3 m, slider along x.
inline boxbeam::spatial::Mechanism spatial_slider_crank() {
  using namespace boxbeam;
  using namespace boxbeam::spatial;
  using Eigen::Matrix3d;
  using Eigen::Vector3d;
  Mechanism mechanism;
  mechanism.gravity = {0.0, 0.0, -9.81};
  Joint crank = joint_of("crank", JointKind::revolute, ground, {0.0, 0.1, 0.12}, Vector3d::UnitX());
  crank.driver = RateDriver{0.0, 6.0};
  const int on_crank = add(mechanism, crank, false);
  const int slider = add(
      mechanism,
      joint_of("slider", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX()), true);
  mechanism.joints.back().start = 0.25;
  // The rod, its x from the slider to the crank at the start; its universal joint turns about the
  // slider's x, then about k of the rod.
  const Vector3d along = Vector3d(-0.2, 0.1, 0.2) / 0.3;
  const Vector3d k = Vector3d(0.0, -2.0, 1.0).normalized();
  int rod = add(
      mechanism,
      joint_of("hook.1", JointKind::revolute, slider, Vector3d::Zero(), Vector3d::UnitX()), true);
  rod = add(mechanism, joint_of("hook.2", JointKind::revolute, rod, Vector3d::Zero(), k), true);
  mechanism.closing.push_back(
      closing("ball", ClosingKind::spherical, {on_crank, {0.0, 0.0, 0.08}}, {rod, 0.3 * along}));
  set_mass(mechanism.bodies[0], 0.12, {0.0, 0.0, 0.04}, {1e-4, 1e-4, 1e-5});
  set_mass(mechanism.bodies[1], 2.0, Vector3d::Zero(), {1e-4, 1e-4, 1e-4});
  spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(rod)];
  body.mass = 0.5;
  body.centre = 0.15 * along;
  body.inertia =
      4e-3 * (Matrix3d::Identity() - along * along.transpose()) + 4e-4 * along * along.transpose();
  return mechanism;
}

}  // namespace test
