// Properties of the shear flow that hold for every section: sums over the walls, equilibrium.

#include "boxbeam/section/shear_flow.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"
#include "section/random_sections.hpp"
#include "support/paths.hpp"

namespace shear_flow_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

/// The walls' own second moments across their thickness, int (r - r_mid) (r - r_mid)^T dA, of
/// straight walls: t^3 L/12 times the square of the direction across.
Eigen::Matrix2d own_moments(const WallGraph& graph) {
  Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
  for (const Wall& wall : graph.walls) {
    const Eigen::Vector2d along = direction_on(wall, 0.5);
    const Eigen::Vector2d across(-along.y(), along.x());
    own += across * across.transpose() * (length_of(wall) * std::pow(wall.thickness, 3) / 12.0);
  }
  return own;
}

/// Second moments of y y, y z; z y, z z.
Eigen::Matrix2d moments_of(const SectionProperties& p) {
  Eigen::Matrix2d I;
  I << p.I_z.value(), p.I_yz.value(), p.I_yz.value(), p.I_y.value();
  return I;
}

/// Transverse forces of the flows per V_y and V_z, for any axes (sum I_c - own) I^-1 in (y, z).
///
/// I_c is of each profile about its own centroid, since dM_c/dx = V_c for each as a beam of its
/// own, where what passes between them is spread over its material. What passes between them works
/// at the distance of the centroids, and what ties them together carries the rest of V. One profile
/// alone carries V (1 - I_own/I).
void check_forces(const Section& section) {
  const auto flow = shear_flow_of(section, {}, {});
  REQUIRE(flow);
  Eigen::Matrix2d bent = moments_of(properties_of({section.outer, {}}));
  if (section.inner) bent += moments_of(properties_of({*section.inner, {}}));
  const Eigen::Matrix2d expected =
      (bent - own_moments(flow->at.graph)) * moments_of(properties_of(section)).inverse();
  const auto sums = resultants_of(*flow);
  const Eigen::Index columns[] = {cut_force::V_y, cut_force::V_z};
  for (Eigen::Index row = 0; row < 2; ++row) {
    for (Eigen::Index k = 0; k < 2; ++k) {
      CHECK(sums(row, columns[k]) == Approx(expected(row, k)).epsilon(1e-9).margin(1e-9));
    }
    // Torque and normal force pull nothing across.
    CHECK(std::abs(sums(row, cut_force::T)) < 1e-9);
    CHECK(std::abs(sums(row, cut_force::N)) < 1e-9);
  }
  // About the beam axis only T turns, where the rest of V passes through the walls' middles.
  CHECK(sums(2, cut_force::T) == Approx(1.0).epsilon(1e-9));
  if (section.inner) return;  // what ties two profiles is no wall's
  const StressedWalls& walls = flow->at;
  for (const Eigen::Index k : columns) {
    // V_z = dM_y/ds and V_y = -dM_z/ds: the stress grows by the plane of that moment.
    const Eigen::Vector2d gradient = k == cut_force::V_z
                                         ? walls.plane.bottomRows<2>().col(1).eval()
                                         : (-walls.plane.bottomRows<2>().col(2)).eval();
    Eigen::Vector3d whole = sums.col(k);
    for (const Wall& wall : walls.graph.walls) {
      const Eigen::Vector2d along = direction_on(wall, 0.5), middle = point_on(wall, 0.5);
      const Eigen::Vector2d across(-along.y(), along.x());
      const Eigen::Vector2d force =
          across * across.dot(gradient) * (length_of(wall) * std::pow(wall.thickness, 3) / 12.0);
      whole +=
          Eigen::Vector3d(force.x(), force.y(), middle.x() * force.y() - middle.y() * force.x());
    }
    CHECK(whole[0] == Approx(k == cut_force::V_y ? 1.0 : 0.0).epsilon(1e-9).margin(1e-9));
    CHECK(whole[1] == Approx(k == cut_force::V_z ? 1.0 : 0.0).epsilon(1e-9).margin(1e-9));
    CHECK(std::abs(whole[2]) < 1e-9);
  }
}

