#include "boxbeam/strength/shear_lag.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

double beta_1(double kappa) {
  if (kappa <= 0.02) return 1.0;
  if (kappa <= 0.7) return 1.0 / (1.0 + 6.4 * kappa * kappa);
  return 1.0 / (5.9 * kappa);
}

double beta_2(double kappa) {
  if (kappa <= 0.02) return 1.0;
  if (kappa > 0.7) return 1.0 / (8.6 * kappa);
  return 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
}

}  // namespace

bool shear_lag_counts(Length b_0, Length L_e) { return b_0 >= L_e / 50.0; }

double shear_lag_kappa(Length b_0, Length thickness, Area stiffeners, Length L_e) {
  const double stiffened = stiffeners / (b_0 * thickness);
  return std::sqrt(1.0 + stiffened) * (b_0 / L_e);
}

double shear_lag_factor(double kappa, BendingRegion region) {
  switch (region) {
    case BendingRegion::sagging: return beta_1(kappa);
    case BendingRegion::end_support:
      return kappa <= 0.02 ? 1.0 : std::min(1.0, 0.55 + 0.025 / kappa) * beta_1(kappa);
    case BendingRegion::hogging:
    case BendingRegion::cantilever: return beta_2(kappa);
  }
  return 1.0;
}

}  // namespace boxbeam
