// Distortion of thin-walled paths: around a rectangle as of the box itself, plates cut in pieces as
// whole ones, plates that lead on by hand; around other cells, what must not be judged.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/gates.hpp"
#include "support/path_cases.hpp"

namespace distorted_paths_test {

using namespace boxbeam;
using test::blocks;
using namespace slender_cases;
using namespace paths;
using path_cases::section;

namespace {

std::string twist(double at, double kNm) {
  return fmt::format(
      "[loads.twist]\nkind = \"force\"\nat = [\"{} m\", \"0 m\", \"0 m\"]\n"
      "force = [\"0 N\", \"0 N\", \"0 N\"]\nmoment = [\"{} kN m\", \"0 N m\", \"0 N m\"]\n",
      at, kNm);
}

/// A weightless beam of 8 m between forks.
Verification forked(const std::string& sections, const std::string& more, const std::string& loads,
                    const std::string& segments = segment(8.0, "a")) {
  return verified(
      "[case]\nname = \"path\"\nkind = \"static\"\n[frame]\nspace = true\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
      sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments + more +
      "[supports.a]\nkind = \"pinned\"\nat = [\"0 m\", \"0 m\", \"0 m\"]\nfork = true\n"
      "[supports.z]\nkind = \"roller\"\nat = [\"8 m\", \"0 m\", \"0 m\"]\ndirection = \"z\"\n"
      "fork = true\n"
      "[supports.y]\nkind = \"roller\"\nat = [\"8 m\", \"0 m\", \"0 m\"]\ndirection = \"y\"\n" +
      loads + steel + "[strength]\nrequired = 1.0\nshear_lag = false\n");
}

double distorted(const Verification& of) {
  const CheckResult* const worst = of.governing(Criterion::distortion);
  return worst == nullptr ? 0.0 : worst->check.utilisation();
}

/// A box of webs that lean, top 400 and bottom 300, 10 mm all around.
ThinWalled leaning(double height = 400.0) {
  ThinWalled path = box_path(400.0, height, 10.0, 10.0);
  path.nodes[2].y = mm(150.0);
  path.nodes[3].y = mm(-150.0);
  return path;
}

}  // namespace

TEST_CASE("a path around a rectangle is distorted as the box", "[distortion]") {
  // Stout, without diaphragms and with one in the middle that is thin; b/h changes under torque.
  const std::pair<std::string, std::string> cases[] = {{"", twist(4.0, 60.0)},
                                                       {diaphragms({4.0}, 3.0), twist(4.0, 60.0)},
                                                       {diaphragms({0.0, 8.0}), twist(3.0, 60.0)}};
  const std::string box_a = box("a", 400.0, 400.0, 14.0, 12.0),
                    box_b = box("b", 200.0, 600.0, 14.0, 12.0);
  const std::string path_a = section("a", box_path(400.0, 400.0, 14.0, 12.0)),
                    path_b = section("b", box_path(200.0, 600.0, 14.0, 12.0));
  for (const auto& [more, loads] : cases) {
    for (const std::string& segments : {segment(8.0, "a"), taper(8.0, "a", "b")}) {
      CAPTURE(more, loads, segments);
      const Verification as_box = forked(box_a + box_b, more, loads, segments);
      const Verification as_path = forked(path_a + path_b, more, loads, segments);
      CHECK(distorted(as_box) > 0.1);
      CHECK(distorted(as_path) == Approx(distorted(as_box)).epsilon(5e-3));
      CHECK(blocks(as_path, "so that the box keeps its shape") ==
            blocks(as_box, "so that the box keeps its shape"));
    }
  }
}

TEST_CASE("the cell of a path: plates in pieces, flats, and what is none", "[distortion]") {
  const ThinWalled whole = box_path(600.0, 900.0, 14.0, 10.0, 12.0);
  const BoxCell of = *box_cell_of(Profile(whole));
  CHECK(of.width.value() == Approx(0.590));
  CHECK(of.height.value() == Approx(0.887));
  CHECK(of.thickness == std::array{mm(14.0), mm(12.0), mm(10.0), mm(10.0)});
  // A flat in the middle of the top plate, which is two walls then.
  ThinWalled flat = split(whole, 0, 0.5);
  const std::size_t middle = flat.nodes.size() - 1;
  const SectionPlace& on = flat.nodes[middle];
  add_wall(flat, middle, add_node(flat, {on.y, on.z - mm(100.0)}), 10.0, 7.0);
  REQUIRE(box_cell_of(Profile(flat)));
  CHECK(box_cell_of(Profile(flat))->thickness == of.thickness);
  ThinWalled unlike = split(whole, 0, 0.5);
  unlike.walls.back().thickness = mm(13.0);
  CHECK_FALSE(box_cell_of(Profile(unlike)));
  ThinWalled two = split(split(whole, 0, 0.5), 1, 0.5);
  add_wall(two, two.nodes.size() - 2, two.nodes.size() - 1, 10.0, 7.0, 6.0);
  CHECK_FALSE(box_cell_of(Profile(two)));
  CHECK_FALSE(box_cell_of(Profile(leaning())));
  CHECK_FALSE(box_cell_of(Profile(i_section(400.0, 12.0, 600.0, 8.0))));
}

TEST_CASE("where plates of a path lead on, omega does: by hand", "[distortion]") {
  // Of equal webs and equal flanges omega = y z: at a tip 100 mm beyond the webs as y there.
  ThinWalled path = box_path(412.0, 612.0, 12.0, 12.0);
  add_wall(path, add_node(path, mm_place(300.0, 300.0)), 0, 12.0);
  const Profile profile(path);
  const BoxCell cell = *box_cell_of(profile);
  const CellDistortion stiffness = cell_distortion_of(cell, 210e9, 0.3);
  const std::vector<CellPlace> tip = places_in_cell(profile, mm(300.0), mm(306.0));
  const std::vector<CellPlace> corner = places_in_cell(profile, mm(200.0), mm(300.0));
  REQUIRE(tip.size() == 1);
  REQUIRE(corner.size() == 2);
  const DistortionInfluence at_tip = distortion_at(cell, stiffness, tip[0]);
  CHECK(at_tip.along ==
        Approx(1.5 * distortion_at(cell, stiffness, corner[0]).along).epsilon(1e-9));
  CHECK(at_tip.across == 0.0);
}

TEST_CASE("other cells under torque: kept in shape where it comes, or no verdict", "[distortion]") {
  const std::string path = section("a", leaning()), other = section("b", leaning(600.0));
  const std::string words = "cells that are no rectangle";
  const auto is_blocked = [&](const std::string& more, const std::string& loads,
                              const std::string& segments = segment(8.0, "a")) {
    return blocks(forked(path + other, more, loads, segments), words);
  };
  const std::string firm = diaphragms({0.0, 4.0, 8.0}, 12.0);
  CHECK(is_blocked("", twist(4.0, 60.0)));
  CHECK(is_blocked(diaphragms({0.0, 8.0}, 12.0), twist(4.0, 60.0)));
  CHECK(is_blocked(diaphragms({0.0, 4.0, 8.0}, 1.0), twist(4.0, 60.0)));
  // Bredt's flow of the jump, 60 kN m/(2 x 0.35 x 0.39 m^2), in 1 mm: 220 MPa, above f_y/sqrt(3);
  // in 12 mm next to nothing.
  CHECK_FALSE(is_blocked(firm, twist(4.0, 60.0)));
  CHECK(is_blocked(firm, twist(4.0, 60.0), taper(8.0, "a", "b")));
  // What is taken for granted of their shape stands with the verdict.
  const Verification held = forked(path, firm, twist(4.0, 60.0));
  CHECK(std::any_of(held.not_judged.begin(), held.not_judged.end(),
                    [](const NotJudged& of) { return of.by == Criterion::distortion; }));
  // Without torque there is nothing to say.
  CHECK_FALSE(is_blocked("",
                         "[loads.p]\nkind = \"force\"\nat = [\"4 m\", \"0 m\", \"0 m\"]\n"
                         "force = [\"0 N\", \"0 N\", \"-10 kN\"]\n"));
}

}  // namespace distorted_paths_test
