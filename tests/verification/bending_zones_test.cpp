// Where a beam is not bent there is no stretch between zero moments, and no plate is left idle by
// shear lag.

#include "boxbeam/verification/bending_zones.hpp"

#include <cmath>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "catch.hpp"
#include "support/beam_checks.hpp"

namespace bending_zones_test {

using namespace boxbeam;

namespace {

/// A box of 140 x 260 mm with flanges of 12 mm and webs of 8 mm, clamped at its start: 30 kN down
/// at its end, 3 m away, and 5 kN aside at 1.5 m.
Project arm() {
  return parse_project(
      "arm.toml",
      "[case]\nname = \"arm\"\nkind = \"loads\"\n[sections.a]\nkind = \"box\"\nwidth = \"140 mm\"\n"
      "height = \"260 mm\"\nflange = \"12 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
      "[[beam.segments]]\nlength = \"3 m\"\nsection = \"a\"\n"
      "[loads.end]\nstation = \"3 m\"\nforce = [\"0 kN\", \"0 kN\", \"-30 kN\"]\n"
      "[loads.side]\nstation = \"1.5 m\"\nforce = [\"0 kN\", \"5 kN\", \"0 kN\"]\n"
      "[balance]\nstation = \"0 m\"\n[material]\nsteel = \"S355\"\n"
      "[strength]\nrequired = 1.0\n");
}

}  // namespace

TEST_CASE("shear lag of bending about one axis ends where that bending ends, EN 1993-1-5, 3.2.1") {
  const Project project = arm();
  const auto zones = bending_zones_of(project, run_situations(project));
  // Both are clamped: twice the length to the place where their moment is zero, which of M_z is
  // zero from 1.5 m on.
  REQUIRE(zones.size() == 2);
  CHECK(zones[0].axis == BendingAxis::y);
  CHECK(zones[0].effective_length.value() == Approx(6.0).epsilon(1e-9));
  CHECK(zones[1].axis == BendingAxis::z);
  CHECK(zones[1].effective_length.value() == Approx(3.0).epsilon(1e-9));
  CHECK(zones[1].to.value() == Approx(1.5).epsilon(1e-9));

  // From there on M_y is borne by the whole section (b_0 = 66 mm is below L_e/50 = 120 mm).
  const double W_y = (0.14 * std::pow(0.26, 3) - 0.124 * std::pow(0.236, 3)) / 12.0 / 0.13;
  int found = 0;
  for (const CheckResult& result : test::beam_checks_of(project).checks) {
    const Check& check = result.check;
    if (check.criterion != Criterion::yield || check.point != "fibre +z") continue;
    const double s = check.station.s.value();
    if (s < 1.5 || (s == 1.5 && check.station.side != Side::behind)) continue;
    ++found;
    CHECK(check.acting.value() == Approx(30e3 * (3.0 - s) / W_y).epsilon(1e-6));
  }
  CHECK(found > 0);
}

TEST_CASE("beyond the last load across it no plate of a beam is idle under what pulls it") {
  // What pulls at the end alone bends nothing: N/A of the whole section behind 1.5 m.
  const Project project = parse_project(
      "pulled.toml",
      "[case]\nname = \"pulled\"\nkind = \"loads\"\n[sections.a]\nkind = \"box\"\nwidth = \"400 "
      "mm\"\nheight = \"260 mm\"\nflange = \"12 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = \"7850 "
      "kg/m^3\"\n[[beam.segments]]\nlength = \"3 m\"\nsection = \"a\"\n"
      "[loads.end]\nstation = \"3 m\"\nforce = [\"500 kN\", \"0 kN\", \"0 kN\"]\n"
      "[loads.down]\nstation = \"1.5 m\"\nforce = [\"0 kN\", \"0 kN\", \"-40 kN\"]\n"
      "[balance]\nstation = \"0 m\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n");
  const double A = 0.4 * 0.26 - 0.384 * 0.236;
  int found = 0;
  for (const CheckResult& result : test::beam_checks_of(project).checks) {
    const Check& check = result.check;
    if (check.criterion != Criterion::yield) continue;
    const double s = check.station.s.value();
    if (s < 1.5 || (s == 1.5 && check.station.side != Side::behind)) continue;
    ++found;
    CHECK(check.acting.value() == Approx(500e3 / A).epsilon(1e-6));
  }
  CHECK(found > 0);
}

}  // namespace bending_zones_test
