// Stress at named places: hand formulas, one sign of each cut force.

#include "boxbeam/section/section_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/wall_stretches.hpp"
#include "catch.hpp"
#include "section/random_sections.hpp"

namespace section_points_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

SectionPoint point_of(const StressField& field, PointSet set, const std::string& name) {
  for (const SectionPoint& point : points_of(field, set)) {
    if (point.name == name) return point;
  }
  throw std::runtime_error("no point " + name);
}

std::vector<std::string> names_of(const Section& section, PointSet set) {
  std::vector<std::string> names;
  for (const SectionPoint& point : points_of(stress_field_of(section, {}, {}), set)) {
    names.push_back(point.name);
  }
  return names;
}

// 400 x 600, plates 50.
const Section box{symmetric_box(mm(400), mm(600), mm(50), mm(50)), {}};

}  // namespace

TEST_CASE("in plane a box has the places that can govern", "[section]") {
  CHECK(names_of(box, PointSet::in_plane) == std::vector<std::string>{"fibre +z", "fibre -z",
                                                                      "web end +z", "web end -z",
                                                                      "neutral axis"});
  const Section nested{box.outer, RoundTube{mm(200), mm(10)}};
  CHECK(names_of(nested, PointSet::in_plane).back() == "inner fibre -z");
}

TEST_CASE("every place has a name of its own, in any section", "[section]") {
  test::RandomSections random(1);
  const Polygon triangle{{{mm(0), mm(0)}, {mm(100), mm(0)}, {mm(0), mm(80)}}};
  for (const Profile& profile :
       {Profile{random.box()}, Profile{random.rolled()}, Profile{random.path()},
        Profile{RoundTube{mm(100), mm(5)}}, Profile{Plate{mm(20), mm(100)}}, Profile{triangle}}) {
    const auto names = names_of({profile, {}}, PointSet::all);
    CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
  }
}

TEST_CASE("signs: N pulls, M_y > 0 pulls +z, M_z > 0 pulls -y", "[section]") {
  const StressField field = stress_field_of(box, {}, {});
  const StressInfluence at = point_of(field, PointSet::all, "corner +y +z").influence;
  CHECK(at.normal[cut_force::N] == Approx(1 / 0.09).epsilon(1e-12));
  CHECK(at.normal[cut_force::M_y] == Approx(0.3 / 4.075e-3).epsilon(1e-12));
  CHECK(at.normal[cut_force::M_z] == Approx(-0.2 / 2.075e-3).epsilon(1e-12));
}

TEST_CASE("signs of shear: V_z runs up both webs, T up the left one and down the right one",
          "[section]") {
  const StressField field = stress_field_of(box, {}, {});
  const auto left = point_of(field, PointSet::all, "neutral axis +y").influence;
  const auto right = point_of(field, PointSet::all, "neutral axis -y").influence;
  CHECK(left.shear[cut_force::V_z] > 0.0);
  CHECK(right.shear[cut_force::V_z] == Approx(left.shear[cut_force::V_z]).epsilon(1e-12));
  CHECK(left.shear[cut_force::T] > 0.0);
  CHECK(right.shear[cut_force::T] == Approx(-left.shear[cut_force::T]).epsilon(1e-12));
  // V_y runs along +y in both flanges.
  CHECK(point_of(field, PointSet::all, "fibre +z").influence.shear[cut_force::V_y] > 0.0);
  CHECK(point_of(field, PointSet::all, "fibre -z").influence.shear[cut_force::V_y] > 0.0);
  // The outer face has Bredt's flow and its own t/I_T: a little more than T/(2 A_m t).
  const double bredt = 1 / (2 * 0.35 * 0.55 * 0.05);
  CHECK(left.shear[cut_force::T] > bredt);
  CHECK(left.shear[cut_force::T] < 1.25 * bredt);
}

TEST_CASE("a force through a corner of the axis turns the section: unlike webs", "[section]") {
  // The left web 20, the right web 10: the shear centre lies towards the thicker one.
  const Section unlike{Box{mm(400), mm(600), mm(20), mm(20), mm(20), mm(10)}, {}};
  CHECK(torsion_properties_of(unlike).shear_centre->y.value() > 0.0);
  CHECK(names_of(unlike, PointSet::in_plane) == names_of(unlike, PointSet::all));
}

