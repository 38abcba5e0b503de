// Beams of several materials. What is expected is M z/I by hand, each plate with the strength of
// its own steel, or what a case of one steel says.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/gates.hpp"
#include "support/refusals.hpp"

namespace part_material_test {

using namespace boxbeam;

namespace {

/// A cantilever of 4 m in two segments of one section, 20 kN at its tip, in the plane.
std::string cantilever(const std::string& materials, const std::string& more = "",
                       const std::string& section = "root") {
  const std::string of = "section = \"" + section + "\"";
  return R"(
[case]
name = "cantilever"
kind = "static"
[frame]
gravity = ["0 m/s^2", "0 m/s^2"]
[sections.root]
kind = "box"
width = "150 mm"
height = "300 mm"
flange = "12 mm"
web = "8 mm"
)" + more +
         R"(
[beam]
density = "7850 kg/m^3"
from = ["0 m", "0 m"]
segments = [
)" + "  { name = \"a\", length = \"2 m\", " +
         of + " },\n  { name = \"b\", length = \"2 m\", " + of + R"( },
]
[supports.wall]
kind = "fixed"
at = "0 m"
[loads.tip]
kind = "force"
at = "4 m"
force = ["0 kN", "-20 kN"]
[strength]
required = 1.0
)" + materials;
}

const std::string s235 = "[material]\nsteel = \"S235\"\n";

std::string part(const std::string& steel, const std::string& more) {
  return "[[part_materials]]\nsteel = \"" + steel + "\"\n" + more + "\n";
}

Verification verified(const std::string& text) { return verify(parse_project("case.toml", text)); }

/// The yield factor at a station and point; 0 where it is not among the checks.
double factor_at(const Verification& verification, double s, Side side, const std::string& point) {
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (check.criterion == Criterion::yield && check.station.side == side &&
        std::abs(check.station.s.value() - s) < 1e-9 && check.point == point)
      return check.safety_factor;
  }
  return 0.0;
}

double least_factor(const Verification& verification) {
  double least = std::numeric_limits<double>::infinity();
  for (const CheckResult& result : verification.checks)
    least = std::min(least, result.check.safety_factor);
  return least;
}

constexpr double I = (0.15 * 0.3 * 0.3 * 0.3 - 0.134 * 0.276 * 0.276 * 0.276) / 12.0;

/// M z/I [Pa] at a station.
double bending_at(double s, double z) { return 20e3 * (4.0 - s) * z / I; }

std::string message_of(const std::string& text) {
  return test::refusal_of([&] { return parse_project("case.toml", text); });
}

}  // namespace

TEST_CASE("part materials: each plate resists with the yield strength of its own steel") {
  const auto hybrid =
      verified(cantilever(s235 + part("S355", "plates = [\"top flange\", \"bottom flange\"]")));
  CHECK(factor_at(hybrid, 0.0, Side::behind, "fibre +z") ==
        Approx(355e6 / bending_at(0.0, 0.15)).epsilon(1e-9));
  // The web ends at the flange, where its own steel is stressed as much; its shear is q/t.
  const double q = 20e3 / I * 0.5 * 0.15 * 0.012 * 0.144;
  const double at_web = std::hypot(bending_at(0.0, 0.138), std::sqrt(3.0) * q / 0.008);
  CHECK(factor_at(hybrid, 0.0, Side::behind, "web end +z") == Approx(235e6 / at_web).epsilon(1e-3));
  // One flange alone.
  const auto top = verified(cantilever(s235 + part("S355", "plates = [\"top flange\"]")));
  CHECK(factor_at(top, 0.0, Side::behind, "fibre +z") ==
        Approx(355e6 / bending_at(0.0, 0.15)).epsilon(1e-9));
  CHECK(factor_at(top, 0.0, Side::behind, "fibre -z") ==
        Approx(235e6 / bending_at(0.0, 0.15)).epsilon(1e-9));
}

TEST_CASE("part materials: where the steel of the segments changes both sides are verified") {
  // The weaker steel is on the far side of the joint, and on it nothing else is worse.
  for (const auto& [segment, weak_side] :
       {std::pair{"b", Side::behind}, std::pair{"a", Side::before}}) {
    INFO(segment);
    const std::string materials = "[material]\nsteel = \"S690Q\"\n" +
                                  part("S235", fmt::format("segments = [\"{}\"]", segment));
    const auto of = verified(cantilever(materials));
    const Side other = weak_side == Side::before ? Side::behind : Side::before;
    CHECK(factor_at(of, 2.0, weak_side, "fibre +z") ==
          Approx(235e6 / bending_at(2.0, 0.15)).epsilon(1e-9));
    CHECK(factor_at(of, 2.0, other, "fibre +z") ==
          Approx(690e6 / bending_at(2.0, 0.15)).epsilon(1e-9));
  }
}

