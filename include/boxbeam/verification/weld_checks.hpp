#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/checks.hpp"

namespace boxbeam {

/// The welds around profiles that join parts of the beam: each carries all that is cut at its
/// station as a line along the profile's outline, as thick as its throat with what it penetrates
/// beyond, concentrated at the root, which lies as deep below the outline. Across the throat of a
/// weld of equal legs
///
///     sigma_perp = tau_perp = sigma_w/sqrt(2),  sigma_w = N/A_w + M z/I_w
///
/// tau_par is the shear flow of V and T in that line over the throat. Checks, each at its worst
/// place:
///
/// - the throat, sqrt(sigma_perp^2 + 3 (tau_perp^2 + tau_par^2)) against f_u/(beta_w gamma_M2);
///   sigma_perp <= 0.9 f_u/gamma_M2 is held with it for beta_w >= 5/9, which every steel has;
/// - the root by row 8.5/3, sigma_wf = sigma_w against 36, tau_wf = tau_par against 80, both
///   together;
/// - the toe by row 8.5/1, the profile's own nominal stress in its walls times the weld's stress
///   factor, with the shear of the walls, both together; and its range, 8(1).
///
/// A weld that penetrates fully is as strong as the weaker part: in place of throat and root, the
/// equivalent stress of the profile against f_y of the weaker part. Looked at are both ends and 15
/// places between on every side of the outline, 144 around a round tube: along a side sigma_w is
/// linear and tau_par a parabola, of which these miss less than 0.2 %.
///
/// Normal stresses are raised by what the beam's own section there loses: in all checks by elastic
/// shear lag, in those of strength by plates that buckle as well (EN 1993-1-5:2006, 3.2, 4.4).
///
/// Valid for a weld of one throat all around; what closes the inside of a box (a diaphragm) is not
/// counted. The checks of throat and root hold the throat that suffices for them all.
/// Source: EN 1993-1-8:2005, 4.5.2(3), 4.5.3.2, equation 4.1, 4.7.1, 4.7.2; EN 1993-1-9:2005, 5(6),
/// table 8.5.
std::vector<CheckResult> check_welds(const Project& project, const std::deque<SituationRun>& runs,
                                     const std::vector<BendingZone>& zones);

/// The line of a weld as a section.
Section weld_line_of(const WeldInput& weld);

}  // namespace boxbeam
