#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// What the model of the mechanism leaves out of the checks: pins and rods of a planar case, whose
/// forces are those of rigid bodies, beside a beam that vibrates; a demanded model that is found or
/// estimated to miss the tolerance.
std::vector<Gate> model_gates_of(const Project& project, const ModelChoice& model);

/// Second order where it is not in the cut forces, or is there by the loads times one and not by
/// those that are to be borne: the check that passes, and by its estimate would not, the most. None
/// where all would.
std::vector<Gate> second_order_gates_of(const Project& project, const ModelChoice& model,
                                        const std::vector<CheckResult>& checks);

/// What of EN 1993 is not known of a material that is no structural steel of 210 GPa up to S700:
/// its lines of fatigue and limits of slenderness hold for steel (EN 1993-1-9, 1.1(2)), those of
/// stainless steel are lower (EN 1993-1-4:2006+A1:2015, table 5.2: c/t <= 37 epsilon where a plate
/// is evenly compressed is the least), and its rules end at S700 (EN 1993-1-12:2007, 1.1).
std::vector<Gate> material_gates_of(const Project& project);

/// The least elastic critical load factor of what carries the beam, where it is known: below 10
/// theory of the first order does not hold. Source: EN 1993-1-1:2005, 5.2.1(3).
std::vector<Gate> stability_gates_of(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
