#pragma once

#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/checks.hpp"

namespace boxbeam {

/// The beam as a member: flexural buckling in the plane and across it, by twisting, lateral
/// torsional buckling, each where it counts (N/N_cr, M/M_cr above 0.04) and does not stop the
/// verdict (1.0). By the largest of what acts anywhere at any instant (`flexural_use`,
/// `lateral_use`), curves c and d, of what slender plates and, where the case asks for it, shear
/// lag leave of the sections.
std::vector<CheckResult> check_member(const Project& project, const std::vector<BendingZone>& zones,
                                      const SecondOrderEstimate& estimate);

}  // namespace boxbeam
