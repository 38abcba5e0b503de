#pragma once

#include <cmath>
#include <numbers>

#include "boxbeam/core/derivation.hpp"

namespace boxbeam {

/// Stresses in the throat of a fillet weld, the plane through its root that halves the angle of the
/// legs. The direct stress along the weld does not count.
struct ThroatStress {
  Stress normal;        ///< sigma_perp, across the throat plane
  Stress shear_across;  ///< tau_perp, in the plane, across the weld
  Stress shear_along;   ///< tau_par, in the plane, along the weld
};

/// Force per length that a plate puts on one of its welds to another plate at a right angle.
struct WeldForce {
  ForcePerLength off_plate;    ///< pulls the plate off the other
  ForcePerLength along_plate;  ///< pulls it away from this weld, parallel to the other
  ForcePerLength along_weld;
};

/// Throat stresses of a weld with legs of equal length, its force through the throat's middle.
///
///     sigma_perp = (q_off + q_along)/(sqrt(2) a),  tau_perp = (q_off - q_along)/(sqrt(2) a)
///     tau_par = q_weld/a
///
/// a  throat thickness. Source: equilibrium; EN 1993-1-8:2005, figure 4.5.
ThroatStress throat_stress_of(const WeldForce& force, Length throat);

/// What resists in a weld, and its partial factor (the standard's recommended one).
struct WeldStrength {
  Stress tensile_strength;  ///< f_u of the weaker part joined
  double beta_w = 1.0;      ///< correlation factor, EN 1993-1-8:2005, table 4.1
  double gamma_M2 = 1.25;
};

/// Utilisation of a fillet weld by the directional method, both conditions.
struct DirectionalUtilisation {
  double combined = 0.0;  ///< sqrt(sigma_perp^2 + 3 (tau_perp^2 + tau_par^2)) beta_w gamma_M2/f_u
  double normal = 0.0;    ///< |sigma_perp| gamma_M2/(0.9 f_u)

  double largest() const { return combined > normal ? combined : normal; }
};

/// Source: EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1.
DirectionalUtilisation directional_utilisation(const ThroatStress& stress,
                                               const WeldStrength& strength);

/// The least throat of a fillet weld, 3 mm. Source: EN 1993-1-8:2005, 4.5.2(2).
Length least_throat();

/// The equivalent stress that a throat bears, f_u/(beta_w gamma_M2).
/// Source: EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1.
template <class Record>
auto weld_strength(Record& record, const WeldStrength& of) {
  const auto f_u = record.known("f_u", of.tensile_strength);
  const auto beta_w = record.known("beta_w", of.beta_w, {ValueKind::factor});
  const auto gamma_M2 = record.known("gamma_M2", of.gamma_M2, {ValueKind::factor});
  return record.define("limit", f_u / (beta_w * gamma_M2));
}

/// The shear stress along a throat that it bears alone, also the design shear strength of a fillet
/// weld, f_vw.d = f_u/(sqrt(3) beta_w gamma_M2).
/// Source: EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1, and 4.5.3.3(3), equation 4.4.
template <class Record>
auto weld_shear_strength(Record& record, const WeldStrength& of) {
  const auto sqrt_3 = record.constant("sqrt(3)", std::numbers::sqrt3);
  const auto f_u = record.known("f_u", of.tensile_strength);
  const auto beta_w = record.known("beta_w", of.beta_w, {ValueKind::factor});
  const auto gamma_M2 = record.known("gamma_M2", of.gamma_M2, {ValueKind::factor});
  return record.define("limit", f_u / (sqrt_3 * beta_w * gamma_M2));
}

Stress weld_shear_strength(const WeldStrength& strength);

/// Equivalent stress in the throat of a weld with legs of equal length, whose sigma_perp and
/// tau_perp are sigma_w/sqrt(2) each.
///
///     sigma_v = sqrt(2 sigma_w^2 + 3 tau_par^2)
///
/// sigma_w  force across the weld over the throat. Source: EN 1993-1-8:2005, equation 4.1.
template <class Value>
Value equal_leg_stress(const Value& sigma_w, const Value& tau_par) {
  using std::sqrt;
  return sqrt(2.0 * sigma_w * sigma_w + 3.0 * tau_par * tau_par);
}

}  // namespace boxbeam