/// What flows into a node along its walls flows out of it again.
void check_nodes(const Section& section) {
  const ShearFlow flow = *shear_flow_of(section, {}, {});
  const WallGraph& graph = flow.at.graph;
  std::vector<CutFactors> into(graph.nodes.size(), CutFactors::Zero());
  double largest = 0.0;
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    into[graph.walls[i].from] -= flow_at(flow, i, 0.0);
    into[graph.walls[i].to] += flow_at(flow, i, 1.0);
    largest = std::max(largest, std::abs(flow_at(flow, i, 0.5)[cut_force::V_z]));
  }
  for (std::size_t i = 0; i < into.size(); ++i) {
    CAPTURE(i);
    CHECK(std::abs(into[i][cut_force::V_y]) < 1e-9 * largest);
    CHECK(std::abs(into[i][cut_force::V_z]) < 1e-9 * largest);
  }
}

}  // namespace

TEST_CASE("wall flows sum to V less the walls' own bending, and to T: random boxes", "[section]") {
  test::RandomSections random(20240501);
  for (int i = 0; i < 60; ++i) {
    const Section section{random.box(), {}};
    if (defect_of(section)) continue;
    CAPTURE(i);
    check_forces(section);
    check_nodes(section);
  }
}

TEST_CASE("the same for branched paths of two cells", "[section]") {
  test::RandomSections random(7);
  for (int i = 0; i < 60; ++i) {
    const Section section{random.path(), {}};
    REQUIRE_FALSE(defect_of(section));
    CAPTURE(i);
    check_forces(section);
    check_nodes(section);
  }
}

TEST_CASE("the same for nested boxes that do not share a centroid", "[section]") {
  test::RandomSections random(11);
  for (int i = 0; i < 20; ++i) {
    Box outer = random.box();
    outer.stiffeners.clear();
    const Box inner = symmetric_box(0.3 * outer.width, 0.4 * outer.height,
                                    random.length(0.004, 0.01), random.length(0.004, 0.01));
    const Section section{outer, inner};
    REQUIRE_FALSE(defect_of(section));
    CAPTURE(i);
    check_forces(section);
    check_nodes(section);
  }
}

TEST_CASE("an open path carries T in its walls alone, each by its s t^3/3", "[section]") {
  test::RandomSections random(13);
  for (int i = 0; i < 20; ++i) {
    ThinWalled path = random.path();
    // Without the middle wall and one side no cell is left.
    std::erase_if(path.walls, [](const ThinWall& wall) {
      return (wall.from == 5 && wall.to == 4) || (wall.from == 3 && wall.to == 0);
    });
    const Section open{path, {}};
    REQUIRE_FALSE(defect_of(open));
    const ShearFlow flow = *shear_flow_of(open, {}, {});
    REQUIRE(flow.at.cells.cells.empty());
    CAPTURE(i);
    check_forces(open);
    check_nodes(open);
    // tau = T t/I_T on the faces, I_T = sum s t^3/3 (Saint-Venant).
    double I_T = 0.0;
    for (const ThinWall& wall : path.walls) {
      const SectionPlace a = path.nodes[wall.from], b = path.nodes[wall.to];
      I_T += hypot(b.y - a.y, b.z - a.z).value() * std::pow(wall.thickness.value(), 3) / 3.0;
    }
    for (std::size_t k = 0; k < flow.at.graph.walls.size(); ++k) {
      const WallTorsion torsion = wall_torsion_of(flow, k, 1.0);
      CHECK(torsion.I_w == Approx(I_T).epsilon(1e-12));
      CHECK(torsion.face == Approx(torsion.thickness / I_T).epsilon(1e-12));
    }
  }
}

