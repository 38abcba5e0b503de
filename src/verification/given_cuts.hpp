#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

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
