#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/any_motion_result.hpp"

namespace boxbeam {

/// The motion of a mechanism as tables.
std::string motion_text(const Project& project, const AnyMotionResult& motion);
std::string motion_text(const Project& project, const MotionResult& motion);
std::string motion_text(const Project& project, const ChainMotionResult& motion);
std::string motion_text(const Project& project, const FlexibleMotionResult& motion);

/// The assemblies of the mechanism at an instant as a table.
std::string assemblies_text(const Project& project, const std::vector<AssemblyResult>& assemblies,
                            double time);

}  // namespace boxbeam
