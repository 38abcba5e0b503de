#include "boxbeam/strength/shear_lag.hpp"

#include <cmath>

#include "catch.hpp"

namespace shear_lag_test {

using namespace boxbeam;

namespace {

Length m(double x) { return si<Length>(x); }

constexpr BendingRegion regions[] = {BendingRegion::sagging, BendingRegion::hogging,
                                     BendingRegion::end_support, BendingRegion::cantilever};

/// Change of the factor where a branch ends, relative.
double jump(BendingRegion region, double kappa) {
  const double behind = std::nextafter(kappa, 10.0);
  return shear_lag_factor(behind, region) / shear_lag_factor(kappa, region) - 1.0;
}

}  // namespace

TEST_CASE("shear lag counts from b_0 = L_e/50 on") {
  // A beam pivoted in its middle with arms of 3.1 m: 6.2 m between the zeros of the moment.
  CHECK_FALSE(shear_lag_counts(m(0.1239), m(6.2)));
  CHECK(shear_lag_counts(m(0.124), m(6.2)));
  CHECK(shear_lag_counts(m(0.2), m(6.2)));
}

TEST_CASE("kappa: the share of the length, more with stiffeners") {
  CHECK(shear_lag_kappa(m(0.5), m(0.02), si<Area>(0.0), m(5.0)) == Approx(0.1).epsilon(1e-14));
  // Stiffeners of thrice the flange: alpha_0 = sqrt(1 + 3) = 2.
  CHECK(shear_lag_kappa(m(0.5), m(0.02), si<Area>(0.03), m(5.0)) == Approx(0.2).epsilon(1e-14));
}

TEST_CASE("beta by hand at kappa 0.01, 0.1, 0.5 and 1, EN 1993-1-5 table 3.1") {
  for (const BendingRegion region : regions) CHECK(shear_lag_factor(0.01, region) == 1.0);
  CHECK(shear_lag_factor(0.1, BendingRegion::sagging) == Approx(1 / 1.064).epsilon(1e-14));
  CHECK(shear_lag_factor(0.5, BendingRegion::sagging) == Approx(1 / 2.6).epsilon(1e-14));
  CHECK(shear_lag_factor(1.0, BendingRegion::sagging) == Approx(1 / 5.9).epsilon(1e-14));
  // 1 + 6 (0.1 - 0.004) + 0.016; 1 + 6 (0.5 - 0.0008) + 0.4.
  CHECK(shear_lag_factor(0.1, BendingRegion::hogging) == Approx(1 / 1.592).epsilon(1e-14));
  CHECK(shear_lag_factor(0.5, BendingRegion::hogging) == Approx(1 / 4.3952).epsilon(1e-14));
  CHECK(shear_lag_factor(1.0, BendingRegion::hogging) == Approx(1 / 8.6).epsilon(1e-14));
  CHECK(shear_lag_factor(0.0203, BendingRegion::end_support) ==
        shear_lag_factor(0.0203, BendingRegion::sagging));
  // 0.55 + 0.25 = 0.8 and 0.55 + 0.05 = 0.6 of beta_1.
  CHECK(shear_lag_factor(0.1, BendingRegion::end_support) == Approx(0.8 / 1.064).epsilon(1e-14));
  CHECK(shear_lag_factor(0.5, BendingRegion::end_support) == Approx(0.6 / 2.6).epsilon(1e-14));
}

TEST_CASE("beta: the jumps of the standard's own branches are the stated ones") {
  CHECK(jump(BendingRegion::sagging, 0.02) == Approx(-0.00255).margin(1e-5));
  CHECK(jump(BendingRegion::sagging, 0.70) == Approx(+0.00145).margin(1e-5));
  CHECK(jump(BendingRegion::hogging, 0.02) == Approx(-0.00064).margin(1e-5));
  CHECK(jump(BendingRegion::hogging, 0.70) == Approx(-0.00655).margin(1e-5));
  // beta_0 leaves beta_1 at kappa = 0.025/0.45, steadily.
  CHECK(std::abs(jump(BendingRegion::end_support, 0.025 / 0.45)) < 1e-12);
}

TEST_CASE("beta falls with kappa, apart from the jump of 0.15 % at 0.70") {
  for (const BendingRegion region : regions) {
    for (double kappa = 0.001; kappa < 3.0; kappa += 0.001) {
      const double here = shear_lag_factor(kappa, region);
      const double next = shear_lag_factor(kappa + 0.001, region);
      CAPTURE(kappa);
      CHECK(next <= here * (kappa < 0.7 && kappa + 0.001 > 0.7 ? 1.0015 : 1.0));
      CHECK(next > 0.0);
      CHECK(next <= 1.0);
    }
  }
}

TEST_CASE("beta: a flange works less over a support than in the span") {
  for (double kappa = 0.03; kappa < 3.0; kappa += 0.01) {
    CAPTURE(kappa);
    const double span = shear_lag_factor(kappa, BendingRegion::sagging);
    CHECK(shear_lag_factor(kappa, BendingRegion::hogging) < span);
    const double end = shear_lag_factor(kappa, BendingRegion::end_support);
    CHECK((kappa < 0.025 / 0.45 ? end == span : end < span));
    CHECK(shear_lag_factor(kappa, BendingRegion::cantilever) ==
          shear_lag_factor(kappa, BendingRegion::hogging));
  }
}

}  // namespace shear_lag_test
