#pragma once

#include <optional>

#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/verification/distortion_checks.hpp"

namespace boxbeam {

/// What a diaphragm bears so that a cell keeps its shape where it takes d [N m]: a shear flow
/// d/(b h) all around its plate, by twice d the torque that comes by the webs alone. The strips
/// beside an opening bend as the frame does (`diaphragm_stiffness`): M = d/4. Nothing where the
/// opening leaves nothing of it, or its material is not known so thick.
std::optional<DistortionEstimate::Holding> holding_of(const Project& project, const Diaphragm& of,
                                                      const BoxCell& cell, double d);

/// Its welds, of which the case says no throat.
NotJudged unsaid_welds(const Project& project, const DistortionEstimate::Holding& of);

}  // namespace boxbeam
