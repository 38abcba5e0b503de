#pragma once

#include <limits>

namespace boxbeam::planar {

/// A joint that gives way where it holds, with viscous damping beside its stiffness; the motion of
/// rigid bodies knows nothing of it. Infinite: it does not give way.
struct ElasticJoint {
  int joint = 0;  ///< index in the mechanism
  /// In every direction in which it keeps a place, or along what keeps a distance [N/m, N s/m].
  double stiffness = std::numeric_limits<double>::infinity(), damping = 0.0;
  /// Against turning where it keeps an angle [N m/rad, N m s/rad].
  double turning_stiffness = std::numeric_limits<double>::infinity(), turning_damping = 0.0;

  friend bool operator==(const ElasticJoint&, const ElasticJoint&) = default;
};

}  // namespace boxbeam::planar
