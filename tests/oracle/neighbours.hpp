#pragma once

#include <deque>
#include <vector>

#include "beside.hpp"
#include "life.hpp"
#include "oracle.hpp"

namespace oracle {

/// Pins, their plates and rods of mechanisms in the plane and in space. The reactions of the joints
/// are the program's; rods in space are those without mass.
void look_at_neighbours(const Project& project, const std::deque<SituationRun>& runs,
                        const std::vector<Run>& sampled, const Life& life, Findings& found);

}  // namespace oracle
