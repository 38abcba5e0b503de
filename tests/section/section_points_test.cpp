// Stress at named places: hand formulas, one sign of each cut force.

#include "boxbeam/section/section_points.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"
#include "section/random_sections.hpp"

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

TEST_CASE("seam of a box: q/a on the throat, q/t_w at full penetration", "[section]") {
  Box welded = symmetric_box(mm(400), mm(600), mm(50), mm(50));
  const double q = 0.5 * 400 * 50 * 275e-9 / 4.075e-3;  // V S/(2 I) by hand
  const auto seam = [](const Box& of) {
    return point_of(stress_field_of({of, {}}, {}, {}), PointSet::in_plane, "web end +z");
  };
  REQUIRE(seam(welded).on_throat);
  CHECK(seam(welded).on_throat->shear[cut_force::V_z] == Approx(q / 0.05).epsilon(1e-12));
  welded.seam_throat = mm(8);
  CHECK(seam(welded).on_throat->shear[cut_force::V_z] == Approx(q / 0.008).epsilon(1e-12));
  CHECK(seam(welded).influence.shear[cut_force::V_z] == Approx(q / 0.05).epsilon(1e-12));
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
