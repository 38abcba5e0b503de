// Where a beam is cut: at every place where something that enters a check jumps or kinks.

#include "boxbeam/verification/beam_cuts.hpp"

#include <cmath>

#include "boxbeam/verification/judged_section.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"
#include "support/rig.hpp"
#include "support/tip_loaded.hpp"

namespace beam_cuts_test {

using namespace boxbeam;

namespace {

const std::string fatigue =
    "[fatigue]\ncategory = 71\ncycles = 2e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
    "required = 1.0\n";

std::string plate_section(const std::string& name, const std::string& flange) {
  return "[sections." + name +
         "]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\nflange = \"" + flange +
         "\"\nweb = \"8 mm\"\n";
}

std::vector<BeamCut> cuts_of(const Project& project) {
  const std::deque<SituationRun> runs = run_situations(project);
  return beam_cuts_of(project, runs, bending_zones_of(project, runs));
}

/// The cut at a place, or nothing.
const BeamCut* cut_at(const std::vector<BeamCut>& cuts, double s) {
  for (const BeamCut& cut : cuts) {
    if (std::abs(cut.s.value() - s) < 1e-9) return &cut;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("a kink of the outline cuts the beam in two sides, a joint of equal slopes does not") {
  // 12 to 16 mm over 1 m, 16 to 20 mm over 1 m: one slope. Then constant: a kink.
  const Project project = test::planar_cantilever(
      3.0, plate_section("a", "12 mm") + plate_section("b", "16 mm") + plate_section("c", "20 mm"),
      "[[beam.segments]]\nlength = \"1 m\"\nfrom = \"a\"\nto = \"b\"\n"
      "[[beam.segments]]\nlength = \"1 m\"\nfrom = \"b\"\nto = \"c\"\n"
      "[[beam.segments]]\nlength = \"1 m\"\nsection = \"c\"\n",
      {{3.0}}, fatigue);
  CHECK_FALSE(kinks_behind(project.beam, 0));
  CHECK(kinks_behind(project.beam, 1));
  const std::vector<BeamCut> cuts = cuts_of(project);
  REQUIRE(cut_at(cuts, 2.0) != nullptr);
  CHECK(cut_at(cuts, 2.0)->sides);
  // At 1 m the flange reaches 16 mm, up to which S355 has 355 MPa: two sides all the same.
  REQUIRE(cut_at(cuts, 1.0) != nullptr);
  CHECK(cut_at(cuts, 1.0)->sides);
}

TEST_CASE("a plate that crosses a step of the steel's strength cuts the beam there") {
  // 12 to 24 mm over 3 m: 16 mm at 1 m.
  const Project project = test::planar_cantilever(
      3.0, plate_section("a", "12 mm") + plate_section("b", "24 mm"),
      "[[beam.segments]]\nlength = \"3 m\"\nfrom = \"a\"\nto = \"b\"\n", {{3.0}}, fatigue);
  const std::vector<BeamCut> cuts = cuts_of(project);
  const BeamCut* const cut = cut_at(cuts, 1.0);
  REQUIRE(cut != nullptr);
  CHECK(cut->sides);
  const auto flange_on = [&](Side side) {
    return std::get<Box>(judged_section_at(project, {cut->s, side}).outer).top_flange.value();
  };
  CHECK(flange_on(Side::before) <= 0.016);
  CHECK(flange_on(Side::behind) > 0.016);
  CHECK(flange_on(Side::behind) == Approx(0.016).epsilon(1e-7));
}

TEST_CASE("forces on the beam cut it, at whatever instant they act first") {
  // The force at 1 m is zero at the beginning: 5 - 5 cos.
  const Project project = test::planar_cantilever(
      3.0, plate_section("a", "12 mm"), "[[beam.segments]]\nlength = \"3 m\"\nsection = \"a\"\n",
      {{3.0}, {1.0, -90.0, 5.0, 5.0, 1.0, -90.0}}, fatigue);
  const std::vector<BeamCut> cuts = cuts_of(project);
  REQUIRE(cut_at(cuts, 1.0) != nullptr);
  CHECK(cut_at(cuts, 1.0)->sides);
  CHECK(cuts.front().s.value() == 0.0);
  CHECK(cuts.back().s.value() == 3.0);
}

TEST_CASE("ends of details are cut on both sides, named places and holes on none of their own") {
  const std::vector<BeamCut> cuts = cuts_of(test::rig());
  for (const BeamDetail& detail : test::rig().fatigue.details) {
    for (const double s : {detail.from.value(), detail.to.value()}) {
      REQUIRE(cut_at(cuts, s) != nullptr);
      CHECK(cut_at(cuts, s)->sides);
    }
  }
  for (const BeamHole& hole : test::rig().holes) {
    REQUIRE(cut_at(cuts, hole.s.value()) != nullptr);
    CHECK(cut_at(cuts, hole.s.value())->alone);
  }
  for (std::size_t i = 1; i < cuts.size(); ++i) CHECK(cuts[i - 1].s < cuts[i].s);
}

TEST_CASE("where a hole begins and ends the web is whole, and the beam is looked at") {
  // A hole of 60 mm around s = 1 m: from 0.97 to 1.03 m.
  const Project project = test::planar_cantilever(
      2.0, plate_section("a", "12 mm"),
      "[[beam.segments]]\nlength = \"2 m\"\nsection = \"a\"\n"
      "[[beam.holes]]\nname = \"access\"\ndiameter = \"60 mm\"\nstation = \"1 m\"\n"
      "through = \"webs\"\nlevels = [\"0 mm\"]\nconcentration = \"in-plane bending\"\n",
      {{2.0}}, fatigue);
  const std::vector<BeamCut> cuts = cuts_of(project);
  REQUIRE(cut_at(cuts, 1.0) != nullptr);
  CHECK(cut_at(cuts, 1.0)->alone);
  for (const double s : {0.97, 1.03}) {
    REQUIRE(cut_at(cuts, s) != nullptr);
    CHECK_FALSE(cut_at(cuts, s)->alone);
    CHECK_FALSE(cut_at(cuts, s)->sides);
  }
}

TEST_CASE("where shear lag begins to count in a plate of a tapered path the beam is cut") {
  // Clamped, L_e = 6 m: outstands from 100 to 350 mm, b_0 = L_e/50 = 120 mm after 0.24 m; kappa =
  // 0.02 at the same place. Level flanges, no web: z alone is lag's axis of bending.
  const auto girder = [](double width) { return paths::i_section(width, 20.0, 600.0, 12.0); };
  Project project = parse_project(
      "path.toml",
      slender_cases::cantilever(
          path_cases::section("a", girder(200.0)) + path_cases::section("b", girder(700.0)),
          slender_cases::taper(3.0, "a", "b"), slender_cases::tip(3.0, -50.0)));
  CHECK(cut_at(cuts_of(project), 0.24) == nullptr);
  project.strength.shear_lag = true;
  const std::vector<BeamCut> cuts = cuts_of(project);
  REQUIRE(cut_at(cuts, 0.24) != nullptr);
  CHECK(cut_at(cuts, 0.24)->sides);
  // kappa = 0.7 with L_e = 6 m: b_0 = 4.2 m.
  const auto wide = [](double width) { return paths::i_section(width, 60.0, 600.0, 12.0); };
  Project deck = parse_project(
      "path.toml",
      slender_cases::cantilever(
          path_cases::section("a", wide(8000.0)) + path_cases::section("b", wide(9000.0)),
          slender_cases::taper(3.0, "a", "b"), slender_cases::tip(3.0, -50.0)));
  deck.strength.shear_lag = true;
  // From 4.0 to 4.5 m: after 1.2 m.
  const std::vector<BeamCut> of_deck = cuts_of(deck);
  REQUIRE(cut_at(of_deck, 1.2) != nullptr);
  CHECK(cut_at(of_deck, 1.2)->sides);
}

}  // namespace beam_cuts_test
