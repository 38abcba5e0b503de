#pragma once

#include <string>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// One check as formula, substituted values, result and source.
std::string calculation_sheet(const Project& project, const Verification& verification,
                              const CheckResult& result);

}  // namespace boxbeam
