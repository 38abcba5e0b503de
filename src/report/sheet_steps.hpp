#pragma once

#include <string>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/fatigue/sn_corners.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "sheet_numbers.hpp"

/// Steps of calculation sheets, by what is checked and by what of it.
namespace boxbeam::report {

/// Sheet of a check of plates that buckle: effective section, shear buckling, both together.
Steps plate_steps(const Project& project, const CheckResult& result);

/// Sheet of a force that comes into a web, or into a diaphragm there.
Steps patch_steps(const Project& project, const CheckResult& result);

/// A web that forces press anew at every cycle. pressed_steps.cpp
Steps pressed_steps(const Project& project, const CheckResult& result);

/// Sheet of the beam as a member.
Steps member_steps(const Project& project, const CheckResult& result);

/// Sheet of a box that is distorted, in strength or in fatigue.
Steps distortion_steps(const Project& project, const CheckResult& result);

/// Sheet of a pin, of a lug, of a rod under tension or of one under compression.
Steps neighbour_steps(const Project& project, const NeighbourResult& result);

/// From the spectrum and the curves to the factor on the loads, for which the life is just used
/// up; its last step is the factor.
Steps life_steps(const Project& project, const Check& check, const CheckBasis& basis);

/// The strength of a detail: category, size effect, and the corners of its S-N curve.
void derive_curve(Derivation& steps, const SnCurve& curve, const BeamDetail* detail);

/// "A", "A_net" less holes, "A_eff" less what shear lag leaves idle: of the section that the normal
/// stress of a point is taken from.
std::string area_symbol(const StressPoint& point);

/// "I_y", "I_y,net", "I_y,eff" likewise.
std::string inertia_symbol(const std::string& of, const StressPoint& point);

/// The area and the moments of inertia of that section.
void derive_section(Derivation& steps, const Project& project, const StressPoint& point);

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
