#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// report.txt: verdict, case, assumptions, mechanism, loads, cut forces, sections, calculation
/// sheets of the governing checks, all checks, comparison of load models.
std::string text_report(const Project& project, const Verification& verification);

/// The terminal's summary: the verdict first, then the worst checks.
std::string summary(const Project& project, const Verification& verification);

/// The motion of the mechanism as tables.
std::string motion_text(const Project& project, const MotionResult& motion);

/// The assemblies of the mechanism at an instant as a table.
std::string assemblies_text(const Project& project, const std::vector<AssemblyResult>& assemblies,
                            double time);

}  // namespace boxbeam
