#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A place of the beam where something that enters a check jumps or changes its slope.
struct BeamCut {
  Length s;
  bool sides = false;  ///< whether a check may differ just before and just behind it
  /// Whether something is judged there and not just beside it: a hole, a named point, the end of a
  /// detail's stretch, which belongs to it.
  bool alone = false;
};

/// All cuts, ascending, each once, the ends of the beam included: between two of them every check
/// varies smoothly along the beam, but for the change from one instant, or place around the
/// section, to another.
///
/// On both sides of a cut something differs at ends of segments where the section or its slope
/// changes; at point loads, of any instant in any situation, and at the ends of the way of one that
/// slides; at ends of details; at borders of shear lag; where a plate of varying thickness crosses
/// a limit of thickness_limits_of, or shear lag begins to count. The other cuts are ends of line
/// loads, holes (a hole is judged in the section through its centre), where they begin and end (the
/// whole web is sheared most beside them) and named points and places.
std::vector<BeamCut> beam_cuts_of(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<BendingZone>& zones);

}  // namespace boxbeam
