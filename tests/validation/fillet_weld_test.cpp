// Fillet welds: the design shear strengths and the bracket of a published design guide for
// EN 1993-1-8 with the UK national annex (steelcalculator.app, UK weld capacity).

#include "boxbeam/strength/weld_throat.hpp"

#include "catch.hpp"

namespace fillet_weld_test {

using namespace boxbeam;

namespace {

// S275: f_u = 410 MPa, beta_w = 0.85; S355: 470 MPa, 0.9.
const WeldStrength S275{si<Stress>(410e6), 0.85, 1.25};
const WeldStrength S355{si<Stress>(470e6), 0.9, 1.25};

}  // namespace

TEST_CASE("fillet weld: printed design shear strengths, S275 222.8 and S355 241 MPa",
          "[validation]") {
  CHECK(weld_shear_strength(S275).value() == Approx(222.8e6).epsilon(2e-4));
  CHECK(weld_shear_strength(S355).value() == Approx(241e6).epsilon(2e-3));
}

TEST_CASE("fillet weld: 283.2 mm of 4.2 mm throat in S275 carry 265 kN, 150 kN use 0.566",
          "[validation]") {
  const WeldForce force{si<ForcePerLength>(0.0), si<ForcePerLength>(0.0),
                        si<ForcePerLength>(150e3 / 0.2832)};
  CHECK(directional_utilisation(throat_stress_of(force, 0.0042 * metre), S275).largest() ==
        Approx(0.566).margin(5e-4));
}

}  // namespace fillet_weld_test