TEST_CASE("a section that mirrors itself and tapers to one that does not is looked at whole") {
  // The right web grows along the beam: at its start both are alike, their shear is not.
  Box grown = symmetric_box(mm(400), mm(600), mm(20), mm(20));
  const Section here{grown, {}};
  grown.right_web = mm(30);
  const Taper taper{{Section{grown, {}}, 1.0}, {here, -1.0}};
  const StressField prismatic = stress_field_of(here, {}, {});
  const StressField tapered = stress_field_of(here, {}, taper);
  CHECK(is_mirrored(prismatic));
  CHECK_FALSE(is_mirrored(tapered));
  CHECK(points_of(prismatic, PointSet::in_plane).size() <
        points_of(prismatic, PointSet::all).size());
  CHECK(points_of(tapered, PointSet::in_plane).size() == points_of(tapered, PointSet::all).size());
  const auto shear = [&](const char* name) {
    return point_of(tapered, PointSet::in_plane, name).influence.shear[cut_force::M_y];
  };
  const double left = shear("web end +y +z"), right = shear("web end -y +z");
  CAPTURE(left, right);
  CHECK(std::abs(left) != Approx(std::abs(right)).epsilon(1e-3));
  // Both webs together take what the flange's force M S_f/I changes by over 1 m.
  const double S_f = 0.4 * 0.02 * 0.29;
  const double I = (0.4 * 0.6 * 0.6 * 0.6 - 0.36 * 0.56 * 0.56 * 0.56) / 12.0;
  const double I_grown = I + 0.01 * 0.56 * 0.56 * 0.56 / 12.0;
  CHECK(0.02 * std::abs(left + right) == Approx(S_f / I - S_f / I_grown).epsilon(1e-9));
}

TEST_CASE("seam of a box: q/a on the throat, q/t_w at full penetration", "[section]") {
  Box welded = symmetric_box(mm(400), mm(600), mm(50), mm(50));
  const double q = 0.5 * 400 * 50 * 275e-9 / 4.075e-3;  // V S/(2 I) by hand
  const auto seam = [](const Box& of) {
    return point_of(stress_field_of({of, {}}, {}, {}), PointSet::in_plane, "web end +z");
  };
  REQUIRE(seam(welded).throat);
  CHECK(seam(welded).throat->name == "seam +z throat");
  CHECK(seam(welded).throat->influence.shear[cut_force::V_z] == Approx(q / 0.05).epsilon(1e-12));
  welded.seam_throat = mm(8);
  CHECK(seam(welded).throat->influence.shear[cut_force::V_z] == Approx(q / 0.008).epsilon(1e-12));
  CHECK(seam(welded).influence.shear[cut_force::V_z] == Approx(q / 0.05).epsilon(1e-12));
}

TEST_CASE("an inner box has seams of its own, in the plane and in space", "[section]") {
  // V S/(2 I) by hand: each of two boxes about one centre carries its own flow.
  Box inner = symmetric_box(mm(200), mm(300), mm(20), mm(10));
  inner.seam_throat = mm(4);
  const Section nested{symmetric_box(mm(400), mm(600), mm(50), mm(50)), inner};
  const double I = 4.075e-3 + (200.0 * 300 * 300 * 300 - 180.0 * 260 * 260 * 260) / 12.0 * 1e-12;
  const double q = 0.5 * 200 * 20 * 140e-9 / I;
  const StressField field = stress_field_of(nested, {}, {});
  const auto throat = [&](PointSet set, const std::string& name) {
    const std::optional<SeamThroat> seam = point_of(field, set, name).throat;
    REQUIRE(seam);
    return seam->influence.shear[cut_force::V_z];
  };
  CHECK(throat(PointSet::in_plane, "inner web end +z") == Approx(q / 0.004).epsilon(1e-9));
  CHECK(throat(PointSet::in_plane, "inner web end -z") == Approx(q / 0.004).epsilon(1e-9));
  for (const char* at : {"+y +z", "+y -z", "-y +z", "-y -z"}) {
    CHECK(throat(PointSet::in_space, fmt::format("inner web end {}", at)) ==
          Approx(q / 0.004).epsilon(1e-9));
  }
  const double outer = 0.5 * 400 * 50 * 275e-9 / I;
  CHECK(throat(PointSet::in_plane, "web end +z") == Approx(outer / 0.05).epsilon(1e-9));
}

