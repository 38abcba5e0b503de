#pragma once

#include <string>

#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// The models that were weighed, with what is estimated and found of each, and the frequencies that
/// they are judged by.
std::string model_section(const ModelChoice& choice);

}  // namespace boxbeam
