#include "boxbeam/strength/column_buckling.hpp"

#include "column_formulas.hpp"

namespace boxbeam {

const char* to_text(BucklingCurve curve) {
  switch (curve) {
    case BucklingCurve::a0: return "a0";
    case BucklingCurve::a: return "a";
    case BucklingCurve::b: return "b";
    case BucklingCurve::c: return "c";
    case BucklingCurve::d: return "d";
  }
  return "";
}

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
  return column::euler_force(plainly, youngs_modulus, inertia, buckling_length);
}

}  // namespace boxbeam
