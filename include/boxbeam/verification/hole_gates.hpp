#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Up to this part of a plate's width an opening does not count. Source: EN 1993-1-5:2006, 2.3(1).
constexpr double widest_opening = 0.05;

/// Whether a hole is wider than that in a plate that it goes through.
bool is_wide(const Project& project, const BeamHole& at);

/// What stands against believing stresses at holes: one at a diaphragm or over an end of the beam,
/// and strips that bend beside one of more than 0.3 of its plate whose detail alone is given. Under
/// the force F of the plate, by n strips,
///
///     M = F/n 0.225 d
///
/// in each; likewise posts between holes in a row along the beam that bend above yield, or above
/// 0.05 of it where they are narrower than half of their pitch, in fatigue 0.6 of it. At diaphragms
/// and ends small holes side by side count together. Source: SCI P355 (2011), circular openings as
/// rectangles 0.45 d long; web posts.
std::vector<Gate> hole_gates_of(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
