#pragma once

#include <variant>
#include <vector>

#include "boxbeam/verification/chain_motion_result.hpp"
#include "boxbeam/verification/flexible_motion_result.hpp"
#include "boxbeam/verification/motion_result.hpp"

namespace boxbeam {

/// The motion of a mechanism alone, of whichever kind.
using AnyMotionResult = std::variant<MotionResult, ChainMotionResult, FlexibleMotionResult>;

/// The motion of a case's mechanism at the given times [s], or where none is given at times of its
/// own; world axes. Throws what FrontEnd::motion throws.
AnyMotionResult any_motion_of(const Project& project, const std::vector<double>& times);

}  // namespace boxbeam
