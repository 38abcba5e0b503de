#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The stations to verify: both sides of every jump of load or section, other places once, and the
/// ends of the details' stretches, and places inside segments where a stress, stress range or cut
/// force has a maximum along the beam.
///
/// In the plane the stress of both outer fibres, M and V. In space that of every corner of the
/// outer profile (a range is a convex function of the place in the section, so that none inside is
/// larger), M_y, M_z, V_y, V_z and T; of round tubes that of sixteen fibres turned to the main
/// direction of bending, the resultants of M and V, and T, which do not depend on how y and z lie.
std::vector<Station> stations_to_verify(const Project& project,
                                        const std::deque<SituationRun>& runs);

}  // namespace boxbeam
