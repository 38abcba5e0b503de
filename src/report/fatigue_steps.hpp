#pragma once

#include "boxbeam/verification/checks.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// From the spectrum and the curves to the factor on the loads, for which the life is just used
/// up; its last step is the factor.
Steps life_steps(const Project& project, const Check& check, const CheckBasis& basis);

}  // namespace boxbeam::report
