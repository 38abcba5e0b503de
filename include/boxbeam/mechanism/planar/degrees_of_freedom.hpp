#pragma once

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// Freedom of the mechanism's joints, drivers left out.
struct DegreesOfFreedom {
  int gruebler = 0;   ///< 3 bodies - equations of the joints
  int by_rank = 0;    ///< 3 bodies - rank of their Jacobian in a position
  int redundant = 0;  ///< equations that repeat others: equations - rank
  int drivers = 0;
  double condition = 0.0;  ///< of the Jacobian with drivers, lengths scaled; 0 if not square
};

/// Rank by singular values of the Jacobian with lengths divided by the mechanism's size, so that
/// it does not depend on the unit of length; a value below 1e-9 of the largest counts as zero.
/// Source: Grübler (1917); Haug (1989), section 3.7.
DegreesOfFreedom degrees_of_freedom_of(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace boxbeam::planar