TEST_CASE("part materials: a hole through both flanges is as strong as the weaker one's steel") {
  const std::string hole =
      "[[beam.holes]]\nname = \"h\"\nstation = \"1 m\"\ndiameter = \"30 mm\"\n"
      "through = \"flanges\"\noffsets = [\"0 mm\"]\nconcentration = \"membrane tension\"\n";
  const auto edge = [&](const std::string& materials) {
    double least = std::numeric_limits<double>::infinity();
    for (const CheckResult& result : verified(cantilever(materials + hole)).checks) {
      if (result.check.criterion == Criterion::yield &&
          result.check.point.starts_with("hole h edge"))
        least = std::min(least, result.check.safety_factor);
    }
    return least;
  };
  // Bending stresses both alike: 235 beside 355 MPa.
  const std::string s355 = "[material]\nsteel = \"S355\"\n";
  const double strong = edge(s355);
  CHECK(edge(s235) == Approx(235.0 / 355.0 * strong).epsilon(1e-9));
  for (const char* const flange : {"top flange", "bottom flange"}) {
    INFO(flange);
    CHECK(edge(s355 + part("S235", fmt::format("plates = [\"{}\"]", flange))) ==
          Approx(235.0 / 355.0 * strong).epsilon(1e-9));
  }
}

TEST_CASE("part materials: a flat of a weaker steel yields where it stands on its plate") {
  const std::string flats =
      "[[sections.root.stiffeners]]\non = \"bottom flange\"\nat = \"0 mm\"\ndepth = \"40 mm\"\n"
      "thickness = \"8 mm\"\n";
  const auto verification = [&](const std::string& of_flats) {
    return verified(cantilever("[material]\nsteel = \"S355\"\n" + of_flats, flats));
  };
  // As stressed there as the flange at the same place.
  const double flange = factor_at(verification(""), 0.0, Side::behind, "fibre -z");
  REQUIRE(flange > 0.0);
  CHECK(factor_at(verification(part("S235", "plates = [\"stiffeners\"]")), 0.0, Side::behind,
                  "stiffener 1 foot") == Approx(235.0 / 355.0 * flange).epsilon(0.02));
  CHECK(factor_at(verification(part("S420N", "plates = [\"stiffeners\"]")), 0.0, Side::behind,
                  "stiffener 1 foot") == 0.0);
}

TEST_CASE("part materials: of all plates of all segments they are the beam's material") {
  const auto one = verified(cantilever("[material]\nsteel = \"S355\"\n"));
  const auto parts = verified(cantilever(s235 + part("S355", "")));
  REQUIRE(one.checks.size() == parts.checks.size());
  for (std::size_t i = 0; i < one.checks.size(); ++i) {
    INFO(one.checks[i].check.id);
    CHECK(one.checks[i].check.id == parts.checks[i].check.id);
    CHECK(one.checks[i].check.safety_factor ==
          Approx(parts.checks[i].check.safety_factor).epsilon(1e-12));
  }
  // The last one that says a plate counts.
  const auto last = verified(cantilever(s235 + part("S690Q", "") + part("S355", "")));
  CHECK(least_factor(last) == Approx(least_factor(one)).epsilon(1e-12));
}

TEST_CASE(
    "part materials: a weaker steel in any plate never makes a beam safer, a stronger weaker") {
  const std::string sections = R"(
[sections.stiffened]
kind = "box"
width = "150 mm"
height = "300 mm"
flange = "12 mm"
web = "8 mm"
stiffeners = [{ on = "top flange", at = "10 mm", depth = "60 mm", thickness = "8 mm" }]
[sections.inside]
kind = "rectangular tube"
width = "100 mm"
height = "276 mm"
wall = "6 mm"
[sections.nested]
kind = "nested"
outer = "root"
inner = "inside"
)";
  const std::vector<std::string> plates{"top flange", "bottom flange", "left web",
                                        "right web",  "stiffeners",    "inner profile"};
  for (const char* section : {"root", "stiffened", "nested"}) {
    const std::string text = cantilever("[material]\nsteel = \"S355\"\n", sections, section);
    const double of_one = least_factor(verified(text));
    for (const std::string& plate : plates) {
      if (plate == "stiffeners" && section != std::string("stiffened")) continue;
      if (plate == "inner profile" && section != std::string("nested")) continue;
      INFO(section << ", " << plate);
      const std::string which = fmt::format("plates = [\"{}\"]", plate);
      CHECK(least_factor(verified(text + part("S235", which))) <= of_one * (1.0 + 1e-12));
      CHECK(least_factor(verified(text + part("S460N", which))) >= of_one * (1.0 - 1e-12));
    }
  }
}

