#pragma once

#include <Eigen/Core>

#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"

namespace boxbeam::planar {

/// Multipliers that are unique in one position may be shared in another: unique is what is so in
/// this position as well, repeating what repeats in either. A position that is singular itself says
/// nothing.
void judge_uniqueness(const Mechanism& mechanism, const Eigen::VectorXd& q,
                      DegreesOfFreedom& freedom);

}  // namespace boxbeam::planar
