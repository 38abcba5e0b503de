#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/motion_summary.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The force along the beam that comes in between its ends at one place and is largest over a
/// quarter of its section, where it is more than 0.3 of what that bears: by which plates it comes
/// in, and how far it needs to spread to all of the section, no check knows. Of sections of plates;
/// what comes in at one station from both sides counts by its sum. Source: EN 1993-1-5:2006, 3.2.3.
std::vector<NotJudged> axial_forces_not_judged(const Project& project,
                                               const std::deque<SituationRun>& runs);

/// Supports of a frame on which it may only lie, and that at some instant hold it down: they count
/// in either sense, which what only lies on them does not bear. These are rollers, and where there
/// are any, hinges that push at other instants. Down is where gravity points; without gravity, of
/// the axis upwards in the world, against what all supports together bear most. Nothing below 1e-3
/// of the largest force of a support.
std::vector<NotJudged> lifted_supports_of(const Project& project,
                                          const std::vector<MotionSummary>& motions);

/// Bending moments that given cut forces leave out.
struct GivenCutsFound {
  std::vector<Gate> gates;
  std::vector<NotJudged> not_judged;
};

/// How far given bending moments are from those that the given shear forces make,
///
///     d(s) = M(0) + int_0^s V dx + jumps of M - M(s)   of both planes (M_z: of -V_y),
///
/// at all instants: between stations M is taken as linear, and may be larger where V changes, or V
/// contradicts it. Stops the verdict where the stress d z/I together with the largest use by yield
/// reaches its limit; is said where it is above 0.05 f_y, in fatigue above what no cycle feels.
/// Of other kinds of loads nothing. Source: dM/dx = V.
GivenCutsFound look_at_given_cuts(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<CheckResult>& checks);

}  // namespace boxbeam
