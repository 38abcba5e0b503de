#pragma once

#include <optional>

#include "boxbeam/core/units.hpp"
#include "boxbeam/strength/weld_throat.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// How a force comes to a web and where it goes from there.
/// Source: EN 1993-1-5:2006, 6.1(4), figure 6.1.
enum class ForceEntry {
  one_flange,    ///< type a: through one flange, borne by shear in the web
  both_flanges,  ///< type b: through one flange and out through the other
  near_end,      ///< type c: through one flange near an end without a stiffener
};

/// A web between two flanges, one of which leads a force into it.
struct PatchedWeb {
  Length depth, thickness;  ///< clear depth h_w
  Stress yield_strength;
  Length flange_thickness;
  /// The loaded flange's width that is the web's, over the web and on both sides of it; of it at
  /// most 15 eps t_f beside each face of the web counts. Source: 6.5(1).
  Length flange_inside, flange_outside;
  Stress flange_strength;
  Length stiff_length;  ///< s_s on the flange (6.3); of it at most h_w counts
  ForceEntry entry = ForceEntry::one_flange;
  /// Between the stiffeners or diaphragms on both sides; nothing: so far apart that they do not
  /// help.
  std::optional<Length> length = {};
  Length to_end;  ///< c, from the stiff length to the end of the beam; of `near_end` only
  /// The force pulls at that flange: the web yields, and does not buckle.
  bool pulled = false;
};

/// The width of a web's edge over which a force comes in, s_s + 2 t_f <= a.
///
/// By a slope of 1:1 through the flange, EN 1993-1-5, 6.3 and 3.2.3 (the spread beyond the edge
/// left out).
Length loaded_length_of(const PatchedWeb& web);

/// What a web bears under a force across the beam.
struct PatchResistance {
  double k_F = 0.0, m_1 = 0.0, m_2 = 0.0, lambda_F = 0.0, chi_F = 0.0;
  Force F_cr;
  Length l_y;
  Force resistance;  ///< F_Rd
};

/// Resistance of a web to a force across the beam that a flange leads into it.
///
///     k_F    a: 6 + 2 (h_w/a)^2,  b: 3.5 + 2 (h_w/a)^2,  c: 2 + 6 (s_s + c)/h_w <= 6
///     F_cr   = 0.9 k_F E t^3/h_w
///     m_1    = f_yf b_f/(f_yw t),  m_2 = 0.02 (h_w/t_f)^2 where lambda_F > 0.5, else 0
///     l_y    a, b: s_s + 2 t_f (1 + sqrt(m_1 + m_2)) <= a
///            c: the least of that, l_e + t_f sqrt(m_1/2 + (l_e/t_f)^2 + m_2) and
///            l_e + t_f sqrt(m_1 + m_2),  l_e = k_F E t^2/(2 f_yw h_w) <= s_s + c
///     lambda_F = sqrt(l_y t f_yw/F_cr),  chi_F = 0.5/lambda_F <= 1
///     F_Rd   = chi_F f_yw l_y t/gamma_M1
///
/// E = 210 GPa. Stiffeners along the web are left out, on the safe side (6.4(2)). Where m_2 ends,
/// at lambda_F = 0.5, F_Rd jumps, as the standard's own does. Source: EN 1993-1-5:2006, 6.2 to 6.5.
PatchResistance patch_resistance_of(const PatchedWeb& web, double gamma_M1);

/// F_cr step by step.
Traced derive_critical_force(Derivation& steps, const PatchedWeb& web);

/// F_Rd step by step.
Traced derive_patch_resistance(Derivation& steps, const PatchedWeb& web, double gamma_M1);

/// The factor on all loads at which a web under a force and the beam's own stress is used up:
/// eta_2 <= 1 and eta_2 + 0.8 eta_1 <= 1.4, eta_2 = F/F_Rd. Source: EN 1993-1-5:2006, 6.6 and 7.2.
double patch_factor(double eta_2, double eta_1);
Traced derive_patch_factor(Derivation& steps, const Traced& eta_2, const Traced& eta_1);

/// A web where a diaphragm takes a force from a flange: the diaphragm's part beside the web, of a
/// single web on both sides of it, and strips of the web, as a column that bends out of the web.
struct BearingStiffener {
  Length web_depth, web_thickness;
  Length web_before, web_behind;  ///< what there is of the web beside the diaphragm
  Length thickness, width;        ///< of the diaphragm; of what of it is the web's, on one side
  Stress yield_strength;          ///< the lower one of both
  bool both_sides = false;
  bool ends_clamped = true;  ///< by flanges that do not give way sideways
  bool bows = false;  ///< on one side alone, nothing holds it against bending by eccentricity
};

/// N_b,Rd of that column.
///
///     15 eps t of the web on each side, 15 eps t_d of the diaphragm as an outstand part (9.1(2));
///     curve c, length 0.75 h_w between flanges that do not give way, else h_w (9.4(2))
///
///     flats on one side, by a force in the middle of the web at e from the centroid of it and
///     them, n + (1 + 0.6 min(lambda, 1) n) n chi A e/W = 1,  N = n N_b,Rd
///
/// W elastic, at the farther edge. Else eccentricity is not counted, for the diaphragm holds two
/// webs against each other, and flats on both sides of one are alike; that it is held along the
/// flanges is left out, on the safe side. Source: EN 1993-1-5:2006, 9.1, 9.4(3); EN 1993-1-1:2005,
/// 6.3.3, equation 6.61, table B.1 (C_m = 1).
Force bearing_resistance_of(const BearingStiffener& stiffener, double gamma_M1);
Traced derive_bearing_resistance(Derivation& steps, const BearingStiffener& stiffener,
                                 double gamma_M1);

/// The fillet welds on both faces of a diaphragm, or of flats, that lead a force into a web.
struct StiffenerWeld {
  bool to_flange = false;  ///< from the flange that it comes by; else along the web
  int welds = 2;
  Length throat, length;
  WeldStrength strength;
  /// What else goes through them, square to the force: how much they are used by it over how much
  /// by the force.
  double beside = 0.0;
};

/// What they bear, with what else goes through them over sqrt(1 + k^2), of a weld's length less a
/// throat at each end:
///
///     along the web  n a (l - 2 a) f_u/(sqrt(3) beta_w gamma_M2)
///     with the flange, across them, no contact  n a (l - 2 a) f_u/(sqrt(2) beta_w gamma_M2)
///
/// Source: EN 1993-1-8:2005, 4.5.1(1), 4.5.3.2(6), equation 4.1.
Force stiffener_weld_resistance_of(const StiffenerWeld& weld);
Traced derive_stiffener_weld_resistance(Derivation& steps, const StiffenerWeld& weld);

/// The throat with which they bear a force, no less than the least one; nothing where none does,
/// for thicker welds are shorter.
std::optional<Length> sufficient_throat_of(const StiffenerWeld& weld, Force force);

/// The factor on all loads at which a stiffener of panels is used up by a force F that comes in and
/// by what a web beyond its buckling in shear pulls at it.
///
///     F <= N_b,Rd,  F + N_st <= N_b,Rd,  N_st = V_Ed - V_cr (`buckling_shear_of`)
///
/// Source: EN 1993-1-5:2006, 9.3.3(3), 9.4.
double stiffener_factor(Force comes_in, Force shear, Force buckling_shear, Force resistance);
Traced derive_stiffener_factor(Derivation& steps, const Traced& comes_in, const Traced& shear,
                               const Traced& buckling_shear, const Traced& resistance);

}  // namespace boxbeam
