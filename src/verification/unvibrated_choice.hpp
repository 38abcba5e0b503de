#pragma once

#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/model_choice.hpp"

/// The choice of a model where modes do not count: rigid bodies, or bent ones.

namespace boxbeam {

/// Bodies that bend statically under their axial force, without vibration.
inline constexpr ElasticModel bent{ModelLevel::quasi_static, 0, 16, {}, false};

/// A choice before any model is weighed, of a beam of rigid bodies.
ModelChoice begun_choice(const Project& project, SecondOrderEstimate estimated);

/// Whether bodies in space are pressed so far that theory of the first order does not hold, and
/// how they bend is known. Source: EN 1993-1-1, 5.2.1(3).

bool is_pressed_in_space(const Project& project, const SecondOrderEstimate& pressed);

/// What the second order of beams in space has not, in words; "" where it has all.

std::string left_out_of_bending(const Project& project);

/// Where vibration is not estimated: rigid bodies, or bent ones where second order asks for them.

/// Throws AnalysisError where elastic ones were demanded. `known`: what is said before the
/// obstacle.
void choose_unvibrated(const Project& project, const std::string& obstacle, ModelChoice& choice,
                       const std::string& known = "what vibration adds is not estimated: ");

}  // namespace boxbeam
