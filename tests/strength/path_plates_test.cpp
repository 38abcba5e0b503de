// Which plates the walls of a path are: by table 5.2 of EN 1993-1-1 and by splitting what is one.

#include "boxbeam/strength/path_plates.hpp"

#include <cmath>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "catch.hpp"
#include "support/paths.hpp"

namespace path_plates_test {

using namespace boxbeam;
using namespace paths;

namespace {

const Material& steel() {
  static const Material s355 = *find_steel("S355");
  return s355;
}

std::vector<PathPlate> plates(const ThinWalled& path) { return plates_of(path, steel()); }

const PathPlate& named(const std::vector<PathPlate>& of, const std::string& name) {
  for (const PathPlate& plate : of)
    if (plate.name == name) return plate;
  FAIL("no " + name);
  return of.front();
}

}  // namespace

TEST_CASE("an I has two outstands on each side of its web, each to the web's face") {
  // 400 x 20 flanges, web 1200 x 10 between them: c = (400 - 10)/2 = 195, h_w = 1200.
  const auto of = plates(i_section(400.0, 20.0, 1200.0, 10.0));
  REQUIRE(of.size() == 5);
  int outstands = 0;
  for (const PathPlate& plate : of) {
    CHECK(width_obstacle(plate).empty());
    if (plate.outstand()) {
      CHECK(plate.clear().value() == Approx(0.195).epsilon(1e-12));
      ++outstands;
    } else {
      CHECK(plate.clear().value() == Approx(1.2).epsilon(1e-12));
    }
  }
  CHECK(outstands == 4);
}

TEST_CASE("splitting the walls of a path changes no plate", "[plates]") {
  for (const ThinWalled& whole :
       {i_section(400.0, 20.0, 1200.0, 10.0), box_path(600.0, 1224.0, 12.0, 8.0),
        channel(1200.0, 200.0, 8.0, 12.0)}) {
    const auto slender = [](const ThinWalled& path) {
      std::vector<double> ratios;
      for (const SlenderPlate& of : plate_slenderness_of(path, steel()))
        ratios.push_back(of.ratio / of.limit);
      std::sort(ratios.begin(), ratios.end());
      return ratios;
    };
    const auto before = slender(whole);
    for (std::size_t i = 0; i < whole.walls.size(); ++i) {
      const auto after = slender(split(split(whole, i, 0.3), i, 0.6));
      REQUIRE(after.size() == before.size());
      for (std::size_t k = 0; k < after.size(); ++k)
        CHECK(after[k] == Approx(before[k]).epsilon(1e-12));
    }
  }
}

TEST_CASE("half an outstand is no internal plate, and a tip no outstand by itself", "[plates]") {
  // A flange of c = 24 t of S355, beyond 14 eps = 11.4, as two walls of 12 t: the outer one by
  // itself would be at 12, the inner one at 12 of 34.
  const ThinWalled whole = i_section(490.0, 10.0, 600.0, 10.0);
  ThinWalled path = whole;
  for (const std::size_t wall : {0U, 1U, 2U, 3U}) path = split(path, wall, 0.5);
  CHECK(slender_plates_of(path, steel()).size() == slender_plates_of(whole, steel()).size());
  CHECK(slender_plates_of(path, steel()).front().ratio == Approx(24.0).epsilon(1e-12));
}

TEST_CASE("a rib does not make two plates of one, a web does", "[plates]") {
  ThinWalled box = box_path(1000.0, 600.0, 10.0, 10.0);
  const auto widest = [](const ThinWalled& path) {
    Length most;
    for (const PathPlate& of : plates(path)) most = std::max(most, of.clear());
    return most.value();
  };
  CHECK(widest(box) == Approx(0.98));
  // Flat ribs, T ribs and small troughs on the top flange leave it as wide as it is.
  const auto [top_left, top_right] = std::pair{std::size_t{0}, std::size_t{1}};
  const auto with_rib = [&](double y, double depth, double foot) {
    ThinWalled path = box;
    const std::size_t at = split_at(path, top_left, top_right, mm_place(y, 295.0));
    const std::size_t tip = add_node(path, mm_place(y, 295.0 - depth));
    add_wall(path, at, tip, 10.0);
    if (foot > 0.0) {
      add_wall(path, tip, add_node(path, mm_place(y + foot, 295.0 - depth)), 10.0);
      add_wall(path, tip, add_node(path, mm_place(y - foot, 295.0 - depth)), 10.0);
    }
    return path;
  };
  CHECK(widest(with_rib(0.0, 100.0, 0.0)) == Approx(0.98));
  CHECK(widest(with_rib(0.0, 100.0, 40.0)) == Approx(0.98));
  bool ribbed = false;
  for (const PathPlate& of : plates(with_rib(0.0, 100.0, 0.0)))
    ribbed = ribbed || (of.ribbed && !width_obstacle(of).empty());
  CHECK(ribbed);
  ThinWalled trough = box;
  const std::size_t a = split_at(trough, top_left, top_right, mm_place(100.0, 295.0));
  const std::size_t b = split_at(trough, a, top_right, mm_place(-100.0, 295.0));
  const std::size_t c = add_node(trough, mm_place(60.0, 195.0));
  const std::size_t d = add_node(trough, mm_place(-60.0, 195.0));
  add_wall(trough, a, c, 6.0);
  add_wall(trough, c, d, 6.0);
  add_wall(trough, d, b, 6.0);
  CHECK(widest(trough) == Approx(0.98));
  // A T rib as deep as most of the flange beside it does not halve the web of an I either.
  ThinWalled girder = split(i_section(300.0, 20.0, 1200.0, 10.0), 4, 0.5);
  const std::size_t foot = girder.nodes.size() - 1;
  const std::size_t tip = add_node(girder, mm_place(100.0, 0.0));
  add_wall(girder, foot, tip, 10.0);
  add_wall(girder, tip, add_node(girder, mm_place(100.0, 40.0)), 10.0);
  add_wall(girder, tip, add_node(girder, mm_place(100.0, -40.0)), 10.0);
  CHECK(widest(girder) == Approx(1.2));
  // A middle web from flange to flange halves both.
  ThinWalled cells = box;
  const std::size_t e = split_at(cells, top_left, top_right, mm_place(0.0, 295.0));
  const std::size_t f = split_at(cells, 2, 3, mm_place(0.0, -295.0));
  add_wall(cells, e, f, 10.0, 5.0, 5.0);
  CHECK(widest(cells) == Approx(0.58));  // now the webs, 600 - 2 x 10
}

TEST_CASE("the stem of a T holds its flange, each leg of an angle the other", "[plates]") {
  ThinWalled tee;
  const std::size_t middle = add_node(tee, mm_place(0.0, 0.0));
  add_wall(tee, add_node(tee, mm_place(100.0, 0.0)), middle, 10.0);
  add_wall(tee, middle, add_node(tee, mm_place(-100.0, 0.0)), 10.0);
  add_wall(tee, middle, add_node(tee, mm_place(0.0, -150.0)), 10.0);
  REQUIRE(plates(tee).size() == 3);
  for (const PathPlate& of : plates(tee)) {
    CHECK(of.outstand());
    CHECK(width_obstacle(of).empty());
  }
  ThinWalled angle;
  const std::size_t heel = add_node(angle, mm_place(0.0, 0.0));
  add_wall(angle, add_node(angle, mm_place(100.0, 0.0)), heel, 5.0);
  add_wall(angle, heel, add_node(angle, mm_place(0.0, 100.0)), 5.0);
  REQUIRE(plates(angle).size() == 2);
  for (const PathPlate& of : plates(angle)) {
    CHECK(of.outstand());
    CHECK(of.clear().value() == Approx(0.0975));
    CHECK(width_obstacle(of).empty());
  }
}

TEST_CASE("the web of a channel is internal by its flanges, not by edges that are too weak",
          "[plates]") {
  CHECK(!named(plates(channel(1200.0, 200.0, 8.0, 12.0)), "wall 2").outstand());
  // I_a = 4096 (115 (1188/8)/31.13 + 5) = 2.27e6 mm^4, I_s = 12 c^3/12: c from 131 mm on.
  CHECK(!named(plates(channel(1200.0, 139.0, 8.0, 12.0)), "wall 2").outstand());
  CHECK(named(plates(channel(1200.0, 134.0, 8.0, 12.0)), "wall 2").outstand());
  // Walls that reach to the outer faces at the corners change nothing of that.
  ThinWalled square = channel(1200.0, 134.0, 8.0, 12.0);
  square.walls[0].trim_to = square.walls[2].trim_from = mm(-4.0);
  CHECK(named(plates(square), "wall 2").outstand());
}

TEST_CASE("flanges that are mere beads do not hold the web of an I", "[plates]") {
  // As of the channel above: together 2 c >= 131 mm.
  CHECK(!named(plates(i_section(142.0, 12.0, 1188.0, 8.0)), "wall 5").outstand());
  const PathPlate web = named(plates(i_section(132.0, 12.0, 1188.0, 8.0)), "wall 5");
  CHECK(web.outstand());
  CHECK(width_obstacle(web).find("too weak") != std::string::npos);
}

TEST_CASE("a flange with a lip is internal up to class 3 and has no effective width", "[plates]") {
  const auto flange_of = [](double lip) {
    ThinWalled path = channel(200.0, 80.0, 2.5, 2.5);
    const std::size_t tip = add_node(path, mm_place(80.0, 100.0 - 1.25 - lip));
    add_wall(path, path.walls[0].from, tip, 2.5);
    return named(plates(path), "wall 1");
  };
  CHECK(flange_of(10.0).outstand());
  CHECK(!width_obstacle(flange_of(10.0)).empty());
  CHECK(!flange_of(40.0).outstand());
  CHECK(width_obstacle(flange_of(40.0)).find("lip") != std::string::npos);
}

TEST_CASE("a polygon of many flat sides is one plate, folded", "[plates]") {
  const auto ring = [](int sides) {
    ThinWalled path;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / sides;
      add_node(path, mm_place(500.0 * std::cos(angle), 500.0 * std::sin(angle)));
    }
    for (int i = 0; i < sides; ++i)
      add_wall(path, static_cast<std::size_t>(i), static_cast<std::size_t>((i + 1) % sides), 5.0);
    return plates(path);
  };
  REQUIRE(ring(24).size() == 1);
  CHECK(ring(24).front().clear().value() > 3.0);
  CHECK(!width_obstacle(ring(24).front()).empty());
  CHECK(ring(12).size() == 12);
}

}  // namespace path_plates_test
