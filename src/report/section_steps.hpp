#pragma once

#include <string>

#include "boxbeam/verification/stress_points.hpp"

namespace boxbeam::report {

/// "A", "A_net" less holes, "A_eff" less what shear lag leaves idle: of the section that the normal
/// stress of a point is taken from.
std::string area_symbol(const StressPoint& point);

/// "I_y", "I_y,net", "I_y,eff" likewise.
std::string inertia_symbol(const std::string& of, const StressPoint& point);

/// The area and the moments of inertia of that section.
void derive_section(Derivation& steps, const Project& project, const StressPoint& point);

}  // namespace boxbeam::report
