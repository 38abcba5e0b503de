// How forces are led in: by welds and diaphragms whose parts others need as well, by loads along
// the beam of any length, by the plates of other bodies.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace led_in_test {

using namespace pressed_beams;

namespace {

constexpr double f_w = 490.0 / (0.9 * 1.25);  // of S355 [MPa], EN 1993-1-8, 4.5.3.2

std::string line(const std::string& name, double from, double to, double kN_per_m) {
  return fmt::format(
      "[loads.{}]\nkind = \"line\"\nfrom = \"{:.6g} m\"\nto = \"{:.6g} "
      "m\"\nforce_per_length = [\"0 kN/m\", \"{} kN/m\"]\n",
      name, from, to, -kN_per_m);
}

Beam on_two(const Sizes& section, double length, bool space = false) {
  Beam beam;
  beam.space = space;
  beam.pieces = {{length, section, section}};
  beam.diaphragms = {0.0, length};
  beam.supports = {{0.0, 0.0}, {length, 0.0}};
  return beam;
}

/// Two forces at the upper left corner, down and across, of a box 500 x 500 x 20.
Beam in_a_corner(double down, double across, const std::string& more = "") {
  Beam beam = on_two({500, 500, 20, 20, 0.0}, 4.0, true);
  beam.diaphragms = {2.0};
  beam.weld = 4.0;
  if (down != 0.0) beam.forces.push_back({"v", 2.0, down, 0.24, 0.24});
  if (across != 0.0) beam.forces.push_back({"h", 2.0, 0.0, 0.24, 0.24, 0.0, 0.0, -across});
  beam.more = introduced(1.9, 2.1, 200.0) + more;
  return beam;
}

}  // namespace

TEST_CASE("a short load along the beam is not spread by what stands beside it", "[patch]") {
  Beam beam = on_two({600, 1000, 25, 8, 4.0}, 6.0);
  // 6000 kN/m, a half on each seam of 4 mm: sqrt(2) 750 MPa/f_w.
  beam.more = line("f", 2.95, 3.05, 6000.0);
  const double alone = use_of(beam.verified(), Criterion::weld);
  CHECK(alone == Approx(std::sqrt(2.0) * 750.0 / f_w).epsilon(2e-3));
  const double web = use_of(beam.verified(), Criterion::patch_loading);
  beam.more += line("g", 0.0, 6.0, 0.1);
  const Verification beside = beam.verified();
  CHECK(use_of(beside, Criterion::weld) >= alone);
  CHECK(use_of(beside, Criterion::patch_loading) >= 0.999 * web);
  CHECK(beside.verdict == Verdict::fail);
}

TEST_CASE("the seam under a load that grows bears its largest part", "[patch]") {
  Beam beam = on_two({600, 1000, 25, 8, 4.0}, 6.0);
  const auto grows = [](const char* name, double from, double to, double a, double b) {
    return fmt::format(
        "[loads.{}]\nkind = \"line\"\nfrom = \"{} m\"\nto = \"{} m\"\nforce_per_length = [\"0 "
        "kN/m\", \"{} kN/m\"]\nto_force_per_length = [\"0 kN/m\", \"{} kN/m\"]\n",
        name, from, to, -a, -b);
  };
  // 1800 kN/m in the middle, where there is no shear.
  beam.more = grows("f", 2.5, 3.0, 0.0, 1800.0) + grows("g", 3.0, 3.5, 1800.0, 0.0);
  const double use = use_of(beam.verified(), Criterion::weld);
  const double there = std::sqrt(2.0) * 900.0 / 4.0 / f_w;
  CHECK(use >= 0.999 * there);
  CHECK(use < 1.06 * there);
}

TEST_CASE("bosses in webs take what stands on theirs alone of a load along the beam", "[patch]") {
  Beam beam = on_two({600, 1000, 25, 8, 0.0}, 6.0);
  beam.more = line("f", 2.8, 3.2, 3500.0);
  const double use = use_of(beam.verified(), Criterion::patch_loading);
  CHECK(use > 1.0);
  beam.more += "[[beam.load_introductions]]\nstation = \"3 m\"\ninto = \"webs\"\n";
  CHECK(use_of(beam.verified(), Criterion::patch_loading) == Approx(use).epsilon(1e-6));
}

