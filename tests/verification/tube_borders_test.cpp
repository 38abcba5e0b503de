// Borders of round tubes: hand numbers, the closed form of a shell under a ring load.

#include "src/verification/tube_borders.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace tube_borders_test {

using namespace boxbeam;
using pressed_beams::says;
using pressed_beams::stops;

namespace {

std::string tube(const char* name, double diameter, double wall) {
  return fmt::format(
      "[sections.{}]\nkind = \"round tube\"\ndiameter = \"{} mm\"\nwall = \"{} mm\"\n", name,
      diameter, wall);
}

const char* const begin =
    "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n";
const char* const steel =
    "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = 1.0\n";

/// A cone of 1 m on a tube of 300 x 12 under a force at its tip, 2 m from the border [mm, kN].
Verification cone(double diameter, double force, const std::string& diaphragm = "",
                  const std::string& more = "") {
  return verify(parse_project(
      "a.toml",
      begin + tube("c", diameter, 12.0) + tube("t", 300.0, 12.0) +
          "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"1 m\"\nfrom = "
          "\"c\"\nto = \"t\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = \"t\"\n" +
          diaphragm +
          "[supports.a]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.p]\nkind = "
          "\"force\"\nat = \"3 m\"\nforce = [\"0 kN\", \"" +
          fmt::format("{} kN\"]\n", -force) + more + steel));
}

/// 216 kN m between two forces over a border at 2 m.
Verification stepped(double diameter, double wall) {
  return verify(parse_project(
      "a.toml",
      begin + tube("a", 400.0, 16.0) + tube("b", diameter, wall) +
          "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = "
          "\"a\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = \"b\"\n[supports.a]\nkind = "
          "\"pinned\"\nat = \"0 m\"\n[supports.b]\nkind = \"roller\"\nat = \"4 m\"\n[loads.p]\n"
          "kind = \"force\"\nat = \"1.2 m\"\nforce = [\"0 kN\", \"-180 kN\"]\n[loads.q]\nkind = "
          "\"force\"\nat = \"2.8 m\"\nforce = [\"0 kN\", \"-180 kN\"]\n" +
          steel));
}

std::string plate(double thickness) {
  return fmt::format(
      "[[beam.diaphragms]]\nstation = \"1 m\"\nthickness = \"{} mm\"\nthroat = \"8 mm\"\n",
      thickness);
}

}  // namespace

// By hand: middles of the walls at 192 and 111 mm. Up to half of the difference of the walls and a
// tenth of the thinner one they are in line: 400 x 16 and 404 x 20 are.
TEST_CASE("a round tube ends where the next one lies elsewhere") {
  CHECK(stops(stepped(250.0, 28.0), "the next one lies 81 mm away"));
  CHECK_FALSE(says(stepped(404.0, 20.0), "it ends where"));
}

// Closed form: M = H/(4 beta), H = sigma t tan(alpha), 6 M/t^2; around H beta r/(2 t).
TEST_CASE("a kink bends the wall of a tube as a ring load does") {
  const double r = 0.15, t = 0.012, turn = 0.2;
  const double beta = std::pow(3.0 * (1.0 - 0.09), 0.25) / std::sqrt(r * t), H = t * turn;
  const TubeKink of = tube_kink_of(si<Length>(2.0 * r), si<Length>(t), si<Length>(t), turn);
  CHECK(of.bends == Approx(6.0 * H / (4.0 * beta) / (t * t)).epsilon(0.03));
  CHECK(of.hoops == Approx(H * beta * r / (2.0 * t)).epsilon(0.03));
}

// By hand: K = 0.6 sqrt(300 x 24)/12 x 0.2 = 0.849; I = 112.8e6 mm^4. Under 100 kN 255 MPa in the
// wall's middle, with K and 115 MPa around it 427 MPa on 355.
TEST_CASE("a cone against a tube has no verdict where its kink uses up the wall") {
  CHECK(stops(cone(700.0, 100.0), "used by 1.2:"));
  CHECK(says(cone(700.0, 60.0), "walls of round tubes that turn off"));
  CHECK_FALSE(stops(cone(700.0, 60.0), "turns off"));
  CHECK_FALSE(says(cone(340.0, 100.0), "turn"));
}

// By hand: 53.2 MPa at the outer fibre by 20 kN, (1 + 0.849) x 53.2 on 112/1.35: 1.19, by 16 kN
// 0.95.
TEST_CASE("a kink of a tube counts in fatigue") {
  const std::string again =
      "[[situations]]\nname = \"off\"\nloads = { }\n[[situations]]\nname = \"on\"\nloads = { p = "
      "1.0 }\n[[situations]]\nname = \"change\"\nbetween = [\"off\", \"on\"]\ncycles = 2e6\n"
      "[fatigue]\nloading = \"spectrum\"\ncategory = 112\ngamma_Ff = 1.0\ngamma_Mf = "
      "1.35\nrequired = 1.0\n";
  CHECK(stops(cone(700.0, 20.0, "", again), "used by 1.19 in fatigue"));
  const Verification less = cone(700.0, 16.0, "", again);
  CHECK_FALSE(stops(less, "turns off"));
  CHECK(says(less, "nor in fatigue, where with it 0.95 is used"));
}

// By hand: of H = 255 x 12 x 0.2 = 613 N/mm a plate of 1 mm bears 355; one of 25 mm leaves the wall
// 4.03/(4.03 + 26.7) of it.
TEST_CASE("a diaphragm takes what a tube turns off where it bears it") {
  CHECK_FALSE(stops(cone(700.0, 100.0, plate(25.0)), "turns off"));
  CHECK(stops(cone(700.0, 100.0, plate(1.0)), "used by 1.2:"));
}

}  // namespace tube_borders_test
