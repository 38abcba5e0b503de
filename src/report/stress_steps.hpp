#pragma once

#include <string>

#include "boxbeam/verification/stress_points.hpp"
#include "sheet_numbers.hpp"

/// Steps of a calculation sheet from the cut forces to the stress of a point.
namespace boxbeam::report {

/// What of the section the normal stress of a point follows from: at a hole its concentration.
Steps normal_section_steps(const Project& project, const StressPoint& point);

/// The normal stress of a point under given cut forces; in space with all six.
Steps normal_stress_steps(const std::string& symbol, const Project& project,
                          const StressPoint& point, const CutForces& cut);

/// What of the section the shear stress of a point follows from.
Steps shear_section_steps(const Project& project, const StressPoint& point);

/// The shear stress of a point likewise.
Steps shear_stress_steps(const std::string& symbol, const Project& project,
                         const StressPoint& point, const CutForces& cut);

}  // namespace boxbeam::report
