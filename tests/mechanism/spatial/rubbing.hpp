#pragma once

#include <cmath>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/friction.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

/// What joints that slide in space rub by, worked out anew of what they carry.
namespace rubbing {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

inline constexpr double g = 9.81;

inline int add(Mechanism& mechanism, const char* name, JointKind kind, int parent,
               const Vector3d& at, const Vector3d& axis, MovedBy moved_by) {
  const int body = test::add(mechanism, test::joint_of(name, kind, parent, at, axis), false);
  mechanism.joints.back().moved_by = moved_by;
  return body;
}

/// The contact forces at both ends of a guide, by its wrench: N/2 and the pair whose couple is the
/// part of M across the guide, a/2 x F l - a/2 x (-F) l.
inline double pressure_by_ends(const Wrench& wrench, const Vector3d& a, double l) {
  const Vector3d N = wrench.force - a.dot(wrench.force) * a;
  if (l == 0.0) return N.norm();
  const Vector3d M = wrench.moment - a.dot(wrench.moment) * a;
  Vector3d F = M.cross(a) / l;
  REQUIRE((l * a.cross(F) - M).norm() <= 1e-12 * (1.0 + M.norm()));
  return (0.5 * N + F).norm() + (0.5 * N - F).norm();
}

/// Every contact's friction by what its joint carries; how many rub.
inline int check_laws(const Chain& chain, double time) {
  const Mechanism& mechanism = chain.mechanism();
  const State state = chain.at(time);
  const std::vector<Wrench> joints = chain.joint_wrenches(state);
  REQUIRE(state.friction.size() == chain.contacts().size());
  int rubbing = 0;
  for (std::size_t j = 0; j < chain.contacts().size(); ++j) {
    const std::size_t joint = chain.contacts()[j].joint;
    const Friction& law = chain.contacts()[j].law;
    double v = 0.0;
    Vector3d a;
    if (joint < mechanism.joints.size()) {
      v = state.coordinates[joint].rate;
      a = in_world(state, mechanism.joints[joint].parent, mechanism.joints[joint].axis);
    } else {
      const ClosingJoint& closing = mechanism.closing[joint - mechanism.joints.size()];
      a = in_world(state, closing.a.body, closing.axis);
      v = a.dot(velocity_of(state, closing.b) - velocity_of(state, closing.a));
    }
    const double P = pressure_by_ends(joints[joint], a, law.guide);
    const double expected = -law.coulomb * P * v / std::hypot(v, law.creep) - law.viscous * v;
    CHECK(state.friction[j] == Approx(expected).epsilon(1e-9).margin(1e-10));
    if (std::abs(expected) > 1e-6) ++rubbing;
  }
  return rubbing;
}

}  // namespace rubbing
