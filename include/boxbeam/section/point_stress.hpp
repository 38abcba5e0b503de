#pragma once

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {

/// Nominal stress at one point of a section.
struct PointStress {
  Stress normal;  ///< tension positive
  Stress shear;

  /// Equivalent stress of plane stress with one normal component, after von Mises:
  ///
  ///     sigma_v = sqrt(sigma^2 + 3 tau^2)
  Stress von_mises() const;
};

/// What a level z of a section contributes to its stress; depends on the section only.
///
///     sigma = N/A + (M_y - N z_c) (z - z_c)/I_y,   tau = V_z S(z) / (I_y b(z))
///
/// M_y is taken about mid-height, z_c is the centroid of the (net) section. The shear formula is
/// Jourawski's for a prismatic piece: in a taper the inclined flanges carry a part of V_z, which
/// it leaves with the webs. Valid for bending in the plane of motion (V_y = T = M_z = 0).
/// Source: Timoshenko, Strength of Materials I, articles 22 and 26.
struct StressLevel {
  double per_N = 0.0;  ///< sigma per N [1/m^2]
  double per_M = 0.0;  ///< sigma per M_y [1/m^3]
  double per_V =
      0.0;  ///< sigma per V_z: only where shear turns into hoop stress, at a hole [1/m^2]
  double per_shear = 0.0;  ///< tau per V_z [1/m^2]
};

/// Precondition: there is material at level z.
StressLevel stress_level_of(const Section& section, const std::vector<Hole>& holes,
                            const SectionProperties& net, Length z);

PointStress stress_at(const StressLevel& level, const CutForces& cut);

}  // namespace boxbeam
