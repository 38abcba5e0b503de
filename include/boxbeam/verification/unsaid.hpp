#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Whether any of the checks is one of stress ranges against a detail: else there were none.
bool judged_in_fatigue(const std::vector<CheckResult>& checks);

/// Joints of plates that get thicker or thinner at the border of two segments, where fatigue is
/// asked and neither a detail nor a weld around the profile lies there: their category is that of
/// the case's own weld (EN 1993-1-9, table 8.3), which nothing says. Profiles of unlike kinds are
/// joined by what the case says of [[welds]].
std::vector<NotJudged> unsaid_joints_of(const Project& project);

/// A use that is the largest at the last instant of a motion by forces: beyond it may be more.
std::vector<NotJudged> unfinished_motion_of(const Project& project,
                                            const std::deque<SituationRun>& runs,
                                            const std::vector<CheckResult>& checks);

/// Welds around a profile that reaches farther than the beam on both sides of its station: they
/// are not welds of the beam.
std::vector<Gate> weld_gates_of(const Project& project);

}  // namespace boxbeam
