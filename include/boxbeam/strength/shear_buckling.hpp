#pragma once

#include <optional>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// Whether a web may buckle in shear before it yields.
struct ShearBucklingNeed {
  double ratio = 0.0;  ///< h_w/t_w
  double limit = 0.0;  ///< 72 eps/eta

  /// The resistance to shear must be taken from EN 1993-1-5, clause 5.
  bool check_needed() const { return ratio > limit; }
};

/// eta: how far strain hardening carries a stout web above its yield strength in shear.
///
///     f_yw <= 460 MPa: 1.2,  above: 1.0
///
/// Recommended values; national annexes may set 1.0 (the limit is then 20 % higher, the resistance
/// of stout webs lower). Source: EN 1993-1-5:2006, 5.1(2), note 2.
double shear_hardening_factor(Stress yield_strength);

/// Clear depth of an unstiffened web over its thickness against 72 eps/eta.
/// Source: EN 1993-1-5:2006, 5.1(2); EN 1993-1-1:2005, 6.2.6(6).
ShearBucklingNeed shear_buckling_need(Length clear_depth, Length thickness, Stress yield_strength,
                                      double eta);

/// h_w/t_w of a web beyond which its compressed flange may buckle into it, k E/f_yf sqrt(A_w/A_fc)
/// with k = 0.55, moments up to the elastic one; A_fc the flange's effective area. Of straight
/// flanges. Source: EN 1993-1-5:2006, 8(1), equation 8.1.
double flange_induced_limit(Area web, Area flange, Stress flange_strength);

/// The longitudinal stiffeners of a plate in shear.
struct ShearStiffeners {
  int count = 0;
  /// I_sl of all together, each with 15 eps t of the plate on both sides, whole: that only a third
  /// of it counts (5.3(4)) is in the formulas of A.3.
  SecondMoment inertia;
  Length widest_subpanel;  ///< between them and the edges, clear
};

/// A plate in shear between its neighbours.
struct ShearPanel {
  Length depth, thickness;  ///< clear
  Stress yield_strength;
  /// Between rigid transverse stiffeners or diaphragms; nothing: so long that they do not help.
  std::optional<Length> length = {};
  bool rigid_end_post = false;  ///< `is_rigid_end_post`; a single diaphragm at the end is none
  ShearStiffeners stiffeners = {};
};

/// Two diaphragms at the end of a beam, as far as they hold one of its webs.
struct EndPost {
  Length apart;
  Length thickness, width;  ///< of the thinner one, and of what of it belongs to the web
};

/// Whether they anchor what the web's panel pulls at its end: at least 0.1 h_w apart, each of an
/// area of 4 h_w t^2/e, of a width of at most 15 eps of its thickness. Source: EN
/// 1993-1-5:2006, 9.3.1(2) and (3); the width as of stiffeners, 9.1(2).
bool is_rigid_end_post(const EndPost& post, Length deepest, Length thickness,
                       Stress yield_strength);

/// What a panel resists in shear.
struct ShearResistance {
  double k_tau = 0.0;     ///< of the whole panel
  double lambda_w = 0.0;  ///< of the panel, or of its widest subpanel
  double chi_w = 0.0;
  Force resistance;  ///< V_bw,Rd
};

/// Resistance of a plate to shear, its own part; that of the flanges is left out, on the safe side.
///
///     k_tau:   a >= h_w: 5.34 + 4 (h_w/a)^2,  else 4 + 5.34 (h_w/a)^2;  5.34 without a
///     lambda_w = h_w/(37.4 t eps sqrt(k_tau))
///     chi_w:   lambda_w < 0.83/eta: eta;  0.83/lambda_w;  rigid end post, from 1.08 on:
///              1.37/(0.7 + lambda_w)
///     V_bw,Rd = chi_w f_yw h_w t/(sqrt(3) gamma_M1)
///
/// With longitudinal stiffeners, theta = I_sl/(t^3 h_w):
///
///     k_tau + max[9 (h_w/a)^2 theta^(3/4), 2.1 theta^(1/3)];  of one or two and a < 3 h_w in its
///     place 4.1 + (6.3 + 0.18 theta) (h_w/a)^2 + 2.2 theta^(1/3)
///     lambda_w no less than that of the widest subpanel by itself
///
/// Source: EN 1993-1-5:2006, 5.2, 5.3(3) to (5), table 5.1, annex A.3.
ShearResistance shear_resistance_of(const ShearPanel& panel, double gamma_M1);

/// V_bw,Rd step by step.
Traced derive_shear_resistance(Derivation& steps, const ShearPanel& panel, double gamma_M1);

/// The shear at which a plate buckles, beyond which it pulls at what bounds its panel.
///
///     V_cr = h_w t f_yw/(lambda_w^2 sqrt(3) gamma_M1)
///
/// Source: EN 1993-1-5:2006, 9.3.3(3).
Force buckling_shear_of(const ShearPanel& panel, double gamma_M1);
Traced derive_buckling_shear(Derivation& steps, const ShearPanel& panel, double gamma_M1);

/// The factor on all loads at which a plate under normal stress and shear is used up.
///
///     eta_3 <= 0.5: eta_1 <= 1,  else eta_1 + part (2 eta_3 - 1)^2 <= 1
///
/// 7.1(5), for flanges and for webs that are compressed all over, part = 1: eta_1 the use of the
/// section by normal stress, of effective widths; on the safe side for other webs. 7.1(1): eta_1 =
/// M/M_pl, part = 1 - M_f/M_pl above zero (`PlasticBox`). eta_3 = V/V_bw,Rd. Infinity where nothing
/// acts. Source: EN 1993-1-5:2006, 7.1, equation 7.1.
double interaction_factor(double eta_1, double eta_3, double part = 1.0);
Traced derive_interaction_factor(Derivation& steps, const Traced& eta_1, const Traced& eta_3);

}  // namespace boxbeam
