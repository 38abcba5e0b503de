#include "boxbeam/strength/shear_buckling.hpp"

#include "boxbeam/strength/section_class.hpp"

namespace boxbeam {

double shear_hardening_factor(Stress yield_strength) {
  return yield_strength.value() <= 460e6 ? 1.2 : 1.0;
}

ShearBucklingNeed shear_buckling_need(Length clear_depth, Length thickness, Stress yield_strength,
                                      double eta) {
  return {clear_depth / thickness, 72.0 * epsilon_of(yield_strength) / eta};
}

}  // namespace boxbeam
