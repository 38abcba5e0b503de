#pragma once

#include <string>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/verification/stress_points.hpp"

/// Steps of a calculation sheet from the cut forces to the stress of a point.
namespace boxbeam::report {

/// What of the section the normal stress of a point follows from: at a hole its concentration.
void derive_normal_section(Derivation& steps, const Project& project, const StressPoint& point);

/// The normal stress of a point under given cut forces; in space with all six.
Traced derive_normal_stress(Derivation& steps, const std::string& symbol, const Project& project,
                            const StressPoint& point, const CutForces& cut,
                            const std::string& note = "");

/// What of the section the shear stress of a point follows from.
void derive_shear_section(Derivation& steps, const Project& project, const StressPoint& point);

/// The shear stress of a point likewise.
Traced derive_shear_stress(Derivation& steps, const std::string& symbol, const Project& project,
                           const StressPoint& point, const CutForces& cut,
                           const std::string& note = "");

/// The stress in the throat of a weld under sigma_w across it and tau_par along it.
Traced derive_throat_stress(Derivation& steps, const Traced& sigma_w, const Traced& tau_par);

}  // namespace boxbeam::report