TEST_CASE("plate: 1.5 V/A in the middle both ways, torsion by the series", "[section]") {
  const StressField field = stress_field_of({Plate{mm(20), mm(100)}, {}}, {}, {});
  const auto side = point_of(field, PointSet::in_plane, "neutral axis").influence;
  CHECK(side.shear[cut_force::V_z] == Approx(1.5 / 2e-3).epsilon(1e-12));
  CHECK(side.shear[cut_force::T] ==
        Approx(torsion_shear_of_rectangle(mm(100), mm(20))).epsilon(1e-12));
  const auto top = point_of(field, PointSet::in_plane, "fibre +z").influence;
  CHECK(top.shear[cut_force::V_y] == Approx(1.5 / 2e-3).epsilon(1e-12));
  CHECK(std::abs(top.shear[cut_force::V_z]) < 1e-6);
}

TEST_CASE("a web hole in a plate: the net plate's V S/(I b) beside it", "[section]") {
  // 20 x 100, hole of 30 at mid-height: I = 20 (100^3 - 30^3)/12, S above 15 mm 20 35 32.5.
  const Section plate{Plate{mm(20), mm(100)}, {}};
  const StressField field = stress_field_of(plate, {{"hole", mm(30), HoleWalls::webs, mm(0)}}, {});
  const auto beside = points_at_level(field, "beside", mm(15), PointSet::in_plane);
  REQUIRE(beside.size() == 1);
  const double I = 20 * (1e6 - 27e3) / 12;
  CHECK(beside[0].influence.shear[cut_force::V_z] ==
        Approx(20 * 35 * 32.5 / (I * 20) * 1e6).epsilon(1e-9));
  CHECK(points_at_level(field, "in it", mm(5), PointSet::in_plane).empty());
}

TEST_CASE("polygons refuse V_y and T: the stress is not a number where they act", "[section]") {
  const Section triangle{Polygon{{{mm(0), mm(0)}, {mm(100), mm(0)}, {mm(0), mm(80)}}}, {}};
  CHECK(unknown_shear_of(triangle));
  CHECK_FALSE(unknown_shear_of(box));
  const auto middle =
      point_of(stress_field_of(triangle, {}, {}), PointSet::all, "neutral axis").influence;
  CutForces cut;
  cut.V_z = si<Force>(1e3);
  CHECK(std::isfinite(stress_at(middle, cut).shear.value()));
  cut.T = si<Moment>(1.0);
  CHECK(std::isnan(stress_at(middle, cut).shear.value()));
}

TEST_CASE("unsymmetric bending: an angle's stress is in balance with N, M_y, M_z", "[section]") {
  // Sum of sigma dA over thin strips of an L of two rectangles.
  const Section angle{Polygon{{{mm(0), mm(0)},
                               {mm(100), mm(0)},
                               {mm(100), mm(10)},
                               {mm(10), mm(10)},
                               {mm(10), mm(150)},
                               {mm(0), mm(150)}}},
                      {}};
  const AreaSums sums = sums_of(outline_of(angle, {}));
  CutForces cut;
  cut.N = si<Force>(1e4);
  cut.M_y = si<Moment>(2e3);
  cut.M_z = si<Moment>(-7e2);
  double N = 0.0, M_y = 0.0, M_z = 0.0;
  const double h = 5e-4;
  for (double y = 0.5 * h; y < 0.1; y += h) {
    for (double z = 0.5 * h; z < (y < 0.01 ? 0.15 : 0.01); z += h) {
      const double force = stress_at(normal_influence(sums, y, z), cut).normal.value() * h * h;
      N += force;
      M_y += force * z;
      M_z -= force * y;
    }
  }
  CHECK(N == Approx(1e4).epsilon(1e-3));
  CHECK(M_y == Approx(2e3).epsilon(1e-3));
  CHECK(M_z == Approx(-7e2).epsilon(1e-3));
}

