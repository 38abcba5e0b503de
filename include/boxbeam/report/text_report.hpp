#pragma once

#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// report.txt: verdict, case, assumptions, mechanism, loads, cut forces, sections, calculation
/// sheets of the governing checks, all checks, comparison of load models.
std::string text_report(const Project& project, const Verification& verification);

/// The terminal's summary: the verdict first, then the worst checks.
std::string summary(const Project& project, const Verification& verification);

}  // namespace boxbeam
