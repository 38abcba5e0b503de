#include "boxbeam/fatigue/size_effect.hpp"

#include <cmath>

#include "catch.hpp"

namespace size_effect_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

}  // namespace

TEST_CASE("size factor of a butt weld, EN 1993-1-9 equation 7.1 worked by hand", "[size_effect]") {
  CHECK(size_factor_of_butt_weld(mm(40)) == Approx(0.9103).margin(5e-5));
  CHECK(size_factor_of_butt_weld(mm(60)) == Approx(0.8394).margin(5e-5));
  CHECK(size_factor_of_butt_weld(mm(800)) == Approx(0.5).epsilon(1e-12));  // 32 times 25 mm: 2^-1
}

TEST_CASE("size factor of an offset butt weld, EN 1993-1-9 table 8.3 detail 17 worked by hand",
          "[size_effect]") {
  CHECK(size_factor_of_eccentric_butt_weld(mm(20), mm(30), mm(5)) == Approx(0.65415).margin(5e-6));
  // Equal plates, offset by a third of the thickness: 1/(1 + 6/3 * 1/2).
  CHECK(size_factor_of_eccentric_butt_weld(mm(24), mm(24), mm(8)) == Approx(0.5).epsilon(1e-12));
}

TEST_CASE("without an offset a butt weld of two thicknesses has the factor of the thinner plate",
          "[size_effect]") {
  for (const double thickness : {8.0, 25.0, 31.0, 80.0}) {
    for (const double ratio : {1.0, 1.5, 4.0}) {
      CHECK(size_factor_of_eccentric_butt_weld(mm(thickness), mm(ratio * thickness), mm(0)) ==
            Approx(size_factor_of_butt_weld(mm(thickness))).epsilon(1e-14));
    }
  }
}

TEST_CASE("size factor of a bolt: 1 up to 30 mm, 1/2 at sixteen times that", "[size_effect]") {
  CHECK(size_factor_of_bolt(mm(480)) == Approx(0.5).epsilon(1e-12));
  CHECK(size_factor_of_bolt(mm(30)) == 1.0);
  CHECK(size_factor_of_bolt(mm(12)) == 1.0);
}

TEST_CASE("a size factor begins at 1 without a jump and falls with the size", "[size_effect]") {
  CHECK(size_factor_of_butt_weld(mm(5)) == 1.0);
  CHECK(size_factor_of_butt_weld(mm(25)) == 1.0);
  CHECK(size_factor_of_butt_weld(mm(25.0001)) == Approx(1.0).margin(1e-6));
  CHECK(size_factor_of_bolt(mm(30.0001)) == Approx(1.0).margin(1e-6));
  for (double size = 30; size < 200; size += 10) {
    CHECK(size_factor_of_butt_weld(mm(size + 10)) < size_factor_of_butt_weld(mm(size)));
    CHECK(size_factor_of_bolt(mm(size + 10)) < size_factor_of_bolt(mm(size)));
    CHECK(size_factor_of_eccentric_butt_weld(mm(20), mm(40), mm(0.1 * size + 1)) <
          size_factor_of_eccentric_butt_weld(mm(20), mm(40), mm(0.1 * size)));
  }
}

}  // namespace size_effect_test
