// First moments behind the shear stress at a level, by hand.

#include "boxbeam/section/level_shear.hpp"

#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"

namespace level_shear_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
double mm3(SectionModulus S) { return S.value() * 1e9; }

const SectionPoint& named(const std::vector<SectionPoint>& points, const std::string& name) {
  for (const SectionPoint& point : points) {
    if (point.name == name) return point;
  }
  FAIL("no point " << name);
  return points.front();
}

/// The moment behind V_z at a named place in the plane.
std::optional<LevelMoment> behind(const Section& section, const std::string& name) {
  const auto points = points_of(stress_field_of(section, {}, {}), PointSet::in_plane);
  const SectionPoint& at = named(points, name);
  return level_moment_of(section, {}, at.z, at.prismatic.shear[cut_force::V_z]);
}

}  // namespace

TEST_CASE("the first moment behind the shear of a box is that of what lies beyond", "[section]") {
  const Section section{symmetric_box(mm(400), mm(600), mm(50), mm(50)), {}};
  const auto neutral = behind(section, "neutral axis");
  REQUIRE(neutral);
  CHECK(mm3(neutral->S) == Approx(400.0 * 50 * 275 + 2 * 50.0 * 250 * 125));
  CHECK(neutral->b.value() == Approx(0.1));
  CHECK_FALSE(neutral->on_webs);
  const auto seam = behind(section, "web end +z");
  REQUIRE(seam);
  CHECK(mm3(seam->S) == Approx(400.0 * 50 * 275));
}

TEST_CASE("a stiffener hangs on the webs by its flange, wherever it reaches", "[section]") {
  Box box = symmetric_box(mm(400), mm(600), mm(20), mm(20));
  box.stiffeners.push_back({BoxPlate::top_flange, mm(0), mm(100), mm(10)});
  box.stiffeners.push_back({BoxPlate::bottom_flange, mm(0), mm(100), mm(10)});
  const auto seam = behind({box, {}}, "web end +z");
  REQUIRE(seam);
  CHECK(seam->on_webs);
  CHECK(mm3(seam->S) == Approx(400.0 * 20 * 290 + 100.0 * 10 * 230));
  CHECK(seam->b.value() == Approx(0.04));
}

TEST_CASE("webs of a box around a tube carry what hangs on them, not the tube", "[section]") {
  const Section section{symmetric_box(mm(400), mm(600), mm(50), mm(50)),
                        symmetric_box(mm(200), mm(400), mm(20), mm(20))};
  const auto neutral = behind(section, "neutral axis");
  REQUIRE(neutral);
  CHECK(neutral->on_webs);
  CHECK(mm3(neutral->S) == Approx(400.0 * 50 * 275 + 2 * 50.0 * 250 * 125));
  CHECK(neutral->b.value() == Approx(0.1));
}

TEST_CASE("a plate's first moment is that of half of it; another stress has none", "[section]") {
  const Section plate{Plate{mm(40), mm(200)}, {}};
  const auto neutral = behind(plate, "neutral axis");
  REQUIRE(neutral);
  CHECK(mm3(neutral->S) == Approx(40.0 * 100 * 50));
  CHECK(neutral->b.value() == Approx(0.04));
  CHECK_FALSE(level_moment_of(plate, {}, mm(0), 1.0));
  Box unlike = symmetric_box(mm(400), mm(600), mm(50), mm(50));
  unlike.left_web = mm(30);
  CHECK_FALSE(moment_on_webs({unlike, {}}, {}, mm(0)));
}

TEST_CASE("the shear of a torque is Bredt's flow and the wall's own stress on its face",
          "[section]") {
  // A box 100 x 100 x 10: mid-lines 90 x 90, walls 360 mm of material.
  const Section section{symmetric_box(mm(100), mm(100), mm(10), mm(10)), {}};
  const StressField field = stress_field_of(section, {}, {});
  int walls = 0;
  for (const SectionPoint& point : points_of(field, PointSet::in_space)) {
    if (!point.torsion) continue;
    ++walls;
    const WallTorsion& of = *point.torsion;
    CHECK(of.enclosed * 1e6 == Approx(90.0 * 90));
    CHECK(of.I_w * 1e12 == Approx(360.0 * 1000 / 3));
    CHECK(of.thickness == Approx(0.01));
    const double bredt = 1.0 / (2.0 * of.enclosed * of.thickness);
    CHECK(std::abs(of.flow / of.thickness) == Approx((1.0 - of.I_w / of.I_T) * bredt));
    CHECK(std::abs(of.face) == Approx(of.thickness / of.I_T));
    CHECK(point.influence.shear[cut_force::T] == Approx(of.flow / of.thickness + of.face));
    REQUIRE(point.throat.has_value() == (point.name.find("web end") == 0));
    if (point.throat)
      CHECK(point.throat->influence.shear[cut_force::T] == Approx(of.flow / of.thickness));
  }
  CHECK(walls >= 8);
}

TEST_CASE("an open section carries torsion in its walls alone", "[section]") {
  ThinWalled channel;
  channel.nodes = {{mm(100), mm(200)}, {mm(0), mm(200)}, {mm(0), mm(0)}, {mm(100), mm(0)}};
  channel.walls = {{0, 1, mm(10)}, {1, 2, mm(10)}, {2, 3, mm(10)}};
  for (const SectionPoint& point :
       points_of(stress_field_of({channel, {}}, {}, {}), PointSet::all)) {
    REQUIRE(point.torsion);
    CHECK(point.torsion->flow == 0.0);
    CHECK(point.torsion->enclosed == 0.0);
    CHECK(point.torsion->I_T == Approx(point.torsion->I_w));
    CHECK(point.influence.shear[cut_force::T] == Approx(point.torsion->face));
  }
}

}  // namespace level_shear_test
