// Forces along the beam, between its ends and beside the axis of open sections: by hand.

#include "boxbeam/verification/warping_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace axial_forces_test {

using namespace boxbeam;

namespace {

const std::string box =
    "kind = \"box\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\nflange = \"20 mm\"\nweb = \"12 "
    "mm\"\n";
/// I 400 x 200 x 14 x 8 mm.
const std::string girder =
    "kind = \"thin-walled\"\nnodes = { a = [\"100 mm\",\"193 mm\"], t = [\"0 mm\",\"193 mm\"], c = "
    "[\"-100 mm\",\"193 mm\"], d = [\"100 mm\",\"-193 mm\"], u = [\"0 mm\",\"-193 mm\"], e = "
    "[\"-100 mm\",\"-193 mm\"] }\nwalls = [\n"
    "{ from = \"a\", to = \"t\", thickness = \"14 mm\" },\n"
    "{ from = \"t\", to = \"c\", thickness = \"14 mm\" },\n"
    "{ from = \"d\", to = \"u\", thickness = \"14 mm\" },\n"
    "{ from = \"u\", to = \"e\", thickness = \"14 mm\" },\n"
    "{ from = \"t\", to = \"u\", thickness = \"8 mm\" }]\n";

/// A force along a beam of 2 m, held at its start.
std::string pulled(const std::string& section, double kN, double s, double y, double z) {
  return "[case]\nname = \"n\"\nkind = \"static\"\n[frame]\nspace = true\ngravity = [\"0 m/s^2\", "
         "\"0 m/s^2\", \"0 m/s^2\"]\n[sections.s]\n" +
         section +
         "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = "
         "\"s\"\n[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"2 m\"\nstiff_length = \"100 "
         "mm\"\n[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"20 mm\"\nthroat = \"8 mm\"\n"
         "[[beam.diaphragms]]\nstation = \"2 m\"\nthickness = \"20 mm\"\nthroat = \"8 mm\"\n"
         "[supports.a]\nkind = \"pinned\"\nat = [\"0 m\", \"0 m\", \"0 m\"]\nfork = true\n"
         "[supports.z]\nkind = \"roller\"\nat = [\"2 m\", \"0 m\", \"0 m\"]\ndirection = \"z\"\n"
         "fork = true\n[supports.y]\nkind = \"roller\"\nat = [\"2 m\", \"0 m\", \"0 m\"]\n"
         "direction = \"y\"\n" +
         fmt::format(
             "[loads.p]\nkind = \"force\"\nat = [\"{} m\", \"{} m\", \"{} m\"]\nforce = "
             "[\"{} kN\", \"0 kN\", \"0 kN\"]\n",
             s, y, z, kN) +
         "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
         "1.0\nshear_lag = false\n";
}

struct Judged {
  Verification of;
  std::string line;
};

Judged judged(const std::string& text) {
  const Project project = parse_project("n.toml", text);
  Judged judged{verify(project), ""};
  judged.line = verdict_text_of(project, judged.of).line;
  return judged;
}

// Of an I: omega = y z along its flanges, I_w = z^2 I_z of them, so that B/I_w omega = F y^2/I_z;
// N and M_z as much again, by A and I_z, M_y by I_y.
constexpr double F = 400e3, y = 0.1, z = 0.193;
const double flanges = 2.0 * 0.014 * std::pow(0.2, 3) / 12.0;  // m^4, about z
const double by_B = F * y * y / flanges;

}  // namespace

TEST_CASE("a force along an open beam at the tip of a flange warps it", "[warping]") {
  const Judged found = judged(pulled(girder, 1e-3 * F, 2.0, y, z));
  CHECK(found.of.verdict == Verdict::not_applicable);
  const double A = 2.0 * 0.2 * 0.014 + 0.386 * 0.008;
  const double I_z = flanges + 0.386 * std::pow(0.008, 3) / 12.0;
  const double I_y = 2.0 * (0.2 * 0.014 * z * z + 0.2 * std::pow(0.014, 3) / 12.0) +
                     0.008 * std::pow(0.386, 3) / 12.0;
  const double all = F / A + F * y * y / I_z + F * z * (z + 0.007) / I_y + by_B;
  const std::string by_hand = fmt::format(
      "bimoment of {:.3g} kN m^2, which no check counts: an edge has {:.3g} MPa along "
      "the beam by it and {:.3g} MPa",
      1e-3 * F * y * z, 1e-6 * by_B, 1e-6 * all);
  std::string findings;
  for (const Gate& gate : found.of.gates) findings += gate.blocks ? gate.finding : "";
  CHECK_THAT(findings, Catch::Contains(by_hand));
}

TEST_CASE("a lesser one is said, one over the web is not", "[warping]") {
  const Judged less = judged(pulled(girder, 200.0, 2.0, -y, z));
  CHECK(less.of.verdict == Verdict::pass);
  CHECK_THAT(less.line, Catch::Contains("warping of open sections") &&
                            Catch::Contains(fmt::format("{:.3g} MPa more", 0.5e-6 * by_B)));
  CHECK_THAT(judged(pulled(girder, 200.0, 2.0, 0.0, z)).line, !Catch::Contains("warping"));
  CHECK_THAT(judged(pulled(box, 200.0, 2.0, 0.1, 0.29)).line, !Catch::Contains("warping"));
  // Walls that meet in one line do not warp.
  const Judged cross = judged(pulled(
      "kind = \"thin-walled\"\nnodes = { o = [\"0 mm\", \"0 mm\"], a = [\"100 mm\", \"0 mm\"], b = "
      "[\"-100 mm\", \"0 mm\"], c = [\"0 mm\", \"100 mm\"], d = [\"0 mm\", \"-100 mm\"] }\nwalls = "
      "[\n{ from = \"o\", to = \"a\", thickness = \"20 mm\" },\n"
      "{ from = \"o\", to = \"b\", thickness = \"20 mm\" },\n"
      "{ from = \"o\", to = \"c\", thickness = \"20 mm\" },\n"
      "{ from = \"o\", to = \"d\", thickness = \"20 mm\" }]\n",
      200.0, 2.0, 0.1, 0.0));
  CHECK_THAT(cross.line, !Catch::Contains("warping"));
  for (const Gate& gate : cross.of.gates) CHECK_THAT(gate.finding, !Catch::Contains("bimoment"));
}

// A quarter of 29 440 mm^2 bears 7360 mm^2 x 345 MPa = 2.54 MN; 0.3 of it are 762 kN.
TEST_CASE("forces along the beam that come in between its ends are said", "[patch]") {
  const auto is_said = [](double kN, double s, double at_z) {
    return judged(pulled(box, kN, s, 0.0, at_z)).line.find("its force along the beam") !=
           std::string::npos;
  };
  const double limit = 0.3 * 0.25 * 29440.0 * 355e-3;  // kN, S355 up to 40 mm
  CHECK(is_said(1.01 * limit, 1.0, 0.0));
  CHECK_FALSE(is_said(0.99 * limit, 1.0, 0.0));
  CHECK(is_said(1.01 * limit, 1.0, 0.29));
  CHECK(is_said(-1.01 * limit, 1.0, 0.0));
  CHECK_FALSE(is_said(2.0 * limit, 2.0, 0.0));
}

}  // namespace axial_forces_test
