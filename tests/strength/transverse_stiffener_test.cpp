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

TEST_CASE("flats beside a web, with 15 eps t of it, about the centroid of both") {
  // Web 10, flats 100 x 12, S235: 2 x 150 + 12 = 312 mm of the web.
  BearingStiffener flats{mm(1000),          mm(10), mm(3000), mm(3000), mm(12), mm(100),
                         si<Stress>(235e6), true,   true};
  // Both: 12 x (210^3 - 10^3)/12 + 312 x 10^3/12 = 9.286e6.
  CHECK(stiffener_inertia(flats).value() == Approx(9.286e-6).epsilon(1e-9));
  // One: A = 3120 and 1200, 55 apart: 26e3 + 12 x 100^3/12 + 3120 x 1200/4320 x 55^2 = 3.6477e6;
  // about the web's middle it would be 4.63e6 without the web.
  flats.both_sides = false;
  CHECK(stiffener_inertia(flats).value() == Approx(3.64766667e-6).epsilon(1e-8));
  // At the end of the beam there is web on one side alone.
  flats.web_before = Length{};
  CHECK(stiffener_inertia(flats).value() ==
        Approx(1e-12 * (162e3 / 12.0 + 1e6 + 1620.0 * 1200.0 / 2820.0 * 3025.0)).epsilon(1e-9));
}

}  // namespace transverse_stiffener_test
