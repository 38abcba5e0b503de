#include "boxbeam/strength/pin.hpp"

#include <cmath>

#include "catch.hpp"

namespace pin_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }
Force kN(double x) { return si<Force>(1e3 * x); }

const PinJoint joint{mm(50), mm(50.5), mm(20), mm(30), mm(2)};
const PinStrength strength{MPa(600), MPa(800), MPa(345), MPa(335), 1.05, 1.25, 1.1};

}  // namespace

TEST_CASE("pin: utilisations by hand, EN 1993-1-8 table 3.10") {
  const double F = 200e3, d = 0.05, pi = 3.14159265358979;
  const auto use = pin_utilisation(kN(200), joint, strength);
  const double shear = 0.5 * F / (0.6 * pi * d * d / 4 * 800e6 / 1.25);
  // Outer plates from the middle: F/2 spread over a beyond b/2 + c; moment at the middle by hand,
  // F/2 (b/2 + c + a/2) - F/2 (b/4).
  const double a = 0.02, b = 0.03, c = 0.002;
  const double moment = 0.5 * F * (0.5 * b + c + 0.5 * a) - 0.5 * F * 0.25 * b;
  const double bending = moment / (1.5 * pi * d * d * d / 32 * 600e6 / 1.05);
  CHECK(use.shear == Approx(shear).epsilon(1e-12));
  CHECK(use.bending == Approx(bending).epsilon(1e-12));
  CHECK(use.combined == Approx(shear * shear + bending * bending).epsilon(1e-12));
  CHECK(use.bearing_inner == Approx(F / (1.5 * 0.03 * d * 335e6 / 1.05)).epsilon(1e-12));
  CHECK(use.bearing_outer == Approx(0.5 * F / (1.5 * 0.02 * d * 345e6 / 1.05)).epsilon(1e-12));
}

TEST_CASE("pin: a force of the other sign uses it as much, twice the force twice as much") {
  const auto one = pin_utilisation(kN(100), joint, strength);
  const auto back = pin_utilisation(kN(-100), joint, strength);
  const auto two = pin_utilisation(kN(200), joint, strength);
  CHECK(back.shear == one.shear);
  CHECK(back.bending == one.bending);
  CHECK(back.bearing_inner == one.bearing_inner);
  CHECK(two.bearing_outer == Approx(2 * one.bearing_outer).epsilon(1e-14));
  CHECK(two.combined == Approx(4 * one.combined).epsilon(1e-14));
}

TEST_CASE("pin: bearing is by the weaker of plate and pin") {
  const PinStrength soft{MPa(235), MPa(360), MPa(345), MPa(335), 1.0, 1.25, 1.0};
  // Both plates by the 235 MPa of the pin.
  const auto use = pin_utilisation(kN(100), joint, soft);
  CHECK(use.bearing_outer == Approx(50e3 / (1.5 * 0.02 * 0.05 * 235e6)).epsilon(1e-12));
  CHECK(use.bearing_inner == Approx(100e3 / (1.5 * 0.03 * 0.05 * 235e6)).epsilon(1e-12));
}

TEST_CASE("replaceable pin: the service limits are 0.4 of the bearing, 8/15 of the bending") {
  // Each with its own partial factor, 1.1 and 1.05.
  const double gamma = 1.1 / 1.05;
  const auto ultimate = pin_utilisation(kN(100), joint, strength);
  const auto service = replaceable_pin_utilisation(kN(100), MPa(210e3), joint, strength);
  CHECK(service.bearing_inner == Approx(gamma * ultimate.bearing_inner / 0.4).epsilon(1e-12));
  CHECK(service.bearing_outer == Approx(gamma * ultimate.bearing_outer / 0.4).epsilon(1e-12));
  CHECK(service.bending == Approx(gamma * ultimate.bending * 15 / 8).epsilon(1e-12));
}

TEST_CASE("pin: the contact stress is Hertz's for a cylinder in a bore a little wider") {
  // p^2 = F/t E*/(pi R), E* = E/[2 (1 - nu^2)], 1/R = 2/d - 2/d_0, nu = 0.3; d_0 taken as d.
  const double F = 100e3, t = 0.03, E = 210e9, d = 0.05, d_0 = 0.0505, pi = 3.14159265358979;
  const double curvature = 2 / d - 2 / d_0;
  const double hertz = std::sqrt(F / t * E / (2 * 0.91) * curvature / pi);
  const double stress = hertz * std::sqrt(d_0 / d);
  const auto service = replaceable_pin_utilisation(kN(100), MPa(210e3), joint, strength);
  CHECK(service.contact_inner == Approx(stress / (2.5 * 335e6 / 1.1)).epsilon(1e-3));
  // Half of the force on two thirds of the thickness.
  CHECK(service.contact_outer ==
        Approx(stress * std::sqrt(0.75) / (2.5 * 345e6 / 1.1)).epsilon(1e-3));
}

}  // namespace pin_test
