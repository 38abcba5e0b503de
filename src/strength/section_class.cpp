#include "boxbeam/strength/section_class.hpp"

#include <cassert>
#include <cmath>

#include "plate_formulas.hpp"

namespace boxbeam {

int class_of(double slenderness, const ClassLimits& limits) {
  if (slenderness <= limits.class_1) return 1;
  if (slenderness <= limits.class_2) return 2;
  if (slenderness <= limits.class_3) return 3;
  return 4;
}

double epsilon_of(Stress yield_strength) { return plate::epsilon(plainly, yield_strength); }

ClassLimits internal_part_limits(double alpha, double psi, double epsilon) {
  assert(alpha >= 0.0 && alpha <= 1.0);
  assert(psi <= 1.0);
  // The branches do not meet; in pure bending rounding must not choose between them.
  constexpr double rounding = 1e-9;
  ClassLimits limits;
  if (alpha > 0.5 + rounding) {
    limits.class_1 = 396.0 * epsilon / (13.0 * alpha - 1.0);
    limits.class_2 = 456.0 * epsilon / (13.0 * alpha - 1.0);
  } else {
    limits.class_1 = 36.0 * epsilon / alpha;
    limits.class_2 = 41.5 * epsilon / alpha;
  }
  limits.class_3 = psi > -1.0 + rounding ? 42.0 * epsilon / (0.67 + 0.33 * psi)
                                         : 62.0 * epsilon * (1.0 - psi) * std::sqrt(-psi);
  return limits;
}

ClassLimits outstand_flange_limits(double epsilon) {
  return {9.0 * epsilon, 10.0 * epsilon, 14.0 * epsilon};
}

ClassLimits outstand_part_limits(double alpha, double psi, LargestCompression where,
                                 double epsilon) {
  assert(alpha > 0.0 && alpha <= 1.0);
  const double pressed = where == LargestCompression::at_tip ? alpha : alpha * std::sqrt(alpha);
  const ClassLimits even = outstand_flange_limits(epsilon);
  constexpr double rounding = 1e-9;
  return {even.class_1 / pressed, even.class_2 / pressed,
          psi > 1.0 - rounding ? even.class_3
                               : 21.0 * epsilon * std::sqrt(*outstand_buckling_factor(psi, where))};
}

ClassLimits round_tube_limits(double epsilon) {
  const double epsilon_2 = epsilon * epsilon;
  return {50.0 * epsilon_2, 70.0 * epsilon_2, 90.0 * epsilon_2};
}

}  // namespace boxbeam