TEST_CASE("no cell twists under transverse forces through the shear centre", "[section]") {
  test::RandomSections random(3);
  for (int i = 0; i < 30; ++i) {
    const Section section{random.path(), {}};
    const ShearFlow flow = *shear_flow_of(section, {}, {});
    // A torque of y_s V_z - z_s V_y about the beam axis brings V into the shear centre.
    const SectionPlace centre = *shear_centre_of(section);
    for (const Cell& cell : flow.at.cells.cells) {
      double around = 0.0, size = 0.0;
      for (const Cell::Side& side : cell.sides) {
        const Wall& wall = flow.at.graph.walls[side.wall];
        // Simpson's rule: the flow of V is a parabola along a straight wall.
        const auto q = [&](double f) {
          const CutFactors at = flow_at(flow, side.wall, f);
          return at[cut_force::V_z] + centre.y.value() * at[cut_force::T];
        };
        const double mean = (q(0.0) + 4.0 * q(0.5) + q(1.0)) / 6.0;
        around += side.sign * mean * slenderness_of(flow.at.graph, wall);
        size += std::abs(mean) * slenderness_of(flow.at.graph, wall);
      }
      CAPTURE(i);
      CHECK(std::abs(around) < 1e-9 * size);
    }
  }
}

TEST_CASE("shear centre of a channel: e = 3 b^2/(6 b + h) from the web, thin walls", "[section]") {
  // Mid-lines b 100 mm, h 200 mm, t 2 mm; Timoshenko, Strength of Materials.
  const double b = 100, h = 200;
  const auto at = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  const ThinWalled channel{{at(b, h / 2), at(0, h / 2), at(0, -h / 2), at(b, -h / 2)},
                           {{0, 1, mm(2), {}, {}}, {1, 2, mm(2), {}, {}}, {2, 3, mm(2), {}, {}}}};
  const SectionPlace centre = *shear_centre_of({channel, {}});
  CHECK(centre.y.value() * 1e3 == Approx(-3 * b * b / (6 * b + h)).epsilon(2e-4));
  CHECK(std::abs(centre.z.value()) < 1e-12);
}

TEST_CASE("the shear centre moves with its section, however its walls are cut", "[section]") {
  test::RandomSections random(29);
  const auto centre = [](const ThinWalled& path) {
    const auto at = shear_centre_of({path, {}});
    REQUIRE(at);
    return Eigen::Vector2d(at->y.value(), at->z.value());
  };
  double largest = 0.0;
  for (int i = 0; i < 40; ++i) {
    ThinWalled path = random.path();
    if (i % 2 == 0) {  // without cells
      path.walls.erase(path.walls.begin());
      path.walls.pop_back();
    }
    if (defect_of({path, {}})) continue;
    CAPTURE(i);
    const Eigen::Vector2d here = centre(path);
    ThinWalled moved = path;
    for (SectionPlace& node : moved.nodes) {
      node.y += mm(730.0);
      node.z -= mm(410.0);
    }
    // By more than the size of the section.
    CHECK((centre(moved) - here - Eigen::Vector2d(0.73, -0.41)).norm() < 1e-9);
    ThinWalled cut = path;
    for (std::size_t wall = 0; wall < path.walls.size(); ++wall)
      cut = paths::split(cut, wall, 0.15 + 0.1 * static_cast<double>(wall % 7));
    CHECK((centre(cut) - here).norm() < 1e-9);
    largest = std::max(largest, here.norm());
  }
  CHECK(largest > 0.01);
}

TEST_CASE("the shear centre of any box or tube is where its flows have no torque", "[section]") {
  Box unlike = symmetric_box(mm(400), mm(1000), mm(50), mm(30));
  unlike.left_web = mm(20);
  Box uneven = symmetric_box(mm(400), mm(1000), mm(50), mm(30));
  uneven.top_flange = mm(20);
  Box stiffened = symmetric_box(mm(400), mm(1000), mm(12), mm(10));
  stiffened.stiffeners = {{BoxPlate::left_web, mm(200), mm(80), mm(8)}};
  const Box even = symmetric_box(mm(400), mm(1000), mm(12), mm(10));
  const RectangularTube tube{mm(290), mm(490), mm(12), mm(18), mm(6)};
  for (const Section& section :
       {Section{even, {}}, Section{unlike, {}}, Section{uneven, {}}, Section{stiffened, {}},
        Section{tube, {}}, Section{RoundTube{mm(200), mm(8)}, {}}, Section{even, tube},
        Section{unlike, tube}, Section{tube, unlike}}) {
    const SectionPlace centre = *shear_centre_of(section);
    const ShearFlow flow = *shear_flow_of(section, {}, {});
    CHECK(std::abs(centre.y.value() + flow.torque[cut_force::V_z]) < 1e-12);
    CHECK(std::abs(centre.z.value() - flow.torque[cut_force::V_y]) < 1e-12);
  }
  CHECK(std::abs(shear_centre_of({unlike, {}})->y.value()) > 1e-3);
  CHECK(std::abs(shear_centre_of({uneven, {}})->z.value()) > 1e-3);
}

