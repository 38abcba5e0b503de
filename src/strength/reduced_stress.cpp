#include "boxbeam/strength/reduced_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/strength/effective_width.hpp"
#include "plate_formulas.hpp"

namespace boxbeam {

ReducedStress reduced_stress_of(const ShearPanel& panel, Stress compression, Stress tension,
                                double psi, Stress shear, double gamma_M1) {
  constexpr NoDerivation plainly;
  const double f_y = panel.yield_strength.value();
  const double sigma = std::max(0.0, compression.value());
  const double tau = std::abs(shear.value());
  const double largest = std::max(sigma, tension.value());
  ReducedStress of;
  of.alpha_ult = f_y / std::hypot(largest, std::sqrt(3.0) * tau);
  const double sigma_E = plate_euler_stress(panel.depth / panel.thickness).value();
  const double k_tau = shear_resistance_of(panel, gamma_M1).k_tau;
  const double by_shear = tau / (k_tau * sigma_E);
  double by_normal = 0.0;
  if (sigma > 0.0) by_normal = sigma / (*internal_buckling_factor(psi) * sigma_E);
  const double linear = 0.25 * (1.0 + psi) * by_normal;
  const double inverse =
      linear +
      std::sqrt(linear * linear + 0.5 * (1.0 - psi) * by_normal * by_normal + by_shear * by_shear);
  of.alpha_cr = inverse > 0.0 ? 1.0 / inverse : std::numeric_limits<double>::infinity();
  of.lambda = std::sqrt(of.alpha_ult / of.alpha_cr);
  if (sigma > 0.0) of.rho_x = boxbeam::internal_reduction(of.lambda, psi);
  of.chi_w = plate::shear_reduction(plainly, of.lambda, 1.0, panel.rigid_end_post);
  const double reduced = std::max(sigma / of.rho_x, tension.value());
  of.use = std::hypot(reduced, std::sqrt(3.0) * tau / of.chi_w) * gamma_M1 / f_y;
  return of;
}

}  // namespace boxbeam
