// Stiffeners across a web: published least second moments, and those of flats.

#include "boxbeam/strength/transverse_stiffener.hpp"

#include <cmath>

#include "catch.hpp"

namespace transverse_stiffener_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

}  // namespace

// h_w = 1800, t = 14 mm: 24.00e6 mm^4 with a = 1000 mm, 3.704e6 mm^4 with a = 3000 mm. Source:
// EN 1993-1-5, 9.3.3(3), in muellvin/BA, proofs_and_stress_calculation.
TEST_CASE("rigid stiffeners of a web of 1800 x 14, published", "[validation]") {
  CHECK(rigid_stiffener_inertia(mm(1800), mm(14), mm(1000)).value() ==
        Approx(24.00e-6).epsilon(5e-4));
  CHECK(rigid_stiffener_inertia(mm(1800), mm(14), mm(3000)).value() ==
        Approx(3.704e-6).epsilon(5e-4));
  // The laws meet at a = sqrt(2) h_w, and a longer panel never asks for more.
  const double meet = 1800.0 * std::sqrt(2.0);
  CHECK(rigid_stiffener_inertia(mm(1800), mm(14), mm(meet * (1.0 - 1e-9))).value() ==
        Approx(rigid_stiffener_inertia(mm(1800), mm(14), mm(meet * (1.0 + 1e-9))).value()));
  double before = 1.0;
  for (double a = 500.0; a < 4000.0; a += 100.0) {
    const double least = rigid_stiffener_inertia(mm(1800), mm(14), mm(a)).value();
    CHECK(least <= before);
    before = least;
  }
}

TEST_CASE("flats beside a web about its middle") {
  // Web 10, flats 100 x 12: 12 x (210^3 - 10^3)/12 of both, half of it of one.
  CHECK(stiffener_inertia(mm(10), mm(100), mm(12), true).value() ==
        Approx((std::pow(210.0, 3) - 1000.0) * 1e-12));
  CHECK(stiffener_inertia(mm(10), mm(100), mm(12), false).value() ==
        Approx(0.5 * (std::pow(210.0, 3) - 1000.0) * 1e-12));
}

}  // namespace transverse_stiffener_test
