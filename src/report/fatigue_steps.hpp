#pragma once

#include "boxbeam/verification/checks.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// The strength of a detail: category, size effect, and the corners of its S-N curve.
Steps curve_steps(const SnCurve& curve, const BeamDetail* detail);

/// The strength at a number of cycles, by the branch of the curve that it lies on.
Step strength_step(const SnCurve& curve, double cycles, Loading loading);

/// From the spectrum and the curves to the factor on the loads, for which the life is just used
/// up; its last step is the factor.
Steps life_steps(const Project& project, const Check& check, const CheckBasis& basis);

}  // namespace boxbeam::report
