#pragma once

#include "boxbeam/section/outline.hpp"
#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// Area and moments of a section about axes through its own centroid, parallel to those of the
/// beam; I_y resists bending in the plane of motion.
struct SectionProperties {
  Area area;
  Length centroid_y, centroid_z;
  SecondMoment I_y, I_z;
  SecondMoment I_yz;             ///< integral of y z dA; 0 where y and z are principal axes
  SecondMoment I_1, I_2;         ///< principal, I_1 >= I_2
  double principal_angle = 0.0;  ///< from +y towards +z, of the axis that I_1 is about [rad]
  Length y_left, y_right;        ///< outermost fibres, +y and -y
  Length z_top, z_bottom;        ///< outermost fibres, +z and -z
  SectionModulus W_y, W_z;       ///< each the smaller of the two
};

/// Gross properties, exact: integrals along the border. Inner and outer profile act together.
/// Source: Green's theorem, Steiner's theorem; principal axes tan 2 phi = -2 I_yz/(I_y - I_z).
SectionProperties properties_of(const Section& section);

/// Net properties: strips of the holes (diameter times wall) taken out, also of the centroid.
SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes);

/// Effective properties for shear lag: of each internal flange of the outer profile only the part
/// `flange_part` of its clear width counts, half of it beside each web; a strip in its middle is
/// left out, with it what stands on it of stiffeners. Of the webs, which are the flanges of bending
/// about z, likewise the part `web_part` of their clear depth. For normal stress only. Valid for
/// boxes and rectangular tubes; other profiles are taken whole. Precondition: both parts above 0
/// and at most 1. Source: EN 1993-1-5:2006, 3.2 (effective^s width, recalled, not confirmed).
SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes,
                                double flange_part, double web_part = 1.0);

/// The area integrals of a section known by its properties.
AreaSums sums_of(const SectionProperties& of);

/// First moment of the net area beyond level z about the centroid, for V S / (I b) [m^3].
///
///     S(z) = integral over zeta > z of (zeta - z_c) dA
SectionModulus first_moment_beyond(const Section& section, const std::vector<Hole>& holes, Length z,
                                   Length centroid_z);

/// Width of material at level z, all walls together; a level where the width jumps counts to the
/// narrower side that has material.
Length width_at(const Section& section, const std::vector<Hole>& holes, Length z);

}  // namespace boxbeam