namespace {

const WallStretch& stretch_of(const std::vector<WallStretch>& stretches, const std::string& name) {
  for (const WallStretch& stretch : stretches) {
    if (stretch.name == name) return stretch;
  }
  throw std::runtime_error("no stretch " + name);
}

void check_same(const SectionPoint& one, const SectionPoint& other) {
  CHECK(one.y.value() == Approx(other.y.value()).epsilon(1e-12).margin(1e-15));
  CHECK(one.z.value() == Approx(other.z.value()).epsilon(1e-12).margin(1e-15));
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    const double normal = other.influence.normal[k], shear = other.influence.shear[k];
    CHECK(one.influence.normal[k] == Approx(normal).epsilon(1e-9).margin(1e-6));
    CHECK(one.influence.shear[k] == Approx(shear).epsilon(1e-9).margin(1e-6));
  }
}

}  // namespace

TEST_CASE("in space a box has corners, faces and seams, and stretches of wall between them") {
  const auto names = names_of(box, PointSet::in_space);
  const std::set<std::string> all(names.begin(), names.end());
  CHECK(all == std::set<std::string>{"fibre +y", "fibre -y", "fibre +z", "fibre -z", "corner +y +z",
                                     "corner +y -z", "corner -y +z", "corner -y -z",
                                     "web end +y +z", "web end +y -z", "web end -y +z",
                                     "web end -y -z"});
  const StressField field = stress_field_of(box, {}, {});
  const auto stretches = wall_stretches_of(field);
  REQUIRE(stretches.size() == 4);
  // The ends and middles of the stretches are the places of the plane's set.
  const auto at = [&](const std::string& name, double part) {
    return point_on_stretch(field, stretch_of(stretches, name), part);
  };
  check_same(at("left web", 0.5), point_of(field, PointSet::all, "neutral axis +y"));
  check_same(at("right web", 0.5), point_of(field, PointSet::all, "neutral axis -y"));
  check_same(at("top flange", 1.0), point_of(field, PointSet::all, "flange end +y +z"));
  check_same(at("bottom flange", 0.0), point_of(field, PointSet::all, "flange end -y -z"));
  check_same(at("top flange", 0.5), point_of(field, PointSet::in_space, "fibre +z"));
  check_same(at("left web", 1.0), point_of(field, PointSet::in_space, "web end +y +z"));
}

TEST_CASE("stretches leave holes out, and a face in a hole is no place") {
  const Hole port{"port", mm(100), HoleWalls::webs, mm(20)};
  const StressField field = stress_field_of(box, {port}, {});
  const auto stretches = wall_stretches_of(field);
  CHECK(stretches.size() == 6);
  const auto below = point_on_stretch(field, stretch_of(stretches, "left web"), 1.0);
  const auto above = point_on_stretch(field, stretch_of(stretches, "left web 2"), 0.0);
  CHECK(below.z.value() == Approx(-0.03).epsilon(1e-12));
  CHECK(above.z.value() == Approx(0.07).epsilon(1e-12));
  for (const SectionPoint& point : points_of(field, PointSet::in_space)) {
    CHECK(point.name != "fibre +y");
    CHECK(point.name != "fibre -y");
  }
}

TEST_CASE("the stretch of a round tube goes all around, that of a path along both faces") {
  const Section round{RoundTube{mm(140), mm(8)}, {}};
  const StressField field = stress_field_of(round, {}, {});
  CHECK(points_of(field, PointSet::in_space).empty());
  const auto stretches = wall_stretches_of(field);
  REQUIRE(stretches.size() == 1);
  CHECK(stretches[0].round);
  for (const int degrees : {0, 45, 90, 225, 315}) {
    CAPTURE(degrees);
    check_same(point_on_stretch(field, stretches[0], degrees / 360.0),
               point_of(field, PointSet::all, "wall at " + std::to_string(degrees) + " deg"));
  }
  test::RandomSections random(3);
  const StressField path = stress_field_of({random.path(), {}}, {}, {});
  CHECK(points_of(path, PointSet::in_space).empty());
  const auto walls = wall_stretches_of(path);
  CHECK(walls.size() == 2 * path.flow->at.graph.walls.size());
  check_same(point_on_stretch(path, stretch_of(walls, "wall 1 right"), 0.5),
             point_of(path, PointSet::all, "wall 1 middle right"));
  check_same(point_on_stretch(path, stretch_of(walls, "wall 2 left"), 1.0),
             point_of(path, PointSet::all, "wall 2 end left"));
}

