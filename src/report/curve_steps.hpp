#pragma once

#include "boxbeam/fatigue/sn_corners.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam::report {

/// The strength of a detail: category, size effect, and the corners of its S-N curve.
void derive_curve(Derivation& steps, const SnCurve& curve, const BeamDetail* detail);

}  // namespace boxbeam::report
