// Forces that come into solid plates by an edge: hand numbers.

#include <fmt/format.h>

#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "src/verification/pressed_solids.hpp"
#include "support/pressed_beams.hpp"

namespace pressed_solids_test {

using namespace boxbeam;
using pressed_beams::says;
using pressed_beams::stops;

namespace {

/// A plate 300 mm deep on two supports 0.8 m apart under a force in its middle [mm, kN].
Verification plate(double thickness, double force, const std::string& more) {
  return verify(parse_project(
      "a.toml",
      fmt::format(
          "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
          "m/s^2\"]\n[sections.s]\nkind = \"plate\"\nwidth = \"{} mm\"\nheight = \"300 "
          "mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"0.8 "
          "m\"\nsection = \"s\"\n{}[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\n[supports.b]\n"
          "kind = \"roller\"\nat = \"0.8 m\"\n[loads.p]\nkind = \"force\"\nat = \"0.4 m\"\nforce "
          "= [\"0 kN\", \"{} kN\"]\n[material]\nsteel = \"S355\"\nfy_source = \"EN "
          "1993-1-1\"\n[strength]\nrequired = 1.0\n",
          thickness, more, -force)));
}

std::string hole(double diameter, double level) {
  return fmt::format(
      "[[beam.holes]]\nname = \"h\"\ndiameter = \"{} mm\"\nstation = \"0.4 m\"\nthrough = "
      "\"webs\"\nlevels = [\"{} mm\"]\ndetail = {{ row = \"8.1/11\" }}\n",
      diameter, level);
}

std::string bearing(double length) {
  return fmt::format(
      "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"0.8 m\"\nstiff_length = \"{} mm\"\n",
      length);
}

}  // namespace

// By hand: e = 11 mm, e t f_y = 117.2 kN; m = 200 x 88/(2 x 11 x 117.2) = 6.83, v = 0.866 x
// 200/117.2 = 1.48: m/2 + sqrt(m^2/4 + v^2) = 7.14.
TEST_CASE("the strip of a solid plate between a force and a hole is looked at") {
  CHECK(use_of({0.088, 0.011, 0.03, 355e6}, 200e3, 0.0) == Approx(7.135).epsilon(1e-3));
  CHECK(stops(plate(30.0, 200.0, hole(88.0, 95.0)), "by 7.14 of its strength"));
  // It may hang from the lower edge, or pull at it.
  CHECK(stops(plate(30.0, 200.0, hole(88.0, -95.0)), "by 7.14 of its strength"));
  CHECK(stops(plate(30.0, -200.0, hole(88.0, 95.0)), "by 7.14 of its strength"));
  // Below 100 mm: m = 200 x 40/(2 x 100 x 1065) = 0.038, v = 0.163: 0.18.
  const Verification deep = plate(30.0, 200.0, hole(40.0, 30.0));
  CHECK(says(deep, "by 0.182 of its strength"));
  CHECK_FALSE(stops(deep, "strip"));
}

// An invariant: a force that stands in the hole presses no strip beside it.
TEST_CASE("a pin in a hole of a plate presses no edge") {
  CHECK_FALSE(says(plate(30.0, 200.0, hole(88.0, 0.0)), "strip of the plate"));
}

// By hand: 300 kN/(15 x 355) = 56.3 mm; a tenth of the depth is 30.
TEST_CASE("a plate says what bearing a force needs") {
  CHECK(says(plate(15.0, 300.0, ""), "a bearing 56.3 mm long"));
  CHECK_FALSE(stops(plate(15.0, 300.0, ""), "bearing"));
  CHECK_FALSE(says(plate(15.0, 300.0, bearing(60.0)), "a bearing"));
  CHECK(stops(plate(15.0, 300.0, bearing(50.0)), "a bearing 56.3 mm long"));
  CHECK_FALSE(says(plate(15.0, 150.0, ""), "a bearing"));
}

}  // namespace pressed_solids_test
