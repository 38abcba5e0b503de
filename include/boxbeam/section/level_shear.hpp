#pragma once

#include <optional>

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

/// The first moment of which the shear stress of V_z at a level is V_z S/(I_y b).
struct LevelMoment {
  SectionModulus S;  ///< about the centroid of the section
  Length b;
  bool on_webs = false;  ///< of what hangs on both webs of the outer profile, which are b wide
};

/// From the border of the section, S of what lies beyond a level and b the width of the material
/// there: a level across equal walls, or a solid.
LevelMoment moment_beyond_level(const Section& section, const std::vector<Hole>& holes, Length z);

/// From the rectangles of the walls of a box or rectangular tube, S of what hangs on both webs
/// beyond a level: the webs' own part, the flange, its stiffeners wherever they reach, not an inner
/// profile. Nothing of other profiles, and where the webs differ.
std::optional<LevelMoment> moment_on_webs(const Section& section, const std::vector<Hole>& holes,
                                          Length z);

/// That of both which gives the shear stress `per_V` [1/m^2] of V_z; nothing where the flow at a
/// place is no such flow (beside inner walls that do not balance each for itself, in flanges, in
/// unsymmetric sections).
std::optional<LevelMoment> level_moment_of(const Section& section, const std::vector<Hole>& holes,
                                           Length z, double per_V);

/// The same across: over the height of a section at y, the part beyond it towards +y. The place
/// moves in proportion to the width. For profiles symmetric about z.
CutFactors level_shear_across_of(const Section& section, const std::vector<Hole>& holes,
                                 const Taper& taper, double y);

}  // namespace boxbeam
