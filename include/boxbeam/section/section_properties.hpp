#pragma once

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// Area and moments of a section about its own centroid; I_y resists bending in the plane of
/// motion. Axes y and z are principal by symmetry about z.
struct SectionProperties {
  Area area;
  Length centroid_z;  ///< 0 unless holes are off the mid-height
  SecondMoment I_y;
  SecondMoment I_z;
  Length z_top;        ///< outermost fibre, +z
  Length z_bottom;     ///< outermost fibre, -z
  SectionModulus W_y;  ///< the smaller of the two
  SectionModulus W_z;
};

/// Gross properties; closed forms, outer shape minus hollow. Inner profile and outer profile act
/// together. Source: second moments of rectangle and circle, Steiner's theorem.
SectionProperties properties_of(const Section& section);

/// Net properties: strips of the holes (diameter times wall) taken out, also of the centroid.
SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes);

/// First moment of the net area beyond level z about the centroid, for V S / (I b) [m^3].
///
///     S(z) = integral over zeta > z of (zeta - z_c) dA
SectionModulus first_moment_beyond(const Section& section, const std::vector<Hole>& holes, Length z,
                                   Length centroid_z);

/// Width of material at level z, all walls together; a level on the inner face of a flange counts
/// as web.
Length width_at(const Section& section, const std::vector<Hole>& holes, Length z);

}  // namespace boxbeam
