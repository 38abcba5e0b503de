#include "boxbeam/strength/weld_throat.hpp"

#include <cmath>
#include <numbers>

namespace boxbeam {

ThroatStress throat_stress_of(const WeldForce& force, Length throat) {
  const Length oblique = std::numbers::sqrt2 * throat;
  return {(force.off_plate + force.along_plate) / oblique,
          (force.off_plate - force.along_plate) / oblique, force.along_weld / throat};
}

DirectionalUtilisation directional_utilisation(const ThroatStress& stress,
                                               const WeldStrength& strength) {
  const double normal = stress.normal.value();
  const double equivalent = std::hypot(normal, std::numbers::sqrt3 * stress.shear_across.value(),
                                       std::numbers::sqrt3 * stress.shear_along.value());
  const double f_u = strength.tensile_strength.value() / strength.gamma_M2;
  return {equivalent * strength.beta_w / f_u, std::abs(normal) / (0.9 * f_u)};
}

Length least_throat() { return si<Length>(0.003); }

Stress weld_shear_strength(const WeldStrength& strength) {
  return weld_shear_strength(plainly, strength);
}

}  // namespace boxbeam