TEST_CASE("a load along the beam over a diaphragm comes into it as a force does", "[patch]") {
  Beam beam = on_two({600, 1000, 25, 14, 0.0}, 6.0);
  beam.diaphragms = {0.0, 3.0, 6.0};
  beam.weld = 3.0;
  beam.more = line("f", 2.9, 3.1, 6250.0);
  const double by_line = use_at(beam.verified(), Criterion::weld, "load along the beam");
  beam.more = introduced(2.9, 3.1, 200.0);
  beam.forces = {{"f", 3.0, 1250.0}};
  CHECK(by_line == Approx(use_at(beam.verified(), Criterion::weld, "under f")).epsilon(1e-6));
  CHECK(by_line > 1.0);
}

TEST_CASE("what repeats along the beam is said in fatigue, however short it is", "[patch]") {
  Beam beam = on_two({600, 1000, 25, 10, 4.0}, 6.0);
  beam.more = line("f", 2.9, 3.1, 500.0) + cycles(2e6, "f = 1.0", "f = 0.0");
  CHECK(says(beam.verified(), "pressed anew by up to"));
}

TEST_CASE("welds of a diaphragm bear what comes in down and across together", "[patch]") {
  const auto use = [](const Beam& beam) {
    return use_at(beam.verified(), Criterion::weld, "diaphragm");
  };
  // Along the weld with the flange, 500 - 2 x 20 mm less a throat at each end, on both faces.
  const double along = 540e3 / (2.0 * 4.0 * (460.0 - 8.0)) * std::sqrt(3.0) / f_w;
  const double across = use(in_a_corner(540.0, 0.0));
  CHECK(across < 1.0);
  CHECK(use(in_a_corner(540.0, 540.0)) == Approx(std::hypot(across, along)).epsilon(1e-3));
  CHECK(use(in_a_corner(540.0, 540.0)) > 1.1);
}

TEST_CASE("seams bear what comes in down and across together", "[patch]") {
  const auto use = [](double down, double across) {
    Beam beam = in_a_corner(down, across);
    beam.diaphragms.clear();
    beam.pieces.front().from.throat = beam.pieces.front().to.throat = 5.0;
    return use_at(beam.verified(), Criterion::weld, "seam");
  };
  const double one = use(340.0, 0.0), both = use(340.0, 340.0);
  CHECK(one < 1.0);
  // sigma = sqrt(2) F, tau = 0, or the other way, by their signs: sqrt(3) times at the worst.
  CHECK(both > std::sqrt(3.0) * one);
  CHECK(both < 2.05 * one);
}

TEST_CASE("down and across at every cycle is not judged by each alone", "[patch]") {
  const auto of = [](double down, double across) {
    std::string on, off;
    if (down > 0.0) on += "v = 1.0", off += "v = 0.0";
    if (across > 0.0)
      on += on.empty() ? "h = 1.0" : ", h = 1.0", off += off.empty() ? "h = 0.0" : ", h = 0.0";
    Beam beam = in_a_corner(down, across, cycles(1e6, on, off));
    beam.diaphragms.clear();
    beam.pieces.front().from.throat = beam.pieces.front().to.throat = 5.0;
    return beam.verified();
  };
  const double one = use_of(of(30.0, 0.0), Criterion::patch_fatigue);
  CHECK(one > 0.0);
  const double kN = 0.95 * 30.0 / one;
  CHECK_FALSE(stops(of(kN, 0.0), "square to it"));
  CHECK_FALSE(stops(of(0.0, kN), "square to it"));
  CHECK(stops(of(kN, kN), "square to it"));

  // Nor where another place is worse, or what presses square to it stands beside it.
  const auto beside = [&](double away) {
    Beam beam = on_two({500, 500, 20, 20, 5.0}, 4.0, true);
    beam.forces = {{"u", 1.0, 0.97 / 0.95 * kN, 0.24, 0.24},
                   {"v", 3.0, 0.9 * kN, 0.24, 0.24},
                   {"h", 3.0 + away, 0.0, 0.24, 0.24, 0.0, 0.0, -0.9 * kN}};
    beam.more = introduced(0.5, 3.5, 200.0) +
                cycles(1e6, "u = 1.0, v = 1.0, h = 1.0", "u = 0.0, v = 0.0, h = 0.0");
    return beam.verified();
  };
  CHECK(stops(beside(0.0), "square to it"));
  CHECK(stops(beside(0.1), "square to it"));
  CHECK_FALSE(stops(beside(0.5), "square to it"));
}

