#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The force along the beam that comes in between its ends at one place and is largest over a
/// quarter of its section, where it is more than 0.3 of what that bears: by which plates it comes
/// in, and how far it needs to spread to all of the section, no check knows. Of sections of plates;
/// what comes in at one station from both sides counts by its sum. Source: EN 1993-1-5:2006, 3.2.3.
std::vector<NotJudged> axial_forces_not_judged(const Project& project,
                                               const std::deque<SituationRun>& runs);

}  // namespace boxbeam
