#pragma once

#include <optional>
#include <string>

#include "boxbeam/strength/column_buckling.hpp"
#include "boxbeam/strength/compressed_section.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// A force along a rod beside its centroid, which bends it: of the walls that work, where plates
/// buckle under it.
struct EccentricForce {
  Length e_y, e_z;          ///< from the line of the rod, y = z = 0 of its section
  SectionModulus W_y, W_z;  ///< the least of all places
};

/// Why what it bends is not judged under compression, "" where it is: of what is no tube and bent
/// in its stiffer principal plane, which may turn over.
std::string turning_obstacle_of(const Section& section, Length shift_y, Length shift_z);

/// Why plates may buckle under what it bends, which is counted of thin-walled paths alone; "" where
/// none do, or all that is counted.
std::string bent_plates_obstacle_of(const Section& section, Stress yield_strength);

/// Nothing where the force goes through the centroid. `shift_y`, `shift_z`: of the centroid as
/// plates buckle, where that makes it worse. Of other profiles than a thin-walled path by itself W
/// is elastic, of the corners of what is around the section, coupled where y and z are no principal
/// axes.
std::optional<EccentricForce> eccentric_force_of(const Section& section, Stress yield_strength,
                                                 Length shift_y = {}, Length shift_z = {});

/// What the resistance of a rod to tension follows from.
struct PulledRod {
  Area area;
  std::optional<Area> net_area;  ///< where holes for fasteners weaken it most; nothing: no holes
  Stress yield_strength, tensile_strength;
  double gamma_M0 = 1.0, gamma_M2 = 1.25;
  std::optional<EccentricForce> beside = {};
};

/// Resistance of a rod to tension.
struct TensionResistance {
  Force plastic;  ///< N_pl,Rd, of the whole section
  Force net;      ///< N_u,Rd, of the net section
  Force least;
};

/// The smaller of the whole section's and the net section's. A rod without holes for fasteners has
/// its whole area as net area.
///
///     N_pl,Rd = A f_y/gamma_M0,  N_u,Rd = 0.9 A_net f_u/gamma_M2
///
/// Beside the centroid the least of both over 1 + m, m = A (e_z/W_y + e_y/W_z), elastic. Source: EN
/// 1993-1-1:2005, 6.2.1(5), 6.2.3(2), equations 6.6 and 6.7.
TensionResistance tension_resistance_of(const PulledRod& rod);

/// The factor on a tension, step by step.
void derive_tension_factor(Derivation& steps, const Traced& tension, const PulledRod& rod);

/// How a rod of thin walls twists as it buckles: what it bears by bending about each axis and by
/// twisting alone, and what couples these (`TwistingLoad`).
struct TwistingRod {
  Force about_y, about_z, by_twisting;  ///< N_cr,y, N_cr,z, N_cr,T
  Length length;                        ///< L_T
  double y_0 = 0.0, z_0 = 0.0, coupling = 0.0;

  /// N_cr of all of it at once.
  Force critical() const;
};

/// Nothing of profiles other than thin-walled paths, which do not twist before they bend. Held
/// against turning at its ends, which warp freely: `between` these, or the longer buckling length.
/// Source: EN 1993-1-1:2005, 6.3.1.4; Timoshenko, Gere, section 5.4.
std::optional<TwistingRod> twisting_rod_of(const Section& section, Stress youngs_modulus,
                                           Length buckling_length, Length between);

/// What the resistance of a rod to compression follows from.
struct PressedRod {
  CompressedSection section;
  SecondMoment inertia;    ///< about the weaker axis
  bool weak_axis = false;  ///< that is its z axis
  Length buckling_length;
  Stress youngs_modulus, yield_strength;
  BucklingCurve curve = BucklingCurve::c;
  double gamma_M0 = 1.0, gamma_M1 = 1.0;
  std::optional<TwistingRod> twisting = {};
  std::optional<EccentricForce> beside = {};
};

/// Resistance of a rod to compression.
struct CompressionResistance {
  double slenderness = 0.0;  ///< relative
  double reduction = 1.0;    ///< chi
  Force section;             ///< N_c,Rd
  Force buckling;            ///< N_b,Rd
  Force least;
};

/// The section itself and flexural buckling, of thin walls torsional-flexural; in class 4 of the
/// effective area, the slenderness too. Of a stout rod the section may bear less, by its own
/// partial factor.
///
///     N_c,Rd = A f_y/gamma_M0,  N_b,Rd = chi A f_y/gamma_M1
///
/// Beside the centroid, or where it moves in class 4, over 1 + m and 1 + 1.6 chi m, m = A (e_z/W_y
/// + e_y/W_z): 6.3.3 with an even moment, whose k = 1 + 0.6 N/N_b,Rd is 1.6 at most (table B.1,
/// class 3 and 4). Source: EN 1993-1-1:2005, 6.2.4(2), 6.2.9.3, 6.3.1.1(3), 6.3.1.4, 6.3.3,
/// equations 6.10, 6.11, 6.44, 6.47, 6.48, 6.61 and 6.62.
CompressionResistance compression_resistance_of(const PressedRod& rod);

/// The factor on a compression, step by step.
void derive_compression_factor(Derivation& steps, const Traced& compression, const PressedRod& rod);

}  // namespace boxbeam
