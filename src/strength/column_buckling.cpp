#include "boxbeam/strength/column_buckling.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace boxbeam {

double imperfection_factor(BucklingCurve curve) {
  switch (curve) {
    case BucklingCurve::a0: return 0.13;
    case BucklingCurve::a: return 0.21;
    case BucklingCurve::b: return 0.34;
    case BucklingCurve::c: return 0.49;
    case BucklingCurve::d: return 0.76;
  }
  return 0.76;
}

Force euler_force(Stress youngs_modulus, SecondMoment inertia, Length buckling_length) {
  constexpr double pi_2 = std::numbers::pi * std::numbers::pi;
  return pi_2 * youngs_modulus * inertia / (buckling_length * buckling_length);
}

double column_slenderness(Area area, Stress yield_strength, Force critical_force) {
  return std::sqrt((area * yield_strength).value() / critical_force.value());
}

double column_reduction(double slenderness, BucklingCurve curve) {
  assert(slenderness >= 0.0);
  if (slenderness <= 0.2) return 1.0;
  const double lambda_2 = slenderness * slenderness;
  const double phi = 0.5 * (1.0 + imperfection_factor(curve) * (slenderness - 0.2) + lambda_2);
  return 1.0 / (phi + std::sqrt(phi * phi - lambda_2));
}

Force buckling_resistance(Area area, Stress yield_strength, Force critical_force,
                          BucklingCurve curve, double gamma_M1) {
  const double slenderness = column_slenderness(area, yield_strength, critical_force);
  return column_reduction(slenderness, curve) * area * yield_strength / gamma_M1;
}

}  // namespace boxbeam
