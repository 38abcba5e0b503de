#include "boxbeam/strength/hole_concentration.hpp"

#include "catch.hpp"

namespace hole_factors_test {

using namespace boxbeam;

TEST_CASE("a vanishing hole triples the membrane stress, one as wide as the plate doubles it") {
  // Kirsch; the thin ligament beside a wide hole.
  CHECK(membrane_concentration(0.0) == Approx(3.0).epsilon(2e-3));
  CHECK(membrane_concentration(1.0) == Approx(2.0).epsilon(1e-15));
}

TEST_CASE("the membrane factor falls with the width of the hole, on the gross section it rises") {
  for (double a = 0.0; a < 0.9; a += 0.01) {
    CAPTURE(a);
    CHECK(membrane_concentration(a + 0.01) < membrane_concentration(a));
    // The fit begins level, 1e-4 off.
    if (a > 0.015)
      CHECK(membrane_concentration(a + 0.01) / (0.99 - a) > membrane_concentration(a) / (1 - a));
  }
}

TEST_CASE("the published formula at d/w = 0.145 gives 2.424, not the 2.66 printed in the thesis") {
  CHECK(published_concentration(0.145) == Approx(2.424).margin(5e-4));
  // 2.66 belongs to a slipped decimal, d/w = 0.0145.
  CHECK(published_concentration(0.0145) == Approx(2.66).margin(5e-3));
}

TEST_CASE("plate bending: 3 for a narrow hole in a thick plate, 1.79 for a wide one in a thin") {
  // The hole in a half-space under a surface stress triples it; Kirchhoff's plate with nu = 0.3.
  CHECK(*plate_bending_concentration(0.0, 0.0) == Approx(3.0).epsilon(0.01));
  CHECK(*plate_bending_concentration(1e6, 0.0) == Approx((5 + 3 * 0.3) / (3 + 0.3)).epsilon(2e-3));
}

TEST_CASE("plate bending: the factor by hand at d/h = 1 and 1/2, d/w = 0 and 0.2") {
  // 1.79 + 0.25/1.39 + 0.405 - 0.13; 1.79 + 0.25/0.89 + 0.648 - 0.26/1.125; 1 - 0.208 + 0.0488.
  CHECK(*plate_bending_concentration(1.0, 0.0) == Approx(2.2448561).epsilon(1e-7));
  CHECK(*plate_bending_concentration(0.5, 0.0) == Approx(2.4877878).epsilon(1e-7));
  CHECK(*plate_bending_concentration(1.0, 0.2) == Approx(2.2448561 * 0.8408).epsilon(1e-7));
}

TEST_CASE("plate bending: the factor falls with d/h and stays between the two limits") {
  double before = *plate_bending_concentration(0.0, 0.0);
  for (double k = 0.05; k < 20.0; k += 0.05) {
    const double factor = *plate_bending_concentration(k, 0.0);
    CAPTURE(k);
    CHECK(factor < before);
    CHECK(factor > 1.79);
    before = factor;
  }
}

TEST_CASE("plate bending: the net factor falls with d/w, the gross one rises beyond a small hole") {
  for (double a = 0.0; a < 0.285; a += 0.01) {
    CAPTURE(a);
    const double here = *plate_bending_concentration(1.0, a);
    const double next = *plate_bending_concentration(1.0, a + 0.01);
    CHECK(next < here);
    if (a > 0.05) CHECK(next / (0.99 - a) > here / (1 - a));
  }
}

TEST_CASE("plate bending outside d/w < 0.3 is not answered") {
  CHECK(plate_bending_concentration(1.0, 0.299));
  CHECK_FALSE(plate_bending_concentration(1.0, 0.3));
  CHECK_FALSE(plate_bending_concentration(-1.0, 0.1));
}

}  // namespace hole_factors_test
