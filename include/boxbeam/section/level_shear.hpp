#pragma once

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/taper.hpp"

namespace boxbeam {

/// Mean shear stress over the width of a section at a level z, per cut force [1/m^2, 1/m^3]:
///
///     tau = (dF/dx)/b
///
/// F is the force of the part beyond the level. From one section to the next the level moves in
/// proportion between the outermost fibres, the inner faces of flanges and the edges of holes. Zero
/// where there is no width. Source: Jourawski (1856), equilibrium.
CutFactors level_shear_of(const Section& section, const std::vector<Hole>& holes,
                          const Taper& taper, double z);

/// The same across: over the height of a section at y, the part beyond it towards +y. The place
/// moves in proportion to the width. For profiles symmetric about z.
CutFactors level_shear_across_of(const Section& section, const std::vector<Hole>& holes,
                                 const Taper& taper, double y);

}  // namespace boxbeam
