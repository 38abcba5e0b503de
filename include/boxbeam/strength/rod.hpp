#pragma once

#include <optional>

#include "boxbeam/strength/column_buckling.hpp"
#include "boxbeam/strength/compressed_section.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// What the resistance of a rod to tension follows from.
struct PulledRod {
  Area area;
  std::optional<Area> net_area;  ///< where holes for fasteners weaken it most; nothing: no holes
  Stress yield_strength, tensile_strength;
  double gamma_M0 = 1.0, gamma_M2 = 1.25;
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
/// Source: EN 1993-1-1:2005, 6.2.3(2), equations 6.6 and 6.7.
TensionResistance tension_resistance_of(const PulledRod& rod);

/// The factor on a tension, step by step.
void derive_tension_factor(Derivation& steps, const Traced& tension, const PulledRod& rod);

/// What the resistance of a rod to compression follows from.
struct PressedRod {
  CompressedSection section;
  SecondMoment inertia;    ///< about the weaker axis
  bool weak_axis = false;  ///< that is its z axis
  Length buckling_length;
  Stress youngs_modulus, yield_strength;
  BucklingCurve curve = BucklingCurve::c;
  double gamma_M0 = 1.0, gamma_M1 = 1.0;
};

/// Resistance of a rod to compression.
struct CompressionResistance {
  double slenderness = 0.0;  ///< relative
  double reduction = 1.0;    ///< chi
  Force section;             ///< N_c,Rd
  Force buckling;            ///< N_b,Rd
  Force least;
};

/// The section itself and flexural buckling; in class 4 of the effective area, the slenderness too.
/// Of a stout rod the section may bear less, by its own partial factor.
///
///     N_c,Rd = A f_y/gamma_M0,  N_b,Rd = chi A f_y/gamma_M1
///
/// Source: EN 1993-1-1:2005, 6.2.4(2) and 6.3.1.1(3), equations 6.10, 6.11, 6.47 and 6.48.
CompressionResistance compression_resistance_of(const PressedRod& rod);

/// The factor on a compression, step by step.
void derive_compression_factor(Derivation& steps, const Traced& compression, const PressedRod& rod);

}  // namespace boxbeam
