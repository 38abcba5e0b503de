#pragma once

#include <Eigen/Core>

#include "boxbeam/mechanism/flexible/structure.hpp"

namespace boxbeam::flexible {

/// M q of one rigid element: force and couple of its inertia about its node, per omega^2. `q`:
/// along x, along y, turn.
template <class Motion>
Eigen::Matrix<typename Motion::Scalar, 3, 1> mass_times(const RigidElement& of, const Motion& q) {
  const Eigen::Vector2d& S = of.first_moment;
  return {of.mass * q[0] - S.y() * q[2], of.mass * q[1] + S.x() * q[2],
          S.x() * q[1] - S.y() * q[0] + of.inertia * q[2]};
}

}  // namespace boxbeam::flexible
