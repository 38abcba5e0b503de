#include "boxbeam/strength/shear_buckling.hpp"

#include <algorithm>
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

TEST_CASE("resistance to shear: web of 2720 x 18 mm, a = 8 m", "[validation]") {
  // JRC, Bridge design to Eurocodes (2012), p. 130: k_tau = 5.8024, V_bw,Rd = 4.44 MN.
  ShearPanel panel{2.720 * metre, 0.018 * metre, 345e6 * pascal, 8.0 * metre, true};
  const ShearResistance of = shear_resistance_of(panel, 1.1);
  CHECK(of.k_tau == Approx(5.8024).margin(5e-5));
  CHECK(of.lambda_w == Approx(2.033).margin(1e-3));
  CHECK(of.chi_w == Approx(0.501).margin(5e-4));
  CHECK(of.resistance.value() == Approx(4.44e6).epsilon(2e-3));
}

TEST_CASE("resistance to shear: web of 1000 x 12 mm, a = 600 mm", "[validation]") {
  // Published tests of an open program (eurocodedesign): k_tau = 18.833, lambda_w = 0.631, S355.
  const ShearResistance of =
      shear_resistance_of({1.0 * metre, 0.012 * metre, 355e6 * pascal, 0.6 * metre}, 1.0);
  CHECK(of.k_tau == Approx(18.833).margin(1e-3));
  CHECK(of.lambda_w == Approx(0.631).margin(1e-3));
}

TEST_CASE("resistance to shear: 1200 x 8 mm of S355, end posts rigid or not") {
  // By hand: k_tau = 5.34 + 4 (1.2/3)^2 = 5.98; 150/(37.4 sqrt(235/355) sqrt(5.98)) = 2.016.
  ShearPanel panel{1.2 * metre, 0.008 * metre, 355e6 * pascal, 3.0 * metre};
  ShearResistance of = shear_resistance_of(panel, 1.0);
  CHECK(of.k_tau == Approx(5.98));
  CHECK(of.lambda_w == Approx(2.016).margin(5e-4));
  CHECK(of.chi_w == Approx(0.412).margin(5e-4));
  CHECK(of.resistance.value() == Approx(810e3).epsilon(1e-3));
  panel.rigid_end_post = true;
  CHECK(shear_resistance_of(panel, 1.0).resistance.value() == Approx(993e3).epsilon(1e-3));
  // Without stiffeners: h_w/(86.4 t eps), 5.3(3).
  panel.length.reset();
  CHECK(shear_resistance_of(panel, 1.0).lambda_w ==
        Approx(150.0 / (86.4 * std::sqrt(235.0 / 355.0))).epsilon(5e-4));
}

TEST_CASE("resistance to shear: longer and thinner panels never bear more") {
  for (const bool rigid : {false, true}) {
    double last = 1e300;
    for (double length = 0.3; length < 12.0; length *= 1.05) {
      const double now =
          shear_resistance_of({1.0 * metre, 0.006 * metre, 355e6 * pascal, length * metre, rigid},
                              1.0)
              .resistance.value();
      CHECK(now <= last * (1.0 + 1e-12));
      last = now;
    }
    last = 0.0;
    for (double t = 0.002; t < 0.04; t *= 1.02) {
      const double now =
          shear_resistance_of({1.0 * metre, t * metre, 355e6 * pascal, {}, rigid}, 1.0)
              .resistance.value();
      CHECK(now >= last);
      // Never above what it bears when it yields, with strain hardening.
      CHECK(now <= 1.2 * 355e6 * t / std::sqrt(3.0) * (1.0 + 1e-12));
      last = now;
    }
  }
}

TEST_CASE("normal stress and shear together: f eta_1 + (2 f eta_3 - 1)^2 = 1") {
  for (const double eta_1 : {0.0, 0.1, 0.5, 0.9, 1.3}) {
    for (const double eta_3 : {0.0, 0.1, 0.4, 0.7, 1.0, 1.6}) {
      if (eta_1 == 0.0 && eta_3 == 0.0) continue;
      CAPTURE(eta_1, eta_3);
      const double f = interaction_factor(eta_1, eta_3);
      const double over = std::max(0.0, 2.0 * f * eta_3 - 1.0);
      CHECK(f * eta_1 + over * over == Approx(1.0));
      CHECK(f * eta_3 <= 1.0 + 1e-12);
    }
  }
  CHECK(std::isinf(interaction_factor(0.0, 0.0)));
}

}  // namespace shear_buckling_test
