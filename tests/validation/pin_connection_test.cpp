// A pin of 16 mm of S235 in a published calculation sheet to EN 1993-1-8, table 3.10 (scribd.com,
// document 406810866): A = 201.062 mm2, W_el = 402.124 mm3, shear resistance 35 kN, bending 123 N
// m, for a replaceable pin 76 N m. gamma_M2 = 1.25; its gamma_M0 is not legible: 1.15 fits the 123
// N m.

#include "boxbeam/strength/pin.hpp"

#include "catch.hpp"

namespace pin_connection_test {

using namespace boxbeam;

TEST_CASE("pin of 16 mm, S235: resistances as printed", "[validation]") {
  const PinJoint joint{0.016 * metre, 0.0161 * metre, 0.005 * metre, 0.008 * metre, 0.001 * metre};
  const Stress yield = si<Stress>(235e6);
  const PinStrength strength{yield, si<Stress>(360e6), yield, yield, 1.15, 1.25, 1.0};
  const Force force = si<Force>(1000.0);
  const auto use = pin_utilisation(force, joint, strength);
  // M = F (b + 4 c + 2 a)/8 = 2.75 N m.
  CHECK(0.5 * force.value() / use.shear == Approx(35e3).margin(500));
  CHECK(2.75 / use.bending == Approx(123.0).margin(0.5));
  const auto service = replaceable_pin_utilisation(force, si<Stress>(210e9), joint, strength);
  CHECK(2.75 / service.bending == Approx(76.0).margin(0.5));
}

}  // namespace pin_connection_test
