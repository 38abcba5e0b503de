#pragma once

#include <deque>

#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Forces across the beam that come into walls of sections of which it is not judged what they
/// bear: round tubes, and polygons around hollows. With P the sum of what comes in with one sense
/// within half of the section's depth, load factor and required safety factor applied,
///
///     round tube     from a tenth of 4 f_y t^2 on it stands with the verdict; above
///                    5/(1 - 0.81) f_y t^2 = 26.3 f_y t^2 there is no verdict: the most that a
///                    plate across bears, as wide as the tube, and more than 24 f_y t^2 on one side
///     polygon        from a tenth of F_Rd on, above it no verdict: two webs as thick as its
///                    thinnest wall and as deep as it is, under an edge (stiff length 0)
///
/// Where a diaphragm bears it, a boss leads the force in ([[beam.load_introductions]], into =
/// "webs"), or a profile inside shares it, it is only said. What a clamp at an end brings comes
/// into the whole section. Loads q along the beam that stand on it from outside bend the wall,
///
///     m = 3/(4 pi) q r  in a ring that shear flow holds,  q b/8  across a hollow b wide
///
/// over t^2 f_y/4 likewise; in fatigue by 6 m/t^2 at every cycle, above category 160 without a
/// verdict. Sources: EN 1993-1-8:2005, table 7.3, without k_p; EN 1993-1-5:2006, clauses 5 and 6;
/// Roark's Formulas for Stress and Strain, circular rings under tangential shear.
void check_hollow_forces(const Project& project, const std::deque<SituationRun>& runs,
                         PatchChecks& found);

}  // namespace boxbeam