TEST_CASE("a force between the webs stresses the weld of its diaphragm under it", "[patch]") {
  Beam beam = on_two({600, 800, 20, 12, 0.0}, 4.0, true);
  beam.diaphragms = {0.0, 2.0, 4.0};
  beam.weld = 4.0;
  beam.forces = {{"f", 2.0, 600.0, 0.0, 0.4}};
  beam.more = introduced(1.9, 2.1, 100.0);
  // On s_s + 2 t_f = 140 mm on both faces.
  CHECK(use_at(beam.verified(), Criterion::weld, "flange and diaphragm") ==
        Approx(std::sqrt(2.0) * 600e3 / (2.0 * 4.0 * 140.0) / f_w).epsilon(1e-3));
}

TEST_CASE("webs that step are led on by what an opening leaves of a diaphragm", "[patch]") {
  const auto of = [](const std::string& opening) {
    Beam beam;
    beam.pieces = {{0.6, {900, 800, 20, 20, 0.0}, {900, 800, 20, 20, 0.0}},
                   {1.4, {600, 800, 30, 20, 0.0}, {600, 800, 30, 20, 0.0}}};
    beam.supports = {{0.0, 0.0}, {2.0, 0.0}};
    beam.forces = {{"f", 0.65, 2000.0}};
    beam.more = "[[beam.diaphragms]]\nstation = \"0.6 m\"\nthickness = \"12 mm\"\n" + opening;
    return beam.verified();
  };
  // 675 kN of a web by 760 x 12 x 355/sqrt(3) = 1869 kN, beside 500 mm by 640 kN.
  CHECK_FALSE(stops(of(""), "is led on is not judged"));
  CHECK(stops(of("opening = \"500 mm\"\n"), "is led on is not judged"));
}

TEST_CASE("webs that step are led on in bending, too", "[patch]") {
  Beam beam;
  beam.pieces = {{2.0, {600, 800, 12, 20, 0.0}, {600, 800, 12, 20, 0.0}},
                 {2.0, {300, 800, 24, 20, 0.0}, {300, 800, 24, 20, 0.0}}};
  beam.diaphragms = {0.0, 0.5, 3.5, 4.0};
  beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
  beam.forces = {{"f", 0.5, 2600.0}, {"g", 3.5, 2600.0}};
  CHECK(stops(beam.verified(), "is led on is not judged"));
}

TEST_CASE("neighbours do not share a strip of the web", "[patch]") {
  const auto of = [](const std::vector<double>& at, double kN) {
    Beam beam;
    beam.pieces = {{3.0, {300, 1000, 25, 10, 0.0}, {300, 1000, 25, 10, 0.0}}};
    beam.diaphragms = at;
    beam.thickness = 8.0;
    beam.supports = {{1.0, 0.0}, {2.0, 0.0}};
    for (std::size_t i = 0; i < at.size(); ++i)
      beam.forces.push_back({fmt::format("f{}", i), at[i], kN});
    beam.more =
        "[[beam.diaphragms]]\nstation = \"1 m\"\nthickness = \"30 mm\"\n"
        "[[beam.diaphragms]]\nstation = \"2 m\"\nthickness = \"30 mm\"\n";
    return use_at(beam.verified(), Criterion::patch_loading, "web with diaphragm under f0");
  };
  // 15 eps t_w = 122 mm on each side, or 30 mm to halfway: 8 x 122 + 10 x 252 mm^2 against 10 x
  // 160.
  const double alone = of({1.5}, 1500.0), two = of({1.47, 1.53}, 1500.0);
  CHECK(two > 1.2 * alone);
  CHECK(two < 3496.0 / 2576.0 * 1.05 * alone);
}

