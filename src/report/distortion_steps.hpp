#pragma once

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// Sheet of a box that is distorted, in strength or in fatigue.
Steps distortion_steps(const Project& project, const CheckResult& result);

}  // namespace boxbeam::report
