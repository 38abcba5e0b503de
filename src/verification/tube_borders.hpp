#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "kinked_flanges.hpp"

namespace boxbeam {

/// Walls of round tubes that end at a border because the next segment's lies elsewhere, as plates
/// do (`flange_steps_of`): eighths of the wall around its middle, each a quarter long. A solid
/// section goes on where the wall lies within it.
std::vector<FlangeStep> tube_steps_of(const Project& project);

/// The largest stress along the wall beside a border of round tubes whose radius turns off by
/// tan(alpha), bent by what turns off as a shell without end on either side, over that stress:
///
///     K = 0.6 sqrt(D (t + t')) tan(alpha)/t   on the side whose wall is t thick
///     K_h = 0.45 sqrt(D/t) tan(alpha)         around it
///
/// D  outside diameter there; t'  the wall beyond the border. Valid where the next border is
/// farther away than sqrt(r t). Source: NORSOK N-004:2004, 6.5.3.1 and 6.5.3.2, which is
/// M = H/(4 beta), beta = 1.285/sqrt(r t), H = sigma t tan(alpha).
struct TubeKink {
  double bends = 0.0, hoops = 0.0;
};
TubeKink tube_kink_of(Length diameter, Length wall, Length beyond, double turn);

/// Kinks of round tubes, cones against tubes or each other: where that with the beam's own stress
/// makes the wall yield, or uses it up in fatigue by the details of the place (of which a larger
/// stress_factor holds it), there is no verdict; from a tenth of f_y, or what a seam of category 36
/// may feel, it stands with the verdict. A diaphragm at the border takes its part of what turns
/// off, as stiff as a ring is beside the shell, where plate and fillets bear all of it.
/// Source: elasticity; Timoshenko, Woinowsky-Krieger, Theory of Plates and Shells, section 114.
void check_tube_kinks(const Project& project, const std::deque<SituationRun>& runs,
                      const std::vector<BendingZone>& zones, PatchChecks& found);

}  // namespace boxbeam
