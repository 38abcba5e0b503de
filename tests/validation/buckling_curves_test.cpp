// Reduction factors as tabulated in ENV 1993-1-1:1992, table 5.5.2 (same curves as EN 1993-1-1;
// the values are recalled).

#include "boxbeam/strength/column_buckling.hpp"
#include "catch.hpp"

namespace buckling_curves_test {

using namespace boxbeam;

TEST_CASE("buckling curves: tabulated reduction factors at lambda 0.5, 1 and 2", "[validation]") {
  constexpr BucklingCurve curves[] = {BucklingCurve::a, BucklingCurve::b, BucklingCurve::c,
                                      BucklingCurve::d};
  // lambda; curves a, b, c, d.
  const double table[][5] = {{0.5, 0.9243, 0.8842, 0.8430, 0.7793},
                             {1.0, 0.6656, 0.5970, 0.5399, 0.4671},
                             {2.0, 0.2229, 0.2095, 0.1962, 0.1766}};
  for (const auto& row : table) {
    for (int k = 0; k < 4; ++k) {
      CAPTURE(row[0], k);
      CHECK(column_reduction(row[0], curves[k]) == Approx(row[k + 1]).margin(6e-5));
    }
  }
}

}  // namespace buckling_curves_test
