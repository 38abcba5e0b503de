#pragma once

#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// A verification in a screenful: the verdict first, the worst check of every criterion, what
/// blocks the checks, and the first remarks.
std::string summary(const Project& project, const Verification& verification);

}  // namespace boxbeam
