#pragma once

#include <vector>

#include "boxbeam/verification/checks.hpp"

namespace boxbeam {

/// Yield and fatigue of stresses taken from a published calculation.
std::vector<CheckResult> check_given_stresses(const Project& project);

}  // namespace boxbeam
