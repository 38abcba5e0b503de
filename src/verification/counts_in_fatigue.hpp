#pragma once

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// Whether a situation or a change between situations that contains it has cycles.
bool counts_in_fatigue(const Project& project, const Situation& situation);

}  // namespace boxbeam
