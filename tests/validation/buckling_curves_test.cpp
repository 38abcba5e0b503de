// Reduction factors of the European buckling curves as the lecture notes of ESDEP print them (5.2,
// basis of the ECCS buckling curves, table 1), quoted by the tests of a public skill for steel
// supports: EN 1993-1-1 has the same curves.

#include "boxbeam/strength/column_buckling.hpp"
#include "catch.hpp"
#include "src/strength/column_formulas.hpp"

namespace buckling_curves_test {

using namespace boxbeam;

TEST_CASE("buckling curves: tabulated reduction factors at lambda 0.3 to 3", "[validation]") {
  constexpr BucklingCurve curves[] = {BucklingCurve::a, BucklingCurve::b, BucklingCurve::c,
                                      BucklingCurve::d};
  // lambda; curves a, b, c, d.
  const double table[][5] = {
      {0.3, 0.9775, 0.9641, 0.9491, 0.9235}, {0.5, 0.9243, 0.8842, 0.8430, 0.7793},
      {0.8, 0.7957, 0.7245, 0.6622, 0.5797}, {1.0, 0.6656, 0.5970, 0.5399, 0.4671},
      {1.5, 0.3724, 0.3422, 0.3145, 0.2766}, {2.0, 0.2229, 0.2095, 0.1962, 0.1766},
      {3.0, 0.1036, 0.0994, 0.0951, 0.0882}};
  for (const auto& row : table) {
    for (int k = 0; k < 4; ++k) {
      CAPTURE(row[0], k);
      CHECK(column::reduction(plainly, row[0], curves[k]) == Approx(row[k + 1]).margin(6e-5));
    }
  }
}

}  // namespace buckling_curves_test
