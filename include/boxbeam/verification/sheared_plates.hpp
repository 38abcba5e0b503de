#pragma once

#include <array>
#include <string>
#include <vector>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/section.hpp"
#include "boxbeam/section/shear_flow.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/shear_buckling.hpp"

namespace boxbeam {

/// A plate of a station in shear.
struct ShearedPlate {
  BoxPlate plate = BoxPlate::left_web;
  std::string name;  ///< "web" where both are stressed alike
  ShearPanel panel;
  ShearResistance resists;
  bool may_buckle = false;  ///< in the segment it is so slender that shear buckling is judged
  /// A part of its clear width, between edges and feet of stiffeners, where the shear flow jumps.
  struct Piece {
    double width = 0.0;  ///< over the clear one
    /// Shear stress per cut force at both ends and in the middle, between which it is a parabola:
    /// of the gross section, taper and torsion included [1/m^2, 1/m^3].
    std::array<std::array<double, cut_force::count>, 3> per_cut_force{};
  };
  std::vector<Piece> pieces;

  /// The size of its force in its plane, over its clear width. Of a flange that of at least half of
  /// its largest stress, EN 1993-1-5, 7.1(5): under V_z both halves of it balance each other; of
  /// one with stiffeners that of the largest mean of its subpanels, as if all were stressed like
  /// it.
  Force force_of(const CutForces& cut) const;
};

/// The plates of a section in shear, in the order of its flow; of webs that are stressed alike the
/// left one, for both. `may_buckle` is left open.
std::vector<ShearedPlate> sheared_plates_of(const Section& section, const FourWalls& walls,
                                            const Taper& taper, bool in_plane, double gamma_M1);

}  // namespace boxbeam
