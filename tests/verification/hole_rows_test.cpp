// Holes in a row along the beam, over borders and jumps, beside welds and under forces: hand
// formulas, and what a millimetre must not change.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace hole_rows_test {

using namespace boxbeam;
using pressed_beams::stops;
using pressed_beams::use_at;
using pressed_beams::use_of;

namespace {

std::string hole(const std::string& name, double diameter, double at, const std::string& through,
                 double place, const std::string& judged = "detail = { row = \"8.1/11\" }") {
  return fmt::format(
      "[[beam.holes]]\nname = \"{}\"\ndiameter = \"{} mm\"\nstation = \"{:.6f} m\"\nthrough = "
      "\"{}\"\n{} = [\"{} mm\"]\n{}\n",
      name, diameter, at, through, through == "webs" ? "levels" : "offsets", place, judged);
}

std::string row(int count, double diameter, double pitch, double from, double level) {
  std::string holes;
  for (int i = 0; i < count; ++i)
    holes += hole(fmt::format("h{}", i), diameter, from + i * pitch, "webs", level);
  return holes;
}

const std::string by_bosses =
    "[[beam.load_introductions]]\nfrom = \"0.05 m\"\nto = \"1.95 m\"\ninto = \"webs\"\n";

constexpr pressed_beams::Sizes box{400.0, 600.0, 20.0, 12.0, 0.0};

/// A box 400 x 600, flanges 20 mm, webs 12 mm, of 2 m on two supports, 1600 kN in its middle.
pressed_beams::Beam beam(const std::string& more) {
  pressed_beams::Beam of;
  of.pieces = {{2.0, box, box}};
  of.diaphragms = {0.0, 2.0};
  of.weld = 8.0;
  of.supports = {{0.0, 0.0}, {2.0, 0.0}};
  of.forces = {{.at = 1.0, .down = 1600.0}};
  of.more = more;
  return of;
}

/// V S/(2 I t) of it at mid-depth under 800 kN [N/mm^2].
double shear_at_middle() {
  const double I = (400.0 * std::pow(600.0, 3) - 376.0 * std::pow(560.0, 3)) / 12.0;
  const double S = 400.0 * 20.0 * 290.0 + 2.0 * 12.0 * 280.0 * 140.0;
  return 800e3 * S / (I * 24.0);
}

}  // namespace

TEST_CASE("the shear flow of a pitch goes through the post between two holes: tau s/(s - d)") {
  for (const double d : {50.0, 100.0, 160.0}) {
    const Verification of = beam(by_bosses + row(3, d, 0.2, 0.3, 0.0)).verified();
    const double use = std::sqrt(3.0) * shear_at_middle() * 200.0 / (200.0 - d) / 355.0;
    INFO(d);
    CHECK(use_at(of, Criterion::yield, "post beside hole") == Approx(use).epsilon(2e-3));
  }
}

TEST_CASE("in space posts in flanges bear the flow of V_y") {
  std::string holes;
  for (int i = 0; i < 3; ++i)
    holes += hole(fmt::format("h{}", i), 60.0, 0.3 + 0.1 * i, "flanges", 0.0);
  pressed_beams::Beam of = beam(by_bosses + holes);
  of.space = true;
  of.forces = {{.at = 1.0, .across = 1600.0}};
  const double I = (600.0 * std::pow(400.0, 3) - 560.0 * std::pow(376.0, 3)) / 12.0;
  const double S = 2.0 * 20.0 * 200.0 * 100.0 + 560.0 * 12.0 * 194.0;
  const double use = std::sqrt(3.0) * 800e3 * S / (I * 40.0) * 100.0 / 40.0 / 355.0;
  CHECK(use_at(of.verified(), Criterion::yield, "post beside hole") == Approx(use).epsilon(2e-3));
}

TEST_CASE("posts between holes in a row are judged in shear fatigue by the flow of their pitch") {
  pressed_beams::Beam of = beam(by_bosses + row(3, 60.0, 0.2, 0.3, 0.0));
  of.forces.front().down = 200.0;
  of.more += pressed_beams::cycles(2e6, "f = 1.0", "f = 0.0");
  // At 2e6 cycles a range of tau s/(s - d) under 100 kN over 100 MPa/1.35 (EN 1993-1-9, 7.1(2)).
  const double range = shear_at_middle() / 8.0 * 200.0 / 140.0;
  CHECK(use_at(of.verified(), Criterion::shear_fatigue, "post beside hole") ==
        Approx(range / (100.0 / 1.35)).epsilon(2e-3));
}