TEST_CASE("what hangs on a thin flange is spread by that", "[patch]") {
  const auto of = [](double top, double bottom) {
    Beam beam = on_two({400, 500, 10, 12, 0.0}, 1.2, true);
    beam.thickness = 25.0;
    beam.forces = {{"f", 0.6, 550.0, 0.194, -0.25}, {"g", 0.6, 550.0, -0.194, -0.25}};
    beam.more = introduced(0.59, 0.61, 0.0);
    std::string text = beam.text();
    const std::string both = "\nflange = \"10 mm\"\n";
    const std::string unlike =
        fmt::format("\ntop_flange = \"{} mm\"\nbottom_flange = \"{} mm\"\n", top, bottom);
    for (auto at = text.find(both); at != std::string::npos; at = text.find(both))
      text.replace(at, both.size(), unlike);
    return use_at(verify(parse_project("hung.toml", text)), Criterion::patch_loading,
                  "web under f");
  };
  // Plain yielding of l_y, pulled or pushed.
  CHECK(of(40.0, 10.0) == Approx(of(10.0, 10.0)).epsilon(1e-6));
  CHECK(of(40.0, 40.0) < 0.7 * of(10.0, 10.0));
}

TEST_CASE("a load at the end of the beam is no clamp, however large its moment", "[patch]") {
  const auto of = [](double moment) {
    Beam beam = on_two({600, 1000, 25, 8, 0.0}, 6.0);
    beam.diaphragms.clear();
    beam.forces = {{"f", 6.0, 410.0, 0.0, 0.0, moment}};
    beam.more = introduced(0.0, 0.01, 100.0) + introduced(5.99, 6.0, 100.0);
    return use_at(beam.verified(), Criterion::patch_loading, "under f");
  };
  CHECK(of(150.0) > 1.0);
  CHECK(of(210.0) == Approx(of(150.0)).epsilon(0.02));
}

TEST_CASE("a seam that gets thinner within the loaded length counts in fatigue", "[patch]") {
  const auto of = [](double at) {
    Beam beam;
    beam.pieces = {{2.0, {400, 800, 20, 12, 6.0}, {400, 800, 20, 12, 6.0}},
                   {2.0, {400, 800, 20, 12, 3.0}, {400, 800, 20, 12, 3.0}}};
    beam.diaphragms = {0.0, 4.0};
    beam.weld = 10.0;
    beam.supports = {{0.0, 0.0}, {4.0, 0.0}};
    beam.forces = {{"f", at, 60.0}};
    beam.more = introduced(1.5, 2.5, 200.0) + cycles(2e6, "f = 1.0", "f = 0.0");
    return use_at(beam.verified(), Criterion::patch_fatigue, "seam");
  };
  CHECK(of(1.99) == Approx(of(2.01)).epsilon(1e-3));
  CHECK(of(2.01) > 1.0);
}

