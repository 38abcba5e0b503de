#pragma once

#include <limits>

#include "boxbeam/mechanism/spatial/mechanism.hpp"

namespace boxbeam::spatial {

/// A joint in space that gives way where it holds, with viscous damping beside its stiffness; the
/// motion of rigid bodies knows nothing of it, and its drive does not give way. Infinite: rigid.
struct ElasticJoint {
  /// What it holds, whether it closes a loop or carries a body, by several movements as well.
  ClosingKind kind = ClosingKind::fixed;
  /// In every direction in which it keeps a place, of a screw along its axis too [N/m, N s/m].
  double stiffness = std::numeric_limits<double>::infinity(), damping = 0.0;
  /// About every axis about which it keeps from turning [N m/rad, N m s/rad].
  double turning_stiffness = std::numeric_limits<double>::infinity(), turning_damping = 0.0;

  friend bool operator==(const ElasticJoint&, const ElasticJoint&) = default;
};

}  // namespace boxbeam::spatial
