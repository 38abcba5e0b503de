// Shear in tapers: balance of pieces between two neighbouring sections.

#include "boxbeam/section/taper.hpp"

#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"
#include "section/random_sections.hpp"

namespace taper_test {

using namespace boxbeam;

namespace {

struct TaperedPiece {
  Section from, to;
  double length;

  Section at(double x) const { return interpolate(from, to, x / length); }
  Taper taper_at(double x) const {
    const double step = 1e-5 * length;
    return {{at(x - step), -0.5 / step}, {at(x + step), 0.5 / step}};
  }
};

/// Force in the top flange and the webs above a fraction of their clear height, by summing sigma
/// over a grid of the section: owes nothing to walls and trees.
double force_above(const Section& section, double part, const CutForces& cut) {
  const auto& box = std::get<Box>(section.outer);
  const double low = clear_bottom_of(box).value(), high = clear_top_of(box).value();
  const double top = 0.5 * box.height.value(), left = 0.5 * box.width.value();
  const double level = low + part * (high - low);
  const AreaSums sums = sums_of(outline_of(section, {}));
  const auto over = [&](double y_low, double y_high, double z_low, double z_high) {
    // The stress is a plane: its mean over a rectangle is that of the middle.
    const double middle =
        stress_at(normal_influence(sums, 0.5 * (y_low + y_high), 0.5 * (z_low + z_high)), cut)
            .normal.value();
    return middle * (y_high - y_low) * (z_high - z_low);
  };
  return over(-left, left, high, top) + over(left - box.left_web.value(), left, level, high) +
         over(-left, -left + box.right_web.value(), level, high);
}

/// int sigma (r - r_mid) dA of each wall, which is straight.
std::vector<Eigen::Vector2d> own_bending(const Section& section, const CutForces& cut) {
  const StressedWalls walls = shear_flow_of(section, {}, {})->at;
  const Eigen::Vector3d plane =
      walls.plane * Eigen::Vector3d(cut.N.value(), cut.M_y.value(), cut.M_z.value());
  std::vector<Eigen::Vector2d> bending;
  for (const Wall& wall : walls.graph.walls) {
    const Eigen::Vector2d along = direction_on(wall, 0.5), across(-along.y(), along.x());
    bending.push_back(across * across.dot(plane.tail<2>()) *
                      (length_of(wall) * std::pow(wall.thickness, 3) / 12.0));
  }
  return bending;
}

}  // namespace

TEST_CASE("tapered boxes: both webs together carry the growth of the force above them",
          "[section]") {
  test::RandomSections random(99);
  for (int i = 0; i < 40; ++i) {
    Box from = random.box(), to = random.box();
    from.stiffeners.clear();
    to.stiffeners.clear();
    const TaperedPiece piece{{from, {}}, {to, {}}, random.number(1.0, 4.0)};
    const double x = random.number(0.2, 0.8) * piece.length;
    const double N = random.number(-1e5, 1e5), V = random.number(-1e5, 1e5);
    const double M = random.number(-1e5, 1e5), M_z = random.number(-1e5, 1e5);
    const double V_y = random.number(-1e5, 1e5);
    const auto cut_at = [&](double s) {
      CutForces cut;
      cut.N = si<Force>(N);
      cut.V_z = si<Force>(V);
      cut.V_y = si<Force>(V_y);
      cut.M_y = si<Moment>(M + V * (s - x));      // M_y' = V_z
      cut.M_z = si<Moment>(M_z - V_y * (s - x));  // M_z' = -V_y
      return cut;
    };
    const ShearFlow flow = *shear_flow_of(piece.at(x), {}, piece.taper_at(x));
    Eigen::Matrix<double, 6, 1> c;
    c << N, V_y, V, 0.0, M, M_z;
    for (const double part : {0.0, 0.3, 0.7, 1.0}) {
      const double h = 1e-4 * piece.length;
      const double expected = (force_above(piece.at(x + h), part, cut_at(x + h)) -
                               force_above(piece.at(x - h), part, cut_at(x - h))) /
                              (2 * h);
      double webs = 0.0;
      for (std::size_t k = 0; k < flow.at.graph.walls.size(); ++k) {
        const WallPart of = flow.at.graph.walls[k].part;
        if (of == WallPart::left_web || of == WallPart::right_web) {
          webs += flow_at(flow, k, part).dot(c);
        }
      }
      CAPTURE(i, part);
      CHECK(webs == Approx(expected).epsilon(1e-5).margin(1.0));
    }
    // Flows and inclined normal forces balance V and T, with what walls carry across their
    // thickness: the growth of their own bending, in their middles.
    const double h = 1e-4 * piece.length;
    Eigen::Vector3d balance = resultants_of(flow) * c;
    const auto after = own_bending(piece.at(x + h), cut_at(x + h)),
               before = own_bending(piece.at(x - h), cut_at(x - h));
    for (std::size_t k = 0; k < flow.at.graph.walls.size(); ++k) {
      const Eigen::Vector2d force = (after[k] - before[k]) / (2.0 * h);
      const Eigen::Vector2d middle = point_on(flow.at.graph.walls[k], 0.5);
      balance +=
          Eigen::Vector3d(force.x(), force.y(), middle.x() * force.y() - middle.y() * force.x());
    }
    const double size = std::abs(V) + std::abs(V_y) + (std::abs(M) + std::abs(M_z)) / piece.length +
                        std::abs(N) / piece.length;
    CHECK(std::abs(balance[0] - V_y) < 1e-6 * size);
    CHECK(std::abs(balance[1] - V) < 1e-6 * size);
    CHECK(std::abs(balance[2]) < 2e-6 * size);
  }
}

TEST_CASE("a prismatic piece has the same shear with and without its taper", "[section]") {
  test::RandomSections random(4);
  const Section section{random.box(), {}};
  const TaperedPiece piece{section, section, 2.0};
  const StressField plain = stress_field_of(section, {}, {});
  const StressField tapered = stress_field_of(section, {}, piece.taper_at(1.0));
  const auto points = points_of(plain, PointSet::all);
  const auto same = points_of(tapered, PointSet::all);
  REQUIRE(points.size() == same.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(same[i].influence.shear[k] ==
            Approx(points[i].influence.shear[k]).epsilon(1e-6).margin(1e-6));
      CHECK(same[i].prismatic.shear[k] == points[i].influence.shear[k]);
    }
  }
}

TEST_CASE("stresses are the same without the flow that is shown for comparison", "[section]") {
  test::RandomSections random(7);
  for (int run = 0; run < 20; ++run) {
    const Box from = random.box();
    Box to = from;
    to.height *= 1.4;
    to.width *= 1.2;
    const TaperedPiece piece{{from, {}}, {to, {}}, 2.0};
    const Section section = interpolate(piece.from, piece.to, 0.5);
    const Taper taper = piece.taper_at(1.0);
    const StressField all = stress_field_of(section, {}, taper);
    const StressField judged = stress_field_of(section, {}, taper, Prismatic::left_out);
    const auto points = points_of(all, PointSet::all);
    const auto same = points_of(judged, PointSet::all);
    REQUIRE(points.size() == same.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(same[i].influence.normal == points[i].influence.normal);
      CHECK(same[i].influence.shear == points[i].influence.shear);
    }
  }
}

}  // namespace taper_test
