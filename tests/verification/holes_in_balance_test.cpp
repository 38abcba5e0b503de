// What goes through a plate before and behind a hole, goes through what the hole leaves of it: hand
// formulas.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace holes_in_balance_test {

using namespace boxbeam;
using pressed_beams::stops;
using pressed_beams::use_at;

namespace {

std::string hole(const std::string& name, double diameter, double at, const std::string& through,
                 double place, const std::string& judged = "detail = { row = \"8.1/11\" }") {
  return fmt::format(
      "[[beam.holes]]\nname = \"{}\"\ndiameter = \"{} mm\"\nstation = \"{} m\"\nthrough = "
      "\"{}\"\n{} = [\"{} mm\"]\n{}\n",
      name, diameter, at, through, through == "webs" ? "levels" : "offsets", place, judged);
}

/// A box 400 x 600, flanges 20 mm, webs 12 mm, of 2 m on two supports, 1600 kN in its middle, which
/// bosses lead into the webs.
pressed_beams::Beam beam(const std::string& holes) {
  pressed_beams::Beam of;
  const pressed_beams::Sizes box{400.0, 600.0, 20.0, 12.0, 0.0};
  of.pieces = {{2.0, box, box}};
  of.diaphragms = {0.0, 2.0};
  of.weld = 8.0;
  of.supports = {{0.0, 0.0}, {2.0, 0.0}};
  of.forces = {{.at = 1.0, .down = 1600.0}};
  of.more =
      "[[beam.load_introductions]]\nfrom = \"0.05 m\"\nto = \"1.95 m\"\ninto = \"webs\"\n" + holes;
  return of;
}

}  // namespace

TEST_CASE("all of V goes through what a hole leaves of the webs: V/(2 t (h_w - d))") {
  for (const double d : {300.0, 400.0, 540.0}) {
    const Verification of = beam(hole("a", d, 0.5, "webs", 0.0)).verified();
    // 800 kN of shear; f_y = 355 MPa. The edges' own stress of bending is added by von Mises.
    const double tau = 800e3 / (2.0 * 12.0 * (560.0 - d));
    const double use = use_at(of, Criterion::yield, "strip beside hole a");
    INFO(d);
    CHECK(use > 0.98 * std::sqrt(3.0) * tau / 355.0);
    // M = 400 kN m, W of the flanges alone 400 x 20 x 580 mm^3.
    const double bending = 400e6 / (400.0 * 20.0 * 580.0);
    CHECK(use < 1.06 * std::sqrt(3.0 * tau * tau + bending * bending) / 355.0);
    CHECK(stops(of, "leaves bends by about"));
  }
}

TEST_CASE("a small hole with a detail leaves a verdict") {
  const Verification of = beam(hole("a", 60.0, 0.5, "webs", 0.0)).verified();
  CHECK(!stops(of, "hole"));
  CHECK(use_at(of, Criterion::yield, "strip beside hole a") > 0.0);
}

TEST_CASE("holes nearly in one section count together: d - s^2/(4 p)") {
  Project project = parse_project("a.toml", beam(hole("a", 100.0, 1.0, "flanges", 0.0) +
                                                 hole("b", 100.0, 1.05, "flanges", 120.0))
                                                .text());
  const std::vector<Hole> at = holes_at(project, si<Length>(1.0));
  REQUIRE(at.size() == 2);
  CHECK(at[0].diameter.value() == Approx(0.1));
  CHECK(at[1].diameter.value() == Approx(0.1 - 0.05 * 0.05 / (4.0 * 0.12)));
  CHECK(holes_at(project, si<Length>(1.02)).empty());
}

TEST_CASE("holes that overlap at stations of their own are refused") {
  CHECK_THROWS_AS(
      parse_project(
          "a.toml",
          beam(hole("a", 100.0, 1.0, "webs", 0.0) + hole("b", 100.0, 1.06, "webs", 50.0)).text()),
      InputError);
}

TEST_CASE("a hole at a diaphragm, or over the end of the beam, has no verdict") {
  const Verification of = beam(hole("a", 200.0, 0.05, "webs", 0.0)).verified();
  CHECK(stops(of, "the diaphragm at s = 0 m stands on it"));
  CHECK(stops(of, "reaches over the end of the beam"));
}

// By hand: 500 kN on either web, the strip e = 560/2 - 200 - 30 = 50 mm deep, t = 12 mm, f_y = 355
// MPa: m = F d/(2 e^2 t f_y) = 1.41, v = sqrt(3) F/(2 e t f_y) = 2.03; used by (m + sqrt(m^2 + 4
// v^2))/2 = 2.86. In the middle of the web e = 250 mm: 0.06, 0.41 and 0.436; of a force of a tenth
// 0.04, which is borne.
TEST_CASE("a hole under a force that comes in by the flange has no verdict, far from it it has") {
  const auto stopped = [](double at, double level, double force, const char* by) {
    pressed_beams::Beam of = beam("");
    of.forces.front().down = force;
    of.more = pressed_beams::introduced(0.05, 1.95, 150.0) + hole("a", 60.0, at, "webs", level);
    return stops(of.verified(), by);
  };
  CHECK(stopped(1.0, 200.0, 1000.0, "presses the strip of the web beside it by 2.86"));
  CHECK_FALSE(stopped(1.6, 200.0, 1000.0, "presses the strip"));
  CHECK(stopped(1.0, 0.0, 1000.0, "presses the strip of the web beside it by 0.436"));
  CHECK_FALSE(stopped(1.0, 0.0, 100.0, "presses the strip"));
}

}  // namespace holes_in_balance_test
