#pragma once

#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/motion_summary.hpp"

namespace boxbeam {

/// Supports of a frame on which it may only lie, and that at some instant hold it down: they count
/// in either sense, which what only lies on them does not bear. These are rollers, and where there
/// are any, hinges that push at other instants. Down is where gravity points; without gravity, of
/// the axis upwards in the world, against what all supports together bear most. Nothing below 1e-3
/// of the largest force of a support.
std::vector<NotJudged> lifted_supports_of(const Project& project,
                                          const std::vector<MotionSummary>& motions);

}  // namespace boxbeam
