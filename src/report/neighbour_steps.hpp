#pragma once

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/neighbours.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// A pin and its bearing; the last step is the factor.
Steps pin_steps(const Project& project, const NeighbourResult& result);

/// A rod under tension, and one under compression, likewise.
Steps pulled_rod_steps(const Project& project, const NeighbourResult& result);
Steps pressed_rod_steps(const Project& project, const NeighbourResult& result);

}  // namespace boxbeam::report