TEST_CASE("moments that plates of other bodies bring are said", "[patch]") {
  // One diaphragm in the middle of a couple takes none of its forces; those beside it take them,
  // 450/0.4 = 1125 kN each, which no check counts.
  Beam beam = on_two({600, 1000, 25, 8, 0.0}, 6.0);
  beam.forces = {{"k", 3.0, 150.0, 0.0, 0.0, 450.0}};
  beam.diaphragms = {0.0, 3.0, 6.0};
  CHECK(says(beam.verified(), "its moment, 450 kN m"));
  beam.diaphragms = {0.0, 2.8, 3.2, 6.0};
  CHECK(says(beam.verified(), "its moment, 450 kN m"));

  const std::string jib =
      "[case]\nname = \"jib\"\nkind = \"planar\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\"]\n[model]\ndemand = \"rigid\"\n[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\"], B = "
      "[\"4 m\", \"0 m\"] }\nsketch = { at = [\"0 m\", \"0 m\"] }\n[bodies.rod]\nmass = \"1 "
      "kg\"\nuniform_rod = \"3 m\"\npoints = { P = [\"-1.5 m\", \"0 m\"], Q = [\"1.5 m\", \"0 m\"] "
      "}\nsketch = { at = [\"4 m\", \"1.5 m\"], angle = \"90 deg\" }\n[joints.pivot]\nkind = "
      "\"pin\"\nconnect = [\"arm.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n[joints.knee]\nkind = "
      "\"rigid\"\nconnect = [\"arm.B\", \"rod.P\"]\nangle = \"90 deg\"\n[drivers.swing]\nkind = "
      "\"harmonic\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\nmean = \"0 deg\"\namplitude = \"1 "
      "deg\"\nfrequency = \"0.01 Hz\"\n[forces.load]\nkind = \"force\"\npoint = "
      "\"rod.Q\"\ndirection = \"180 deg\"\nsize = \"150 kN\"\n[sections.a]\nkind = \"box\"\nwidth "
      "= "
      "\"400 mm\"\nheight = \"800 mm\"\nflange = \"20 mm\"\nweb = \"12 mm\"\n[beam]\nbody = "
      "\"arm\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = "
      "\"a\"\n[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
      "1.0\n";
  CHECK(says(verify(parse_project("jib.toml", jib)), "comes by plates of another body"));

  // The same moment by a guide.
  std::string guided = jib;
  const std::string rigid =
      "kind = \"rigid\"\nconnect = [\"arm.B\", \"rod.P\"]\nangle = \"90 deg\"\n";
  const std::size_t at = guided.find(rigid);
  REQUIRE(at != std::string::npos);
  guided.replace(at, rigid.size(),
                 "kind = \"slider\"\npoint = \"rod.P\"\nguide = \"arm.B\"\nangle = \"90 "
                 "deg\"\ndirection = \"90 "
                 "deg\"\n[drivers.height]\nkind = \"harmonic\"\npoint = \"rod.P\"\ncoordinate = "
                 "\"y\"\nmean = \"0 m\"\namplitude = \"1 mm\"\nfrequency = \"0.01 Hz\"\n");
  CHECK(says(verify(parse_project("guided.toml", guided)), "comes by plates of another body"));
}

TEST_CASE("beside several forces counts the beam's own stress where it is largest among them",
          "[patch]") {
  const Sizes section{500, 1000, 25, 10, 0.0};
  Beam beam;
  beam.pieces = {{4.0, section, section}};
  beam.diaphragms = {0.0, 2.0};
  beam.supports = {{0.0, 0.0}, {2.0, 0.0}};
  beam.forces = {{"f", 3.0, 300.0}, {"g", 3.6, 300.0}};
  beam.more = introduced(2.9, 3.7, 100.0);
  const Verification of = beam.verified();
  bool any = false;
  for (const CheckResult& result : of.checks) {
    if (!result.patch || std::abs(result.patch->force.value() - 600e3) > 1e3) continue;
    any = true;
    // 0.6 m from the force at the tip.
    CHECK(result.patch->used_most.value() == Approx(3.0));
    CHECK(std::abs(result.patch->cut.M_y.value()) == Approx(180e3).epsilon(1e-6));
  }
  CHECK(any);
}

TEST_CASE("a diaphragm at an end takes what a seam would bear beyond it", "[patch]") {
  const auto seam = [](double at, bool diaphragm) {
    Beam beam = on_two({500, 600, 20, 20, 5.0}, 4.0);
    if (!diaphragm) beam.diaphragms.clear();
    beam.forces = {{"f", at, 300.0}};
    beam.more = introduced(0.0, 4.0, 200.0);
    return use_at(beam.verified(), Criterion::weld, "seam");
  };
  const double inside = seam(0.5, true);
  CHECK(inside > 0.1);
  CHECK(seam(0.001, true) == Approx(inside).epsilon(0.03));
  // 120.5 mm of 240.
  CHECK(seam(0.001, false) == Approx(240.0 / 121.0 * inside).epsilon(0.03));
}

}  // namespace led_in_test
