#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"

/// Small mechanisms in space, and balances that hold in every one of them.
namespace test {

namespace spatial_balance_names {
using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Matrix3d;
using Eigen::Vector3d;

inline Joint joint_of(const char* name, JointKind kind, int parent, const Vector3d& at,
                      const Vector3d& axis) {
  Joint joint;
  joint.name = name;
  joint.kind = kind;
  joint.parent = parent;
  joint.at = at;
  joint.axis = axis.normalized();
  return joint;
}

/// Adds a body without mass whose origin is at the joint; its index.
inline int add(Mechanism& mechanism, Joint joint, bool free) {
  joint.moved_by = free ? MovedBy::loops : MovedBy::driver;
  mechanism.bodies.emplace_back().name = joint.name;
  mechanism.joints.push_back(std::move(joint));
  return static_cast<int>(mechanism.bodies.size()) - 1;
}

inline ClosingJoint closing(const char* name, ClosingKind kind, const Attachment& a,
                            const Attachment& b) {
  ClosingJoint joint;
  joint.name = name;
  joint.kind = kind;
  joint.a = a;
  joint.b = b;
  return joint;
}

/// What every joint does to the bodies that it connects, each body's momentum, and the powers.
/// Nothing here goes along a chain: each body is looked at by itself.
struct Balance {
  double force = 0.0, moment = 0.0;  ///< largest of any body that is left over
  double power = 0.0;  ///< of drives, friction, loads and gravity, less the change of energy
  double size = 0.0;
};

inline Balance balance_of(const Chain& chain, const State& state) {
  const Mechanism& mechanism = chain.mechanism();
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  const std::vector<double> friction = chain.friction_by_joint(state);
  const std::size_t bodies = mechanism.bodies.size();
  std::vector<Wrench> left(bodies);  // about the world's origin
  Balance balance;
  const auto act = [&](int on, const Vector3d& place, const Wrench& wrench) {
    if (on == ground) return;
    left[static_cast<std::size_t>(on)].force += wrench.force;
    left[static_cast<std::size_t>(on)].moment += wrench.moment + place.cross(wrench.force);
  };
  const auto both = [&](int on, int other, const Vector3d& place, const Wrench& wrench) {
    act(on, place, wrench);
    act(other, place, {-wrench.force, -wrench.moment});
    balance.size = std::max({balance.size, wrench.force.norm(), wrench.moment.norm()});
  };
  for (std::size_t i = 0; i < bodies; ++i) {
    const Joint& joint = mechanism.joints[i];
    both(static_cast<int>(i), joint.parent, state.bodies[i].joint, joints[i]);
    const Vector3d axis = in_world(state, joint.parent, joint.axis);
    double along =
        axis.dot(joint.kind == JointKind::prismatic ? joints[i].force : joints[i].moment);
    if (joint.kind == JointKind::screw)
      along += joint.lead / (2.0 * std::numbers::pi) * axis.dot(joints[i].force);
    if (joint.kind == JointKind::fixed) continue;
    // Nothing but friction is along an axis that no driver moves.
    if (!is_driven(joint)) balance.moment = std::max(balance.moment, std::abs(along - friction[i]));
    balance.power += along * state.coordinates[i].rate;
  }
  for (std::size_t k = 0; k < mechanism.closing.size(); ++k) {
    const ClosingJoint& joint = mechanism.closing[k];
    const bool teeth = joint.kind == ClosingKind::gear || joint.kind == ClosingKind::rack;
    const Vector3d place = position_of(state, teeth ? joint.mesh.at : joint.b);
    both(joint.b.body, joint.a.body, place, joints[bodies + k]);
    // The place on b stays on the line through that on a.
    if (friction[bodies + k] != 0.0)
      balance.power += friction[bodies + k] *
                       in_world(state, joint.a.body, joint.axis)
                           .dot(velocity_of(state, joint.b) - velocity_of(state, joint.a));
    if (joint.kind != ClosingKind::distance) continue;
    const Vector3d along = (place - position_of(state, joint.a)).normalized();
    balance.power += along.dot(joints[bodies + k].force) * driver_at(joint.length, state.time).rate;
  }
  for (const AppliedLoad& load : mechanism.loads) {
    const Vector3d vector =
        driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
    const Vector3d place = position_of(state, load.at);
    const spatial::BodyMotion& on = state.bodies[static_cast<std::size_t>(load.on)];
    if (load.kind == LoadKind::couple) {
      act(load.on, place, {Vector3d::Zero(), vector});
      balance.power += vector.dot(on.omega);
    } else {
      act(load.on, place, {vector, Vector3d::Zero()});
      balance.power += vector.dot(on.velocity + on.omega.cross(place - on.position));
    }
  }
  for (const Spring& spring : mechanism.springs) {
    const Vector3d a = position_of(state, spring.a), b = position_of(state, spring.b);
    const double length = (b - a).norm();
    const double rate =
        (b - a).dot(velocity_of(state, spring.b) - velocity_of(state, spring.a)) / length;
    double tension = spring.stiffness * (length - spring.free_length) + spring.damping * rate;
    const double longer = length - spring.free_length;
    if (spring.acts == Spring::Acts::pulling && (tension < 0.0 || longer < 0.0)) tension = 0.0;
    if (spring.acts == Spring::Acts::pushing && (tension > 0.0 || longer > 0.0)) tension = 0.0;
    act(spring.a.body, a, {tension / length * (b - a), Vector3d::Zero()});
    act(spring.b.body, b, {tension / length * (a - b), Vector3d::Zero()});
    balance.power -= tension * rate;
  }
  for (std::size_t i = 0; i < bodies; ++i) {
    const spatial::Body& body = mechanism.bodies[i];
    const spatial::BodyMotion& motion = state.bodies[i];
    const Attachment centre{static_cast<int>(i), body.centre};
    const Vector3d force = body.mass * (acceleration_of(state, centre) - mechanism.gravity);
    const Matrix3d inertia = motion.R_WB * body.inertia * motion.R_WB.transpose();
    const Vector3d spin = inertia * motion.alpha + motion.omega.cross(inertia * motion.omega);
    balance.power -= force.dot(velocity_of(state, centre)) + spin.dot(motion.omega);
    balance.force = std::max(balance.force, (left[i].force - force).norm());
    balance.moment = std::max(
        balance.moment, (left[i].moment - spin - position_of(state, centre).cross(force)).norm());
  }
  return balance;
}

inline void check_balance(const Chain& chain, double time, double tolerance = 1e-10) {
  const State state = chain.at(time);
  const Balance balance = balance_of(chain, state);
  INFO("t = " << time << ", forces up to " << balance.size);
  CHECK(balance.force <= tolerance * balance.size);
  CHECK(balance.moment <= tolerance * balance.size);
  CHECK(std::abs(balance.power) <= 10.0 * tolerance * balance.size);
}

inline void set_mass(spatial::Body& body, double mass, const Vector3d& centre,
                     const Vector3d& inertia) {
  body.mass = mass;
  body.centre = centre;
  body.inertia = inertia.asDiagonal();
}

}  // namespace spatial_balance_names

using spatial_balance_names::add;
using spatial_balance_names::check_balance;
using spatial_balance_names::closing;
using spatial_balance_names::joint_of;
using spatial_balance_names::set_mass;

}  // namespace test
