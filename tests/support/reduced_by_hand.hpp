#pragma once

#include <algorithm>
#include <cmath>

#include "support/buckling_curve.hpp"

/// Clause 10 of EN 1993-1-5 written out once more, for tests: MPa and mm, compression positive.
namespace reduced_by_hand {

struct Plate {
  double b, t, f_y;
  double a = 0.0;  ///< 0: long
  bool rigid_end_post = false;
};

struct Acting {
  double more, less, tau;           ///< edge stresses along the beam, `more` the larger
  double z = 0.0, F_by_F_cr = 0.0;  ///< across, and its part of the critical one
  double along_z = 0.0;             ///< the edge stress where it comes in
};

inline double rho(double lambda, double psi) {
  const bool stout = lambda <= 0.5 + std::sqrt(0.085 - 0.055 * psi);
  return stout ? 1.0 : (lambda - 0.055 * (3.0 + psi)) / (lambda * lambda);
}

inline double k_sigma(double psi) {
  if (psi >= 0.0) return 8.2 / (1.05 + psi);
  return psi > -1.0 ? 7.81 - 6.29 * psi + 9.78 * psi * psi : 5.98 * (1.0 - psi) * (1.0 - psi);
}

inline double mises(double x, double z, double tau, double V = 1.0) {
  return std::sqrt(x * x + z * z - V * x * z + 3.0 * tau * tau);
}

/// gamma_M1 = 1.
inline double use(const Plate& of, const Acting& on) {
  const double psi = on.more > 0.0 ? std::max(-3.0, on.less / on.more) : 1.0;
  const double sigma_E = 190e3 * (of.t / of.b) * (of.t / of.b);
  const double ratio = of.a > 0.0 ? of.b / of.a : 0.0;
  const double k_tau = ratio <= 1.0 ? 5.34 + 4.0 * ratio * ratio : 4.0 + 5.34 * ratio * ratio;
  const double p_x = std::max(0.0, on.more) / (k_sigma(psi) * sigma_E);
  const double p_tau = on.tau / (k_tau * sigma_E);
  const double m = 0.25 * (1.0 + psi) * p_x + 0.5 * on.F_by_F_cr;
  const double p = m + std::sqrt(m * m + 0.5 * (1.0 - psi) * p_x * p_x + p_tau * p_tau);
  double v = std::max(mises(on.more, 0.0, on.tau), mises(on.less, 0.0, on.tau));
  if (on.z > 0.0) v = std::max(v, mises(on.along_z, on.z, on.tau));
  const double lambda = std::sqrt(of.f_y / v * p);
  double rho_x = rho(lambda, psi);
  if (of.a > 0.0) {
    // Between plate and column, 4.5.4: sigma_cr,p/sigma_cr,c = k (a/b)^2.
    const double xi = std::clamp(k_sigma(psi) / (ratio * ratio) - 1.0, 0.0, 1.0);
    const double chi_c = test::chi_of(lambda, 0.21);
    rho_x = (rho_x - chi_c) * xi * (2.0 - xi) + chi_c;
  }
  double chi_w = lambda < 0.83 ? 1.0 : 0.83 / lambda;
  if (of.rigid_end_post && lambda >= 1.08) chi_w = 1.37 / (0.7 + lambda);
  const double phi_p = 0.5 * (1.0 + 0.34 * (lambda - 0.8) + lambda);
  const double rho_z = lambda <= 0.8 ? 1.0 : 1.0 / (phi_p + std::sqrt(phi_p * phi_p - lambda));
  const auto x = [&](double stress) { return stress > 0.0 ? stress / rho_x : stress; };
  const double tau = on.tau / chi_w;
  double worst = std::max(mises(x(on.more), 0.0, tau), mises(x(on.less), 0.0, tau));
  // 10(5) with A1:2017: V = rho_x rho_z where both press.
  const double V = on.along_z > 0.0 ? rho_x * rho_z : 1.0;
  if (on.z > 0.0) worst = std::max(worst, mises(x(on.along_z), on.z / rho_z, tau, V));
  return worst / of.f_y;
}

}  // namespace reduced_by_hand