TEST_CASE("a level in space is looked at on both sides, where the outer faces are") {
  const StressField field = stress_field_of(box, {}, {});
  const auto web = points_at_level(field, "P", mm(100), PointSet::in_space);
  REQUIRE(web.size() == 2);
  CHECK(web[0].name == "P +y");
  CHECK(web[0].y.value() == Approx(0.2).epsilon(1e-12));
  CHECK(web[1].y.value() == Approx(-0.2).epsilon(1e-12));
  const auto flange = points_at_level(field, "P", mm(290), PointSet::in_space);
  REQUIRE(flange.size() == 3);
  CHECK(flange[0].y.value() == 0.0);
  for (const SectionPoint& point : flange) CHECK(point.z.value() == Approx(0.29).epsilon(1e-12));
  const double I_z = (0.6 * std::pow(0.4, 3) - 0.5 * std::pow(0.3, 3)) / 12;
  CHECK(flange[1].influence.normal[cut_force::M_z] == Approx(-0.2 / I_z).epsilon(1e-12));
  const StressField tube = stress_field_of({RoundTube{mm(100), mm(10)}, {}}, {}, {});
  const auto round = points_at_level(tube, "P", mm(30), PointSet::in_space);
  REQUIRE(round.size() == 2);
  CHECK(round[0].y.value() == Approx(0.04).epsilon(1e-12));
  CHECK(round[1].y.value() == Approx(-0.04).epsilon(1e-12));
  // Every factor of a path is known.
  const ThinWalled channel{{{mm(50), mm(0)}, {mm(0), mm(0)}, {mm(0), mm(100)}, {mm(50), mm(100)}},
                           {{0, 1, mm(5)}, {1, 2, mm(5)}, {2, 3, mm(5)}}};
  const StressField open = stress_field_of({channel, {}}, {}, {});
  const auto crossed = points_at_level(open, "P", mm(40), PointSet::in_space);
  REQUIRE(crossed.size() == 2);
  for (const SectionPoint& point : crossed) {
    for (const double factor : point.influence.shear) CHECK(std::isfinite(factor));
  }
}

TEST_CASE("the rounded corners of a rolled tube are stretches on the rounding") {
  // 200 x 100 x 8, radii 12 and 8: the outermost fibre at 45 degrees lies on the rounding.
  const Section rolled{RectangularTube{mm(200), mm(100), mm(8), mm(12), mm(8)}, {}};
  const StressField field = stress_field_of(rolled, {}, {});
  const auto stretches = wall_stretches_of(field);
  CHECK(stretches.size() == 8);
  const auto corner = point_on_stretch(field, stretch_of(stretches, "corner -y +z"), 0.5);
  const double from_corner = 0.012 * (1.0 - std::sqrt(0.5));
  CHECK(corner.y.value() == Approx(-0.1 + from_corner).epsilon(1e-12));
  CHECK(corner.z.value() == Approx(0.05 - from_corner).epsilon(1e-12));
  // It ends where the flat of the web does, with the same stress; counter-clockwise, so down into
  // this web, whose own shear counts up.
  const auto end = point_on_stretch(field, stretch_of(stretches, "right web"), 1.0);
  const auto last = point_on_stretch(field, stretch_of(stretches, "corner -y +z"), 1.0);
  CHECK(end.y.value() == Approx(last.y.value()).epsilon(1e-12));
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    CHECK(last.influence.shear[k] == Approx(-end.influence.shear[k]).epsilon(1e-9).margin(1e-6));
  }
  for (const SectionPoint& point : points_of(field, PointSet::in_space))
    CHECK_FALSE(point.name.starts_with("corner"));
}

}  // namespace section_points_test
