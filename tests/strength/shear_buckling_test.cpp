#include "boxbeam/strength/shear_buckling.hpp"

#include <cmath>

#include "catch.hpp"

namespace shear_buckling_test {

using namespace boxbeam;

namespace {

Length m(double x) { return si<Length>(x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }

}  // namespace

TEST_CASE("shear buckling: S355 from 48.8, with eta = 1 from 58.6") {
  const auto recommended =
      shear_buckling_need(m(0.5), m(0.01), MPa(355), shear_hardening_factor(MPa(355)));
  CHECK(recommended.ratio == Approx(50.0).epsilon(1e-14));
  CHECK(recommended.limit == Approx(48.8).margin(0.05));
  CHECK(recommended.check_needed());
  const auto annex = shear_buckling_need(m(0.5), m(0.01), MPa(355), 1.0);
  CHECK(annex.limit == Approx(58.6).margin(0.05));
  CHECK_FALSE(annex.check_needed());
}

TEST_CASE("shear buckling: eta is 1.2 up to and including S460") {
  CHECK(shear_hardening_factor(MPa(235)) == 1.2);
  CHECK(shear_hardening_factor(MPa(460)) == 1.2);
  CHECK(shear_hardening_factor(MPa(461)) == 1.0);
}

TEST_CASE("shear buckling: at the limit a long web of steel buckles at eta times its shear yield") {
  // tau_cr = 5.34 pi^2 E/[12 (1 - nu^2)] (t/h)^2 against tau_y = f_y/sqrt(3): the relative
  // slenderness is 0.83/eta there (table 5.1), by 37.4 eps sqrt(k_tau) for E = 210 GPa.
  const double pi = 3.14159265358979;
  for (const double eta : {1.0, 1.2}) {
    const double ratio = shear_buckling_need(m(1), m(1), MPa(355), eta).limit;
    const double critical = 5.34 * pi * pi * 210e3 / (12 * 0.91 * ratio * ratio);
    CAPTURE(eta);
    CHECK(std::sqrt(355 / std::sqrt(3.0) / critical) == Approx(0.83 / eta).epsilon(0.005));
  }
}

}  // namespace shear_buckling_test
