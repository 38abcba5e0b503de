#pragma once

#include <vector>

#include "boxbeam/verification/gates.hpp"

namespace boxbeam {

/// What the model of the mechanism leaves out of the checks: pins and rods of a planar case, whose
/// forces are those of rigid bodies, beside a beam that vibrates; a demanded model that is found or
/// estimated to miss the tolerance.
std::vector<Gate> model_gates_of(const Project& project, const ModelChoice& model);

}  // namespace boxbeam
