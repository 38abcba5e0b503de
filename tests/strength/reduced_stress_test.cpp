// Reduced stresses of plates, beside figures computed by hand and what must hold for every plate.

#include "boxbeam/strength/reduced_stress.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "boxbeam/strength/effective_width.hpp"
#include "catch.hpp"

namespace reduced_stress_test {

using namespace boxbeam;

namespace {

Stress MPa(double x) { return si<Stress>(1e6 * x); }

/// 1200 x 8 mm of S355, 3 m between stiffeners.
const ShearPanel web{1.2 * metre, 0.008 * metre, 355e6 * pascal, 3.0 * metre};

}  // namespace

TEST_CASE("reduced stress: web of the reference box under 1500 kN m and 400 kN, by hand") {
  // I = 8049.94e6 mm^4, the web's upper edge 646.11 mm from the centroid: 120.4 MPa, psi = -0.857;
  // 400e3/9600 = 41.7 MPa. Given: 0.79 by the least reduction, 0.73 by equation 10.5.
  const double sigma = 1500e6 * 646.11 / 8049.94e6;
  const double psi = -(1200.0 - 646.11) / 646.11;
  const ReducedStress of =
      reduced_stress_of(web, MPa(sigma), MPa(-sigma * psi), psi, MPa(400e3 / 9600.0), 1.0);
  CHECK(1.0 / (std::min(of.rho_x, of.chi_w) * of.alpha_ult) == Approx(0.79).margin(0.005));
  CHECK(of.use == Approx(0.73).margin(0.005));
}

TEST_CASE("reduced stress: even compression alone is rho of its slenderness") {
  // Given: the whole reference box bears 3573 kN, its webs' 102 MPa.
  const double lambda = 1.2 / 0.008 / (28.4 * std::sqrt(235.0 / 355.0) * 2.0);
  const ReducedStress of = reduced_stress_of(web, MPa(100.0), {}, 1.0, {}, 1.0);
  CHECK(of.lambda == Approx(lambda).epsilon(2e-3));
  CHECK(of.rho_x == Approx(internal_reduction(lambda, 1.0)).epsilon(2e-3));
  CHECK(100e6 / of.use * 35040e-6 == Approx(3573e3).epsilon(2e-3));
}

TEST_CASE("reduced stress: shear alone is the web's own resistance, below yield") {
  const ReducedStress of = reduced_stress_of(web, {}, {}, 1.0, MPa(30.0), 1.0);
  const ShearResistance resists = shear_resistance_of(web, 1.0);
  CHECK(of.lambda == Approx(resists.lambda_w).epsilon(2e-3));
  CHECK(of.use == Approx(30e6 * 1.2 * 0.008 / resists.resistance.value()).epsilon(2e-3));
}

TEST_CASE("reduced stress: stout plates are von Mises', and tension never buckles") {
  const ShearPanel stout{0.2 * metre, 0.02 * metre, 345e6 * pascal, {}};
  CHECK(reduced_stress_of(stout, MPa(100.0), MPa(50.0), -0.5, MPa(60.0), 1.0).use ==
        Approx(std::hypot(100.0, std::sqrt(3.0) * 60.0) / 345.0));
  const ReducedStress pulled = reduced_stress_of(web, {}, MPa(200.0), 1.0, {}, 1.0);
  CHECK(pulled.use == Approx(200.0 / 355.0));
  CHECK(std::isinf(pulled.alpha_cr));
}

TEST_CASE("reduced stress: more load and a thinner plate are never used less") {
  std::mt19937 random(7);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int i = 0; i < 500; ++i) {
    ShearPanel panel{in(0.3, 2.0) * metre, in(0.004, 0.02) * metre, 355e6 * pascal, {}};
    const double psi = in(-3.0, 1.0), sigma = in(1.0, 300.0), tau = in(0.0, 150.0);
    const auto use = [&](double part) {
      return reduced_stress_of(panel, MPa(part * sigma), MPa(std::max(0.0, -psi * part * sigma)),
                               psi, MPa(part * tau), 1.0)
          .use;
    };
    const double now = use(1.0);
    // The slenderness is that of the stresses' proportion: use goes with the load.
    CHECK(use(0.5) == Approx(0.5 * now).epsilon(1e-9));
    panel.thickness = 0.95 * panel.thickness;
    CHECK(use(1.0) >= now * (1.0 - 1e-12));
  }
}

}  // namespace reduced_stress_test
