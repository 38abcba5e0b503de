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
/// asked, the case has no weld around the profile there and judges those plates by no detail of
/// that place (no longer than the section is deep), nor by one as weak as a splice without
/// transition whose faces are flush on one side: row 8.3/17 with e = (t_2
/// - t_1)/2. Walls of paths, and plates of profiles of unlike kinds, go on where the next ones lie.
/// Source: EN 1993-1-9:2005+AC:2009, table 8.3.
std::vector<NotJudged> unsaid_joints_of(const Project& project);

/// Uses that are largest at the last instant of a motion by forces, of a sudden start or of a rate
/// or polynomial that still changes, and at least half as large as the largest of all: beyond it
/// may be more.
std::vector<NotJudged> unfinished_motion_of(const Project& project,
                                            const std::deque<SituationRun>& runs,
                                            const std::vector<CheckResult>& checks);

/// What vibration adds: in space where it is estimated to be more than the model's tolerance, and
/// where loads that change come onto a beam whose vibration nobody estimates: where something
/// stands against an estimate, and in frames at rest under functions of time. Nothing where the
/// loads are measured, elastic links carry them, or the stresses along the beam change by less than
/// the tolerance; in space where they change slowly (`may_vibrate`).
std::vector<NotJudged> unestimated_vibration_of(const Project& project, const ModelChoice& model,
                                                const std::deque<SituationRun>& runs);

/// In space: how the beam is held against buckling and turning over is taken for granted where it
/// counts, though a joint that holds it leaves it free in some way.
std::vector<NotJudged> assumed_holds_not_judged(const Project& project,
                                                const SecondOrderEstimate& estimate);

/// Stops that part by the law of an impact and joints with clearance: what rigid bodies do not say
/// of an impact.
std::vector<NotJudged> impacts_not_judged(const Project& project);

/// Welds around a profile that reaches farther than the beam on both sides of its station: they
/// are not welds of the beam.
std::vector<Gate> weld_gates_of(const Project& project);

}  // namespace boxbeam