TEST_CASE("part materials: a seam is as strong as the weaker part that it joins") {
  // beta_w and f_u of EN 1993-1-8, table 4.1, and EN 1993-1-1, table 3.1.
  const auto factor_of = [](const std::string& materials) {
    const auto of = verified(cantilever(materials));
    for (const CheckResult& result : of.checks) {
      if (result.check.criterion == Criterion::weld) return result.check.safety_factor;
    }
    return 0.0;
  };
  const double of_s235 = factor_of(s235);
  REQUIRE(of_s235 > 0.0);
  const std::string s460 = "[material]\nsteel = \"S460N\"\n";
  CHECK(factor_of(s460 + part("S235", "plates = [\"top flange\", \"bottom flange\"]")) ==
        Approx(of_s235).epsilon(1e-12));
  CHECK(factor_of(s460 + part("S235", "plates = [\"left web\", \"right web\"]")) ==
        Approx(of_s235).epsilon(1e-12));
}

TEST_CASE("part materials: the web's class is that of its stronger flanges") {
  // c/t = 376/3.5 = 107.4: 124 eps = 124 for S235, 87.6 for S460N, EN 1993-1-1, table 5.2, with
  // EN 1993-1-5, 4.3(6): of the flange.
  const std::string deep = R"(
[sections.deep]
kind = "box"
width = "150 mm"
height = "400 mm"
flange = "12 mm"
web = "3.5 mm"
)";
  const auto strength_in = [&](const std::string& materials) {
    const auto verification = verified(cantilever(materials, deep, "deep"));
    const CheckResult* const check = verification.governing(Criterion::effective_section);
    return check == nullptr
               ? 0.0
               : check->plates->plates->box.box().of(BoxPlate::left_web).class_strength.value();
  };
  CHECK(strength_in(s235) == 0.0);  // all of the web works
  CHECK(strength_in(s235 + part("S460N", "plates = [\"top flange\", \"bottom flange\"]")) == 460e6);
}

TEST_CASE("part materials: flanges above twice the web's strength give no verdict") {
  const auto of = [](const std::string& flange) {
    const auto verification =
        verified(cantilever(s235 + part(flange, "plates = [\"top flange\", \"bottom flange\"]")));
    return test::blocks(verification, "twice the yield strength");
  };
  CHECK_FALSE(of("S460N"));
  CHECK(of("S500Q"));
}

TEST_CASE("part materials: what is wrong is said where it is") {
  const auto wrong = [](const std::string& of) { return message_of(cantilever(s235 + of)); };
  CHECK(wrong(part("S355", "segments = [\"c\"]")).find("no segment \"c\"") != std::string::npos);
  CHECK(wrong(part("S355", "plates = [\"flange\"]")).find("no plate of a section") !=
        std::string::npos);
  CHECK(wrong(part("S355", "plates = [\"stiffeners\"]")).find("has a plate \"stiffeners\"") !=
        std::string::npos);
  CHECK(wrong("[[part_materials]]\nplates = [\"left web\"]\n").find("a steel of the catalogue") !=
        std::string::npos);
  CHECK(wrong("[[part_materials]]\nname = \"x\"\nfy = \"300 MPa\"\nfu = \"400 MPa\"\nup_to = \"10 "
              "mm\"\nsource = \"own\"\n")
            .find("x has no yield strength for the plate of 12 mm in segment a") !=
        std::string::npos);
}

TEST_CASE("part materials: a place lies in the plates whose material is there") {
  Box box = symmetric_box(0.2 * metre, 0.4 * metre, 0.02 * metre, 0.01 * metre);
  box.stiffeners = {{BoxPlate::left_web, 0.05 * metre, 0.06 * metre, 0.008 * metre}};
  const Section section{box, {}};
  const auto kinds = [&](double y, double z) {
    std::vector<int> found;
    for (const PlateAt& plate : plates_at(section, y * metre, z * metre))
      found.push_back(static_cast<int>(plate.kind));
    return found;
  };
  const auto of = [](std::initializer_list<PlateKind> plates) {
    std::vector<int> found;
    for (const PlateKind kind : plates) found.push_back(static_cast<int>(kind));
    return found;
  };
  using enum PlateKind;
  CHECK(kinds(0.0, 0.2) == of({top_flange}));
  CHECK(kinds(0.1, -0.2) == of({bottom_flange}));
  CHECK(kinds(0.095, 0.0) == of({left_web}));
  CHECK(kinds(-0.1, 0.1) == of({right_web}));
  CHECK(kinds(0.095, 0.18) == of({top_flange, left_web}));
  CHECK(kinds(-0.095, -0.18) == of({bottom_flange, right_web}));
  CHECK(kinds(0.05, 0.05) == of({stiffener}));
  CHECK(kinds(0.09, 0.05) == of({left_web, stiffener}));
  // In the air: whatever it is, the weakest counts.
  CHECK(kinds(0.0, 0.0).size() == 5);
}

}  // namespace part_material_test
