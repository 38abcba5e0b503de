#pragma once

#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// results.json, "boxbeam.results/1": SI units, key order fixed, every number finite.
std::string results_json(const Project& project, const Verification& verification);

/// The motion document, "boxbeam.motion/1", kind planar.
std::string motion_json(const MotionResult& motion);

}  // namespace boxbeam
