#pragma once

#include "boxbeam/verification/distortion_checks.hpp"
#include "boxbeam/verification/torques_in.hpp"

namespace boxbeam {

/// Whether the distortion of a segment is computed: its profile is a cell all along.
bool has_cell(const Segment& segment);

/// Whether it is a path around a cell of whatever shape.
bool is_closed_path(const Segment& segment);

/// Paths around cells that are no rectangle, under torque. Their distortion is not computed: it
/// stops the verdict where a torque comes, or passes an end of them, without a diaphragm that is
/// rigid (9.3.3(3)) and bears its flow T/(2 A_m), and where torque comes along the beam, or the
/// outline's b/h changes under torque, between such diaphragms that are farther apart than
/// 0.5/lambda of a box as wide, as high and as thick. Else it is said. `torques`: of the beam, of
/// each run at its instants.
void look_at_other_cells(const Project& project, const std::deque<SituationRun>& runs,
                         const std::vector<std::vector<TorquesIn>>& torques,
                         DistortionChecks& found);

}  // namespace boxbeam
