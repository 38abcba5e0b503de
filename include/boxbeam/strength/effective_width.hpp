#pragma once

#include <optional>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// The edge of an outstand part at which its compression is largest.
enum class LargestCompression { at_tip, at_support };

/// Buckling factor k_sigma of a part supported at both edges under linear stress.
///
///     psi = 1: 4,  1 > psi > 0: 8.2/(1.05 + psi),  0: 7.81,
///     0 > psi > -1: 7.81 - 6.29 psi + 9.78 psi^2,  -1: 23.9,  -1 > psi >= -3: 5.98 (1 - psi)^2
///
/// psi  smaller over larger edge stress, compression positive, at most 1
///
/// The branches meet to 0.1 %. Nothing is returned below psi = -3, where the standard gives no
/// value. Source: EN 1993-1-5:2006, table 4.1.
std::optional<double> internal_buckling_factor(double psi);

/// Buckling factor k_sigma of an outstand part under linear stress.
///
///     at tip:      1 >= psi >= -3: 0.57 - 0.21 psi + 0.07 psi^2
///     at support:  psi = 1: 0.43,  1 > psi > 0: 0.578/(psi + 0.34),  0: 1.70,
///                  0 > psi > -1: 1.7 - 5 psi + 17.1 psi^2,  -1: 23.8
///
/// psi as above. The branches meet to 0.4 %. Nothing is returned outside. Source: EN 1993-1-5:2006,
/// table 4.2.
std::optional<double> outstand_buckling_factor(double psi, LargestCompression where);

/// Critical stress of a long plate for k = 1, sigma_E = 190 GPa (t/b)^2.
/// Source: EN 1993-1-5:2006, annex A.1(2).
Stress plate_euler_stress(double width_to_thickness);

/// Relative slenderness of a plate, sqrt(f_y/sigma_cr).
///
///     lambda_p = (b/t) / (28.4 eps sqrt(k_sigma))
///
/// Source: EN 1993-1-5:2006, 4.4(2).
double relative_plate_slenderness(double width_to_thickness, double epsilon, double k_sigma);

/// Reduction factor of a part supported at both edges.
///
///     lambda_p <= 0.5 + sqrt(0.085 - 0.055 psi): 1,  else [lambda_p - 0.055 (3 + psi)]/lambda_p^2
///
/// Valid for -3 <= psi <= 1. Source: EN 1993-1-5:2006 + AC:2009, 4.4(2), equation 4.2.
double internal_reduction(double lambda_p, double psi);

/// By which stress plates are taken to buckle.
enum class WidthRule {
  at_yield,     ///< 4.4(2)
  below_yield,  ///< the one that is there, 4.4(4)
  annex_E,      ///< the same, by annex E
};

/// The stress that is there.
struct StressLevel {
  double share = 1.0;    ///< sigma_com,Ed/(f_y/gamma_M0), at most 1
  bool annex_E = false;  ///< else 4.4(4)
};

/// Reduction factor of a part supported at both edges below yield, lambda_red = lambda_p
/// sqrt(share).
///
///     4.4(4):  that of lambda_red
///     annex E: [1 - 0.055 (3 + psi)/lambda_red]/lambda_red + 0.18 (lambda_p -
///     lambda_red)/(lambda_p
///              - 0.6) <= 1; 1 where that of lambda_red is
///
/// Source: EN 1993-1-5:2006, 4.4(4), E.1, equation E.1.
double internal_reduction(double lambda_p, double psi, const StressLevel& level);

/// Reduction factor of an outstand part, at most 1.
///
///     lambda_p <= 0.748: 1,  else (lambda_p - 0.188)/lambda_p^2
///
/// Source: EN 1993-1-5:2006, 4.4(2), equation 4.3.
double outstand_reduction(double lambda_p);

/// The same below yield.
///
///     annex E: (1 - 0.188/lambda_red)/lambda_red + 0.18 (lambda_p - lambda_red)/(lambda_p - 0.6)
///              <= 1; 1 where that of lambda_red is
///
/// Source: EN 1993-1-5:2006, 4.4(4), E.1, equation E.2.
double outstand_reduction(double lambda_p, const StressLevel& level);

/// What is left of the compressed width of a plate.
struct EffectiveWidth {
  double k_sigma = 0.0;
  double lambda_p = 0.0;
  double rho = 1.0;
  Length b_eff;  ///< of the compressed width
  Length b_e1;   ///< the share at the edge of the larger compression
  Length b_e2;   ///< the share at the other edge, or at the neutral axis where psi < 0
};

/// Effective width of a part supported at both edges.
///
///     psi >= 0: b_eff = rho b,  b_e1 = 2 b_eff/(5 - psi)
///     psi < 0:  b_eff = rho b/(1 - psi),  b_e1 = 0.4 b_eff
///     b_e2 = b_eff - b_e1
///
/// The width in tension, b - b/(1 - psi), is effective besides. Source: EN 1993-1-5:2006,
/// table 4.1.
std::optional<EffectiveWidth> internal_effective_width(Length width, Length thickness, double psi,
                                                       double epsilon);

/// Effective width of an outstand part, in one piece (b_e1; b_e2 = 0): the tip falls away.
///
///     psi >= 0: b_eff = rho c,  psi < 0: b_eff = rho c/(1 - psi)
///
/// It lies at the support, or beside the width in tension where that is at the support. Source: EN
/// 1993-1-5:2006, table 4.2.
std::optional<EffectiveWidth> outstand_effective_width(Length width, Length thickness, double psi,
                                                       LargestCompression where, double epsilon,
                                                       const StressLevel& level = {});

}  // namespace boxbeam
