#pragma once

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// Areas that carry V_y and V_z in the shear deformation of a beam.
struct ShearAreas {
  Area y, z;
};

/// Of V_z: the webs of a box over its whole height, A h/(b + h) of a rectangular tube, 2 A/pi of a
/// round one, 5/6 of a solid one, the walls' share along z of a thin-walled path; of V_y likewise
/// the flanges over the whole width, A b/(b + h), the share along y. An inner profile adds its own.
/// Source: EN 1993-1-1:2005, 6.2.6(3); Timoshenko, Strength of Materials I, article 39 (5/6).
ShearAreas shear_areas_of(const Section& section);

}  // namespace boxbeam