TEST_CASE("one hole alone, and holes far across from each other, have no post") {
  CHECK(use_at(beam(by_bosses + row(1, 100.0, 0.2, 0.3, 0.0)).verified(), Criterion::yield,
               "post beside hole") == 0.0);
  // p = 300 mm, s = 50 mm: p^2/(4 s) = 450 mm is more than d.
  const std::string apart =
      hole("a", 60.0, 0.4, "webs", 150.0) + hole("b", 60.0, 0.45, "webs", -150.0);
  CHECK(use_at(beam(by_bosses + apart).verified(), Criterion::yield, "post beside hole") == 0.0);
}

// q s bends a post, clamped in the plane where it is wide: max 6 s y/b(y)^2 with d/s = 0.8 is 13.5
// (at y = 0.15 s: b = 1 - 2 sqrt(0.16 - 0.0225) = 0.258, 0.9/0.258^2 = 13.5).
TEST_CASE("posts narrower than half of their pitch bend and have no verdict") {
  CHECK(HolePost{nullptr, si<Length>(0.2), si<Length>(0.04), si<Length>(0.16), true}
            .bending_per_shear() == Approx(13.5).epsilon(5e-3));
  CHECK(stops(beam(by_bosses + row(3, 160.0, 0.2, 0.3, 0.0)).verified(),
              "leave a post of 40 mm of 200 mm"));
  CHECK_FALSE(stops(beam(by_bosses + row(3, 60.0, 0.2, 0.3, 0.0)).verified(), "leave a post"));
}

TEST_CASE("a hole over a border of the plates is judged by the thinner side, 1 mm here or there") {
  const auto use = [](double at, double d, const char* judged) {
    pressed_beams::Beam of = beam(by_bosses + hole("a", d, at, "flanges", 0.0, judged));
    pressed_beams::Sizes thick = box;
    thick.flange = 40.0;
    of.pieces = {{0.6, thick, thick}, {1.4, box, box}};
    return use_at(of.verified(), Criterion::yield, "hole a");
  };
  const char* const edge = "concentration = \"membrane tension\"";
  CHECK(use(0.599, 110.0, edge) == Approx(use(0.601, 110.0, edge)).epsilon(5e-3));
}

TEST_CASE("a hole over a jump of the moment is judged by the larger one, 1 mm here or there") {
  const auto use = [](double at) {
    pressed_beams::Beam of = beam(
        by_bosses + hole("a", 200.0, at, "flanges", 0.0, "concentration = \"membrane tension\""));
    of.supports = {{0.0, 0.0}, {2.0, 0.0}};
    of.forces = {{.at = 1.5, .down = 0.0, .moment = 500.0}};
    return use_of(of.verified(), Criterion::yield);
  };
  // M = 500 kN m 1.5/2 before the moment, 500 kN m 0.5/2 behind it.
  CHECK(use(1.501) == Approx(use(1.499)).epsilon(5e-3));
}

// Half of the shadow of a hole across, spread by 45 degrees from its widest place: d from its
// centre.
TEST_CASE("a weld around the profile in the shadow of a hole is refused, one beyond is not") {
  const auto read = [](double at) {
    const std::string weld =
        "[sections.wv]\nkind = \"box\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\nflange = \"20 "
        "mm\"\nweb = \"12 mm\"\n[[welds]]\nname = \"w\"\nstation = \"0.5 m\"\naround = "
        "\"wv\"\nthroat = \"10 mm\"\n";
    return parse_project("a.toml",
                         beam(by_bosses + hole("a", 200.0, at, "flanges", 0.0) + weld).text());
  };
  CHECK_THROWS_AS(read(0.501), InputError);
  CHECK_THROWS_AS(read(0.69), InputError);
  CHECK_NOTHROW(read(0.71));
}

// Seven of 27 mm every 30 mm, 20 mm under the flange, stand under the load of 150 mm: spread to
// 150 + 2 x 20 + 2 x 20 = 230 mm, of which they leave 230 - 7 x 27 = 41 mm.
TEST_CASE("small holes in a row under a force count together") {
  const auto of = [](int count, double down, double level) {
    pressed_beams::Beam pressed = beam(pressed_beams::introduced(0.05, 1.95, 150.0) +
                                       row(count, 27.0, 0.03, 1.0 - 0.015 * (count - 1), level));
    pressed.forces.front().down = down;
    return pressed.verified();
  };
  const double whole = use_of(of(1, 1000.0, 260.0), Criterion::patch_loading);
  REQUIRE(whole < 1.0);
  CHECK_FALSE(stops(of(1, 1000.0, 260.0), "in its row"));
  CHECK(stops(of(7, 1000.0, 260.0),
              fmt::format("uses webs by {:.3g}", whole * 230.0 / (230.0 - 7.0 * 27.0))));
  CHECK_FALSE(stops(of(3, 200.0, 0.0), "in its row"));
}

}  // namespace hole_rows_test
