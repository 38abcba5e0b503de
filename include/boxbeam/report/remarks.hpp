#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// What a reader must know beside the numbers: assumptions of the case, assumed categories,
/// validity of formulas, values printed beside, what is not checked.
std::vector<std::string> remarks_of(const Project& project, const Verification& verification);

}  // namespace boxbeam
