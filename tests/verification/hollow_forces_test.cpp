// Forces across the beam into walls of round tubes and hollow polygons: EN 1993-1-8, table 7.3,
// with hand numbers; the same box as a polygon and as a box.

#include <fmt/format.h>

#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace hollow_forces_test {

using namespace boxbeam;
using pressed_beams::says;
using pressed_beams::stops;

namespace {

/// A beam of one section on two supports, forces in its middle [kN].
Verification beam(const std::string& section, double length, double force, int parts = 1,
                  const std::string& more = "") {
  std::string text =
      "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
      "[sections.s]\n" +
      section +
      fmt::format(
          "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"{0} m\"\nsection = "
          "\"s\"\n{1}[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\n[supports.b]\nkind = "
          "\"roller\"\nat = \"{0} m\"\n",
          length, more);
  for (int i = 0; i < parts; ++i)
    text += fmt::format(
        "[loads.f{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"{} kN\"]\nmoment = \"0 "
        "kN m\"\n",
        i, 0.5 * length, -force / parts);
  // Polygons count as thick as they are wide.
  return verify(parse_project(
      "a.toml", text + "[material]\nname = \"q\"\nfy = \"355 MPa\"\nfu = \"490 MPa\"\nup_to = "
                       "\"900 mm\"\nsource = \"x\"\nbeta_w = 0.9\n[strength]\nrequired = "
                       "1.0\nshear_lag = false\n"));
}

const std::string tube = "kind = \"round tube\"\ndiameter = \"400 mm\"\nwall = \"8 mm\"\n";

}  // namespace

// f_y t^2 = 355 x 64 = 22.72 kN: 4 of it 90.9 kN, 5/(1 - 0.81) of it 597.9 kN.
TEST_CASE("what comes into the wall of a round tube stands with the verdict, or stops it") {
  CHECK(says(beam(tube, 2.0, 480.0), "90.88 kN (4 f_y t^2)"));
  CHECK_FALSE(stops(beam(tube, 2.0, 480.0), "round tube"));
  CHECK(stops(beam(tube, 1.0, 900.0), "up to 597.9 kN"));
  CHECK_FALSE(says(beam(tube, 2.0, 9.0), "round tube"));
}

TEST_CASE("a force in parts is the same force") {
  CHECK(stops(beam(tube, 1.0, 900.0, 5), "round tube at s = 0.5 m"));
}

TEST_CASE("where a diaphragm stands in a round tube it is only said") {
  const std::string at =
      "[[beam.diaphragms]]\nstation = \"0.5 m\"\nthickness = \"20 mm\"\nthroat = \"8 mm\"\n";
  const Verification of = beam(tube, 1.0, 900.0, 1, at);
  CHECK_FALSE(stops(of, "round tube at s = 0.5 m"));
  CHECK(says(of, "round tube at s = 0.5 m"));
}

// By hand: 384 x 1 x 355/sqrt(3) = 79 kN a side before the plate buckles, of 450 kN.
TEST_CASE("a diaphragm of a round tube must bear what it takes") {
  const auto under_plate = [](double thickness) {
    return beam(tube, 1.0, 900.0, 1,
                fmt::format("[[beam.diaphragms]]\nstation = \"0.5 m\"\nthickness = \"{} "
                            "mm\"\nthroat = \"3 mm\"\n",
                            thickness));
  };
  CHECK(stops(under_plate(1.0), "the diaphragm there bears"));
  // Fillets: 2 x pi/2 x 384 mm x 2 x 3 mm x 435/sqrt(3) MPa = 1.82 MN, on 3.1 MN of the plate.
  CHECK_FALSE(stops(under_plate(20.0), "the diaphragm there bears"));
}

namespace {

/// A cantilever of 1 m under a load along it [kN/m].
Verification cantilever(const std::string& section, double q, const std::string& more = "") {
  return verify(parse_project(
      "a.toml",
      "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\"]\n[sections.s]\n" +
          section +
          fmt::format("[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"1 "
                      "m\"\nsection = \"s\"\n[supports.a]\nkind = \"fixed\"\nat = \"0 "
                      "m\"\n[loads.q]\nkind = \"line\"\nforce_per_length = [\"0 kN/m\", \"{} "
                      "kN/m\"]\n",
                      -q) +
          more +
          "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
          "1.0\n"));
}

}  // namespace

// By hand: m = 3/(4 pi) q r, r = 196 mm: 14.0 kN under 300 kN/m on t^2 f_y/4 = 5.68 kN, 2.5; under
// 60 kN/m 6 m/t^2 = 263 MPa, above 160/1.35.
TEST_CASE("a load along a round tube bends its wall across") {
  CHECK(stops(cantilever(tube, 300.0), "by about 2.5 of its strength"));
  CHECK_FALSE(stops(cantilever(tube, 60.0), "across itself"));
  CHECK(says(cantilever(tube, 60.0), "by about 0.49 of its strength"));
  CHECK_FALSE(says(cantilever(tube, 10.0), "across itself"));
  const std::string again =
      "[[situations]]\nname = \"off\"\nloads = { }\n[[situations]]\nname = \"on\"\nloads = { q = "
      "1.0 }\n[[situations]]\nname = \"change\"\nbetween = [\"off\", \"on\"]\ncycles = 2e6\n"
      "[fatigue]\nloading = \"spectrum\"\ncategory = 112\ngamma_Ff = 1.0\ngamma_Mf = "
      "1.35\nrequired = 1.0\n";
  CHECK(stops(cantilever(tube, 60.0, again), "263 MPa at every cycle"));
}

// An invariant: written as a box, too, it has no verdict.
TEST_CASE("a hollow polygon is stopped where the same box is") {
  const std::string polygon =
      "kind = \"polygon\"\nouter = [[\"-150 mm\", \"-180 mm\"], [\"150 mm\", \"-180 mm\"], [\"150 "
      "mm\", \"180 mm\"], [\"-150 mm\", \"180 mm\"]]\nholes = [[[\"-138 mm\", \"-168 mm\"], "
      "[\"138 mm\", \"-168 mm\"], [\"138 mm\", \"168 mm\"], [\"-138 mm\", \"168 mm\"]]]\n";
  const std::string box =
      "kind = \"box\"\nwidth = \"300 mm\"\nheight = \"360 mm\"\nflange = \"12 mm\"\nweb = \"12 "
      "mm\"\n";
  CHECK(stops(beam(box, 1.2, 1500.0), "under an edge"));
  CHECK(stops(beam(polygon, 1.2, 1500.0), "under an edge"));
}

}  // namespace hollow_forces_test
