#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

/// Standard and clauses of checks.
namespace boxbeam {

std::string yield_source(const Material& material);

std::string fatigue_source(const FatigueInput& fatigue, const std::vector<SnCurve>& curves);

}  // namespace boxbeam
