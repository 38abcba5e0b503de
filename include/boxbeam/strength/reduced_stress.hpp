#pragma once

#include "boxbeam/strength/shear_buckling.hpp"

namespace boxbeam {

/// A plate judged by reduced stresses.
struct ReducedStress {
  double alpha_ult = 0.0;  ///< f_y over the equivalent stress
  double alpha_cr = 0.0;   ///< critical over acting stresses; infinity where nothing can buckle
  double lambda = 0.0;     ///< sqrt(alpha_ult/alpha_cr), of all reductions
  double rho_x = 1.0, chi_w = 1.0;
  double use = 0.0;  ///< of both reduced stresses together: 1 is the limit
};

/// Use of a plate under normal stress along the beam and shear, nothing redistributed.
///
///     1/alpha_cr = p + sqrt(p^2 + (1 - psi)/(2 a_x^2) + 1/a_tau^2),  p = (1 + psi)/(4 a_x)
///     a_x = k_sigma sigma_E/sigma,  a_tau = k_tau sigma_E/tau
///     use = sqrt([sigma/rho_x]^2 + 3 [tau/chi_w]^2) gamma_M1/f_y
///
/// compression  at the edge that is compressed more; not above zero: only shear can buckle it
/// tension      at the edge that is stretched most, whose yielding counts as well
/// psi          smaller over larger edge stress, compression positive, at least -3
///
/// chi_w is at most 1: strain hardening is no part of an equivalent stress. Source: EN
/// 1993-1-5:2006, clause 10, equations 10.1, 10.2, 10.5 and 10.6, annex A.1; the use is the root
/// of 10.5.
ReducedStress reduced_stress_of(const ShearPanel& panel, Stress compression, Stress tension,
                                double psi, Stress shear, double gamma_M1);

}  // namespace boxbeam
