#include "boxbeam/strength/effective_width.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "plate_formulas.hpp"

namespace boxbeam {

std::optional<double> internal_buckling_factor(double psi) {
  assert(psi <= 1.0);
  if (psi == 1.0) return 4.0;
  if (psi > 0.0) return 8.2 / (1.05 + psi);
  if (psi > -1.0) return 7.81 + psi * (-6.29 + psi * 9.78);
  if (psi == -1.0) return 23.9;
  if (psi >= -3.0) return 5.98 * (1.0 - psi) * (1.0 - psi);
  return std::nullopt;
}

std::optional<double> outstand_buckling_factor(double psi, LargestCompression where) {
  assert(psi <= 1.0);
  if (where == LargestCompression::at_tip) {
    if (psi < -3.0) return std::nullopt;
    return 0.57 + psi * (-0.21 + psi * 0.07);
  }
  if (psi == 1.0) return 0.43;
  if (psi > 0.0) return 0.578 / (psi + 0.34);
  if (psi >= -1.0) return 1.7 + psi * (-5.0 + psi * 17.1);
  return std::nullopt;
}

Stress plate_euler_stress(double width_to_thickness) {
  return 190e9 * pascal / (width_to_thickness * width_to_thickness);
}

double relative_plate_slenderness(double width_to_thickness, double epsilon, double k_sigma) {
  return plate::slenderness(plainly, width_to_thickness, epsilon, k_sigma);
}

double internal_reduction(double lambda_p, double psi) {
  assert(psi >= -3.0 && psi <= 1.0);
  if (lambda_p <= 0.5 + std::sqrt(0.085 - 0.055 * psi)) return 1.0;
  return plate::internal_reduction(plainly, lambda_p, psi);
}

double internal_reduction(double lambda_p, double psi, const StressLevel& level) {
  const double lambda_red = lambda_p * std::sqrt(level.share);
  const double rho = internal_reduction(lambda_red, psi);
  if (!level.annex_E || rho == 1.0) return rho;
  return std::min(
      1.0, plate::annex_E_reduction(plainly, lambda_p, lambda_red, plate::internal_loss(psi)));
}

double outstand_reduction(double lambda_p) {
  if (lambda_p <= 0.748) return 1.0;
  return std::min(1.0, plate::outstand_reduction(plainly, lambda_p));
}

double outstand_reduction(double lambda_p, const StressLevel& level) {
  const double lambda_red = lambda_p * std::sqrt(level.share);
  const double rho = outstand_reduction(lambda_red);
  if (!level.annex_E || rho == 1.0) return rho;
  return std::min(1.0,
                  plate::annex_E_reduction(plainly, lambda_p, lambda_red, plate::outstand_loss));
}

std::optional<EffectiveWidth> internal_effective_width(Length width, Length thickness, double psi,
                                                       double epsilon) {
  const auto k_sigma = internal_buckling_factor(psi);
  if (!k_sigma) return std::nullopt;
  EffectiveWidth result;
  result.k_sigma = *k_sigma;
  result.lambda_p = relative_plate_slenderness(width / thickness, epsilon, *k_sigma);
  result.rho = internal_reduction(result.lambda_p, psi);
  result.b_eff = result.rho * width / std::max(1.0, 1.0 - psi);
  result.b_e1 = (psi >= 0.0 ? 2.0 / (5.0 - psi) : 0.4) * result.b_eff;
  result.b_e2 = result.b_eff - result.b_e1;
  return result;
}

std::optional<EffectiveWidth> outstand_effective_width(Length width, Length thickness, double psi,
                                                       LargestCompression where, double epsilon,
                                                       const StressLevel& level) {
  const auto k_sigma = outstand_buckling_factor(psi, where);
  if (!k_sigma) return std::nullopt;
  EffectiveWidth result;
  result.k_sigma = *k_sigma;
  result.lambda_p = relative_plate_slenderness(width / thickness, epsilon, *k_sigma);
  result.rho = outstand_reduction(result.lambda_p, level);
  result.b_eff = result.rho * width / std::max(1.0, 1.0 - psi);
  result.b_e1 = result.b_eff;
  return result;
}

}  // namespace boxbeam
