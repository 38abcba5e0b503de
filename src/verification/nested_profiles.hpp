#pragma once

#include <deque>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Nested profiles count as one section; what ties them nobody describes. Where the outer one alone
/// would not bear all of N, M_y and M_z, by yield or by the details of the place in fatigue, what
/// ties the inner one to it stands with the verdict: at the ends of segments, and wherever
/// something comes onto the beam. Source: sigma = N/A + M/W of the outer profile alone.
void check_nested_profiles(const Project& project, const std::deque<SituationRun>& runs,
                           const std::vector<BendingZone>& zones, PatchChecks& found);

}  // namespace boxbeam