TEST_CASE("shear flow in a box web by hand: half of V S/I at the seam and at the neutral axis",
          "[section]") {
  // 400 x 1000 x 50: I = 400 1000^3/12 - 300 900^3/12 mm^4; S of the flange 400*50*475, of half a
  // section besides 2*50*450*225.
  const Section box{symmetric_box(mm(400), mm(1000), mm(50), mm(50)), {}};
  const ShearFlow flow = *shear_flow_of(box, {}, {});
  const double I = (400e9 - 300.0 * 900 * 900 * 900) / 12;
  for (std::size_t i = 0; i < flow.at.graph.walls.size(); ++i) {
    const WallPart part = flow.at.graph.walls[i].part;
    if (part != WallPart::left_web && part != WallPart::right_web) continue;
    CHECK(flow_at(flow, i, 1.0)[cut_force::V_z] * 1e-3 ==
          Approx(400 * 50 * 475.0 / I / 2).epsilon(1e-12));
    CHECK(flow_at(flow, i, 0.5)[cut_force::V_z] * 1e-3 ==
          Approx((400 * 50 * 475.0 + 100 * 450 * 225.0) / I / 2).epsilon(1e-12));
  }
}

TEST_CASE("round tube: V_z runs 2 V/A at the neutral axis of a thin one, Bredt T/(2 A_m t)",
          "[section]") {
  const double R = 0.1, t = 0.001;  // mid-line radius
  const Section tube{RoundTube{si<Length>(2 * R + t), si<Length>(t)}, {}};
  const ShearFlow flow = *shear_flow_of(tube, {}, {});
  const double A = 2 * std::numbers::pi * R * t;
  CHECK(flow_at(flow, 0, 0.0)[cut_force::V_z] / t == Approx(2 / A).epsilon(1e-4));
  CHECK(std::abs(flow_at(flow, 2, 0.0)[cut_force::V_z]) < 1e-9);
  CHECK(flow_at(flow, 3, 0.3)[cut_force::T] ==
        Approx(1 / (2 * std::numbers::pi * R * R)).epsilon(1e-4));
  const auto sums = resultants_of(flow);
  CHECK(sums(1, cut_force::V_z) == Approx(1.0).epsilon(1e-4));
  CHECK(sums(0, cut_force::V_y) == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("rolled tubes: the flow at the flats is V S/(2 I) with the exact corner", "[section]") {
  test::RandomSections random(5);
  for (int i = 0; i < 20; ++i) {
    const RectangularTube rolled = random.rolled();
    const Section section{rolled, {}};
    const ShearFlow flow = *shear_flow_of(section, {}, {});
    const SectionProperties p = properties_of(section);
    const double z = (0.5 * rolled.height - 2.0 * rolled.wall).value();  // where the web is flat
    const double S = first_moment_beyond(section, {}, si<Length>(z), Length{}).value();
    for (std::size_t k = 0; k < flow.at.graph.walls.size(); ++k) {
      if (flow.at.graph.walls[k].part != WallPart::left_web) continue;
      CHECK(flow_at(flow, k, 1.0)[cut_force::V_z] == Approx(0.5 * S / p.I_y.value()).epsilon(1e-9));
    }
  }
}

}  // namespace shear_flow_test
