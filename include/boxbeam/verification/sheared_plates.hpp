#pragma once

#include <array>
#include <string>
#include <vector>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/section.hpp"
#include "boxbeam/section/shear_flow.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/shear_buckling.hpp"

namespace boxbeam {

/// A plate of a station in shear.
struct ShearedWall {
  std::string name;  ///< "web" where both are stressed alike, "wall 3"
  ShearPanel panel;
  ShearResistance resists;
  bool may_buckle = false;  ///< it is so slender that shear buckling is judged
  /// A part of its clear width, between edges and feet of stiffeners, where the shear flow jumps.
  struct Piece {
    double width = 0.0;  ///< over the clear one
    /// Shear stress per cut force at both ends and in the middle, between which it is a parabola:
    /// of the gross section, taper and torsion included [1/m^2, 1/m^3].
    std::array<std::array<double, cut_force::count>, 3> per_cut_force{};
  };
  std::vector<Piece> pieces;

  /// As a flange is looked at, EN 1993-1-5, 7.1(5): with at least half of its largest stress, for
  /// under the shear force across it both halves of it balance each other; with stiffeners with the
  /// largest mean of its subpanels, as if all were stressed like it. In space webs are flanges of
  /// M_z: with stiffeners V_y, across them, counts by subpanels, V_z by the whole depth (5.3).
  bool as_flange = false, by_subpanels = false, web_in_space = false;

  /// The size of its force in its plane, over its clear width.
  Force force_of(const CutForces& cut) const;
};

struct ShearedPlate : ShearedWall {
  BoxPlate plate = BoxPlate::left_web;
};

/// The plates of a section in shear, in the order of its flow; of webs that are stressed alike the
/// left one, for both. `may_buckle` is left open.
std::vector<ShearedPlate> sheared_plates_of(const Section& section, const FourWalls& walls,
                                            const Taper& taper, bool in_plane, double gamma_M1);

/// The plates of a path that both ends hold, in shear, or its outstands, for whose resistance there
/// is no rule. Each counts as a flange, too, for any of them may be one. Resistances, the length of
/// panels and `may_buckle` are left open.
std::vector<ShearedWall> sheared_walls_of(const ThinWalled& profile, const PathSection& path,
                                          const Taper& taper, bool outstands);

}  // namespace boxbeam
