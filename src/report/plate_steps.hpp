#pragma once

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "sheet_numbers.hpp"

namespace boxbeam::report {

/// Sheet of a check of plates that buckle: effective section, shear buckling, both together.
Steps plate_steps(const Project& project, const CheckResult& result);

/// Sheet of a force that comes into a web, or into a diaphragm there.
Steps patch_steps(const Project& project, const CheckResult& result);

/// A web that forces press anew at every cycle. pressed_steps.cpp
Steps pressed_steps(const Project& project, const CheckResult& result);

/// Sheet of the beam as a member.
Steps member_steps(const Project& project, const CheckResult& result);

}  // namespace boxbeam::report
