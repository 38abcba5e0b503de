#pragma once

#include "boxbeam/verification/neighbours.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// Sheet of a pin, of a lug, of a rod under tension or of one under compression.
Steps neighbour_steps(const Project& project, const NeighbourResult& result);

}  // namespace boxbeam::report
