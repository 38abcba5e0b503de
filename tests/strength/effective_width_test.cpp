#include "boxbeam/strength/effective_width.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

namespace effective_width_test {

using namespace boxbeam;

namespace {

const auto tip = LargestCompression::at_tip;
const auto support = LargestCompression::at_support;

Length m(double x) { return si<Length>(x); }

/// The next number above.
double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

}  // namespace

TEST_CASE("k_sigma of internal parts, the values printed in EN 1993-1-5 table 4.1") {
  CHECK(*internal_buckling_factor(1.0) == 4.0);
  CHECK(*internal_buckling_factor(0.0) == 7.81);
  CHECK(*internal_buckling_factor(-1.0) == 23.9);
  CHECK(*internal_buckling_factor(-3.0) == Approx(5.98 * 16).epsilon(1e-14));
}

TEST_CASE("k_sigma of outstand parts, the values printed in EN 1993-1-5 table 4.2") {
  CHECK(*outstand_buckling_factor(1.0, tip) == Approx(0.43).epsilon(1e-12));
  CHECK(*outstand_buckling_factor(0.0, tip) == Approx(0.57).epsilon(1e-12));
  CHECK(*outstand_buckling_factor(-1.0, tip) == Approx(0.85).epsilon(1e-12));
  CHECK(*outstand_buckling_factor(1.0, support) == Approx(0.43).epsilon(1e-12));
  CHECK(*outstand_buckling_factor(0.0, support) == Approx(1.70).epsilon(1e-12));
  CHECK(*outstand_buckling_factor(-1.0, support) == Approx(23.8).epsilon(1e-12));
}

TEST_CASE("k_sigma: the branches meet at psi = 1, 0 and -1 to 0.1 % and 0.4 %") {
  for (const double psi : {0.0, -1.0}) {
    CAPTURE(psi);
    CHECK(*internal_buckling_factor(above(psi)) ==
          Approx(*internal_buckling_factor(psi)).epsilon(1e-3));
    CHECK(*internal_buckling_factor(-above(-psi)) ==
          Approx(*internal_buckling_factor(psi)).epsilon(1e-3));
    CHECK(*outstand_buckling_factor(above(psi), support) ==
          Approx(*outstand_buckling_factor(psi, support)).epsilon(1e-9));
  }
  const double below_1 = std::nextafter(1.0, 0.0);
  CHECK(*internal_buckling_factor(below_1) == Approx(4.0).epsilon(1e-12));
  CHECK(*outstand_buckling_factor(below_1, support) == Approx(0.43).epsilon(4e-3));
}

TEST_CASE("k_sigma falls as the compression spreads over the part") {
  for (double psi = -2.99; psi < 1.0; psi += 0.01) {
    const double next = std::fmin(1.0, psi + 0.01);
    CAPTURE(psi);
    CHECK(*internal_buckling_factor(next) < *internal_buckling_factor(psi));
    CHECK(*outstand_buckling_factor(next, tip) < *outstand_buckling_factor(psi, tip));
    if (psi < -1.0) continue;
    CHECK(*outstand_buckling_factor(next, support) < *outstand_buckling_factor(psi, support));
    // A plate held at its tip too is stiffer, a plate compressed most at its tip is weaker.
    CHECK(*outstand_buckling_factor(psi, support) < *internal_buckling_factor(psi));
    CHECK(*outstand_buckling_factor(psi, tip) <=
          *outstand_buckling_factor(psi, support) * (1 + 1e-12));
  }
}

TEST_CASE("k_sigma outside the standard's range is not answered") {
  CHECK_FALSE(internal_buckling_factor(-3.001));
  CHECK_FALSE(outstand_buckling_factor(-3.001, tip));
  CHECK_FALSE(outstand_buckling_factor(-1.001, support));
  CHECK_FALSE(internal_effective_width(m(1), m(0.01), -3.001, 0.8));
  CHECK_FALSE(outstand_effective_width(m(1), m(0.01), -1.001, support, 0.8));
}

TEST_CASE("lambda_p is sqrt(f_y/sigma_cr) of a plate of steel") {
  // sigma_cr = k pi^2 E t^2/[12 (1 - nu^2) b^2], E = 210 GPa, nu = 0.3; 28.4 is rounded.
  const double pi = 3.14159265358979;
  for (const double k : {0.43, 4.0, 23.9}) {
    const double slenderness = 60.0;
    const double critical = k * pi * pi * 210e9 / (12 * (1 - 0.09) * slenderness * slenderness);
    CHECK(relative_plate_slenderness(slenderness, std::sqrt(235.0 / 355.0), k) ==
          Approx(std::sqrt(355e6 / critical)).epsilon(1e-3));
  }
}

TEST_CASE("rho: 1 up to the limit 0.673 (psi = 1) or 0.874 (psi = -1), continuous there") {
  CHECK(internal_reduction(0.673, 1.0) == 1.0);
  CHECK(internal_reduction(0.674, 1.0) < 1.0);
  CHECK(internal_reduction(0.874, -1.0) == 1.0);
  CHECK(internal_reduction(0.875, -1.0) < 1.0);
  for (double psi = -3.0; psi <= 1.0; psi += 0.25) {
    const double limit = 0.5 + std::sqrt(0.085 - 0.055 * psi);
    CAPTURE(psi);
    CHECK(internal_reduction(above(limit), psi) == Approx(1.0).epsilon(1e-12));
  }
  CHECK(outstand_reduction(above(0.748)) == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("rho of outstand parts by hand: (lambda - 0.188)/lambda^2") {
  CHECK(outstand_reduction(0.7) == 1.0);
  CHECK(outstand_reduction(0.76) == Approx(0.572 / 0.5776).epsilon(1e-12));
  CHECK(outstand_reduction(1.0) == Approx(0.812).epsilon(1e-12));
  CHECK(outstand_reduction(2.0) == Approx(0.453).epsilon(1e-12));
}

TEST_CASE("rho falls with slenderness, at psi = 1 by Winter's curve") {
  for (double lambda = 0.4; lambda < 5.0; lambda += 0.01) {
    CAPTURE(lambda);
    CHECK(internal_reduction(lambda + 0.01, 1.0) <= internal_reduction(lambda, 1.0));
    CHECK(outstand_reduction(lambda + 0.01) <= outstand_reduction(lambda));
    CHECK(internal_reduction(lambda, 1.0) <= internal_reduction(lambda, -1.0));
    // Winter (1947): (1 - 0.22/lambda)/lambda, which is equation 4.2 at psi = 1.
    if (lambda > 0.7) {
      CHECK(internal_reduction(lambda, 1.0) == Approx((1 - 0.22 / lambda) / lambda).epsilon(1e-12));
    }
  }
}

TEST_CASE("effective width: a stout plate keeps its compressed width") {
  const auto even = *internal_effective_width(m(0.3), m(0.03), 1.0, 0.81);
  CHECK(even.b_e1.value() == Approx(0.15).epsilon(1e-14));
  CHECK(even.b_e2.value() == Approx(0.15).epsilon(1e-14));
  const auto bent = *internal_effective_width(m(0.3), m(0.03), -1.0, 0.81);
  CHECK(bent.b_eff.value() == Approx(0.15).epsilon(1e-14));
  CHECK(bent.b_e1.value() == Approx(0.06).epsilon(1e-14));
  CHECK(bent.b_e2.value() == Approx(0.09).epsilon(1e-14));
  const auto uneven = *internal_effective_width(m(0.3), m(0.03), 0.25, 0.81);
  CHECK(uneven.b_e1.value() == Approx(0.3 * 2 / 4.75).epsilon(1e-14));
  CHECK(uneven.b_e2.value() == Approx(0.3 * 2.75 / 4.75).epsilon(1e-14));
  CHECK(outstand_effective_width(m(0.2), m(0.03), 1.0, tip, 0.81)->b_eff == m(0.2));
  CHECK(outstand_effective_width(m(0.2), m(0.03), -1.0, tip, 0.81)->b_eff == m(0.1));
  CHECK(outstand_effective_width(m(0.2), m(0.03), -1.0, support, 0.81)->b_eff == m(0.1));
}

TEST_CASE("effective width: its two shares change steadily through psi = 0") {
  const auto at = *internal_effective_width(m(1.0), m(0.01), 0.0, 0.81);
  const auto below = *internal_effective_width(m(1.0), m(0.01), -1e-9, 0.81);
  const auto over = *internal_effective_width(m(1.0), m(0.01), 1e-9, 0.81);
  CHECK(below.b_e1.value() == Approx(at.b_e1.value()).epsilon(1e-4));
  CHECK(below.b_e2.value() == Approx(at.b_e2.value()).epsilon(1e-4));
  CHECK(over.b_e1.value() == Approx(at.b_e1.value()).epsilon(1e-4));
  CHECK(over.b_e2.value() == Approx(at.b_e2.value()).epsilon(1e-4));
}

TEST_CASE("effective width: twice the plate, twice the width; never more than is compressed") {
  for (double psi = -3.0; psi <= 1.0; psi += 0.125) {
    const auto one = *internal_effective_width(m(1.0), m(0.01), psi, 0.81);
    const auto two = *internal_effective_width(m(2.0), m(0.02), psi, 0.81);
    CAPTURE(psi);
    CHECK(two.b_e1.value() == Approx(2 * one.b_e1.value()).epsilon(1e-14));
    CHECK((one.b_e1 + one.b_e2).value() == Approx(one.b_eff.value()).epsilon(1e-14));
    CHECK(one.b_eff.value() <= 1.0 / std::fmax(1.0, 1.0 - psi) * (1 + 1e-14));
    const auto outstand = *outstand_effective_width(m(1.0), m(0.01), psi, tip, 0.81);
    CHECK(outstand.b_eff < one.b_eff);
    CHECK(outstand.b_e1 == outstand.b_eff);
    CHECK(outstand.b_e2.value() == 0.0);
  }
}

}  // namespace effective_width_test
