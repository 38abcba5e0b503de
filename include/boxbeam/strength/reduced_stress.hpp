#pragma once

#include <array>
#include <optional>

#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/shear_buckling.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// What a force across the beam does to a plate that it comes into through an edge.
struct EdgeForce {
  Stress stress;          ///< sigma_z, on the width over which it comes in; it pushes
  double critical = 0.0;  ///< alpha_cr,z = F_cr/F
  /// sigma_x at the edges where sigma_z acts, compression positive; of one that is borne by shear
  /// both are the loaded one.
  std::array<Stress, 2> along;
};

/// What acts on a plate at once.
struct PanelStress {
  Stress compression = {};  ///< sigma_x at the edge that is compressed more; 0 where none is
  Stress tension = {};      ///< at the edge that is stretched most, whose yielding counts as well
  double psi = 1.0;         ///< smaller over larger edge stress, compression positive, at least -3
  Stress shear = {};        ///< of either sign
  std::optional<EdgeForce> across = {};
  /// Of a plate with a free edge: where its compression is largest; psi at least -3 and -1 then.
  std::optional<LargestCompression> outstand = {};
};

/// A plate judged by reduced stresses.
struct ReducedStress {
  double alpha_ult = 0.0;  ///< f_y over the equivalent stress; infinity where nothing acts
  double alpha_cr = 0.0;   ///< critical over acting stresses; infinity where nothing can buckle
  double lambda = 0.0;     ///< sqrt(alpha_ult/alpha_cr), of all reductions
  double rho_x = 1.0, rho_z = 1.0, chi_w = 1.0;
  double use = 0.0;  ///< of all reduced stresses together: 1 is the limit

  /// Whether buckling has a part in it.
  bool reduced() const { return rho_x < 1.0 || rho_z < 1.0 || chi_w < 1.0; }
};

/// Use of a plate without stiffeners under normal stress along the beam, shear and a force across,
/// nothing redistributed.
///
///     alpha_ult = f_y/sqrt(sigma_x^2 + sigma_z^2 - sigma_x sigma_z + 3 tau^2)
///     p_x = sigma_x/(k_sigma sigma_E),  p_tau = tau/(k_tau sigma_E),  p_z = F/F_cr
///     1/alpha_cr = m + sqrt(m^2 + (1 - psi)/2 p_x^2 + p_tau^2),  m = (1 + psi)/4 p_x + p_z/2
///     lambda = sqrt(alpha_ult/alpha_cr), of each reduction
///     use = sqrt(x^2 + z^2 - V x z + 3 [tau/chi_w]^2) gamma_M1/f_y,  x = sigma_x/rho_x,
///           z = sigma_z/rho_z,  V = rho_x rho_z where both press;  of sigma_x in tension
///           x = sigma_x, V = 1
///
/// Looked at are the edge that is compressed more and the one that is stretched most, and the
/// edges where sigma_z acts, with their own sigma_x. rho_x as of effective widths (equation 4.2),
/// where the panel is short between plate and column (4.5.4). chi_w is at most 1: strain hardening
/// is no part of an equivalent stress. An outstand has k_sigma of table 4.2 and rho_x of equation
/// 4.3; shear counts in its equivalent stresses alone, for which the standard has no k_tau. psi_z
/// is taken as 1, with which p_x and p_z add up, on the safe side. rho_z is that of welded plates
/// under transverse stress:
///
///     lambda <= 0.8: 1,  else 1/(phi_p + sqrt(phi_p^2 - lambda)),
///     phi_p = (1 + 0.34 (lambda - 0.8) + lambda)/2
///
/// Source: EN 1993-1-5:2006, clause 10, equations 10.1 to 10.6, annex A.1; the use is the root
/// of 10.5, V that of A1:2017. Annex B.1 with table B.1 for rho_z, and V, are recalled, not
/// confirmed.
ReducedStress reduced_stress_of(const ShearPanel& panel, const PanelStress& stress,
                                double gamma_M1);

/// That use step by step, from the stresses on: sigma_x (the edge that is compressed more), sigma_t
/// (that stretched most), tau, sigma_z and sigma_x,F beside it (at a second edge sigma_x,G) are to
/// be said before. Precondition: something acts.
Traced derive_reduced_use(Derivation& steps, const ShearPanel& panel, const PanelStress& stress,
                          double gamma_M1);

}  // namespace boxbeam
