// Plates that buckle below yield: hand values, the load factor that a step-by-step calculation at
// each level of load has, and what must hold for every box.

#include <algorithm>
#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/effective_path.hpp"
#include "catch.hpp"
#include "support/paths.hpp"
#include "support/uniform.hpp"

namespace below_yield_test {

using namespace boxbeam;
using enum BoxPlate;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

CutForces forces(double N, double M_y, double M_z) {
  CutForces cut;
  cut.N = si<Force>(N);
  cut.M_y = si<Moment>(M_y);
  cut.M_z = si<Moment>(M_z);
  return cut;
}

CutForces times(double factor, const CutForces& cut) {
  return forces(factor * cut.N.value(), factor * cut.M_y.value(), factor * cut.M_z.value());
}

FourWalls walls_of(double width, double height, double top, double bottom, double left,
                   double right) {
  Box box = symmetric_box(mm(width), mm(height), mm(top), mm(left));
  box.bottom_flange = mm(bottom);
  box.right_web = mm(right);
  Material steel;
  steel.name = "S355";
  steel.steps = {{mm(40.0), si<Stress>(355e6), si<Stress>(470e6)}};
  return *four_walls_of(box, steel);
}

FourWalls random_walls(test::Uniform& in) {
  return walls_of(in(300.0, 900.0), in(400.0, 1300.0), in(5.0, 14.0), in(5.0, 14.0), in(4.0, 10.0),
                  in(4.0, 10.0));
}

CutForces random_forces(test::Uniform& between) {
  const auto in = [&](double most) { return between(-most, most); };
  return forces(in(2e6), in(1.5e6), in(0.8e6));
}

/// The use under forces as large as they are, each plate's widths by its largest compression over
/// f_y there, step by step: sections and stresses of `EffectiveBox`, the levels found here.
double use_at_level(const FourWalls& walls, const CutForces& cut, bool annex_E) {
  FourWalls at = walls;
  double use = 0.0;
  for (int i = 0; i < 200; ++i) {
    const EffectiveBox box(at);
    use = box.use(cut);
    // Corners one by one, by boxes of which only one corner counts.
    for (const BoxPlate plate : box_plates) {
      double most = 0.0;
      for (const double y : {-1.0, 1.0}) {
        for (const double z : {-1.0, 1.0}) {
          const BoxPlate flange = z > 0.0 ? top_flange : bottom_flange;
          const BoxPlate web = y > 0.0 ? left_web : right_web;
          if (plate != flange && plate != web) continue;
          const double y_m = walls.of(web).middle.value(), z_m = walls.of(flange).middle.value();
          const auto modulus = [&](ActingAlone acting, bool about_y) {
            const AreaSums& s = box.alone(acting).sums;
            const double yc = s.y / s.area, zc = s.z / s.area;
            const double Iy = s.zz - s.area * zc * zc, Iz = s.yy - s.area * yc * yc;
            const double Iyz = s.yz - s.area * yc * zc, D = Iy * Iz - Iyz * Iyz;
            const double itself = about_y ? (z_m - zc) / Iy : -(y_m - yc) / Iz;
            const double coupled = about_y ? ((z_m - zc) * Iz - (y_m - yc) * Iyz) / D
                                           : -((y_m - yc) * Iy - (z_m - zc) * Iyz) / D;
            return std::abs(coupled) > std::abs(itself) ? coupled : itself;
          };
          const double N = cut.N.value();
          const AreaSums& gross = walls.gross;
          for (int k = 0; k < 8; ++k) {
            if (k > 0 && !(N < 0.0)) continue;
            const double e_y = gross.y / gross.area + (k & 1 ? box.shift_y().value() : 0.0);
            const double e_z = gross.z / gross.area + (k & 2 ? box.shift_z().value() : 0.0);
            const double A =
                N < 0.0 && !(k & 4) ? box.alone(ActingAlone::compression).sums.area : gross.area;
            const double M_y = cut.M_y.value() - N * e_z, M_z = cut.M_z.value() + N * e_y;
            using enum ActingAlone;
            const double sigma = N / A +
                                 M_y * modulus(M_y < 0.0 ? M_y_negative : M_y_positive, true) +
                                 M_z * modulus(M_z < 0.0 ? M_z_negative : M_z_positive, false);
            most = std::max(most, -sigma);
          }
        }
      }
      BoxWall& wall = at.of(plate);
      wall.level = {std::min(1.0, most / wall.class_strength.value()), annex_E};
    }
  }
  return use;
}

}  // namespace

// b/t = 59.2, S355: lambda_p = 1.281; at 0.6 f_y lambda_red = 0.992: (0.992 - 0.22)/0.992^2 =
// 0.784; (1 - 0.22/0.992)/0.992 + 0.18 (1.281 - 0.992)/(1.281 - 0.6) = 0.784 + 0.076 = 0.861.
TEST_CASE("a flange at 0.6 f_y by hand", "[below_yield]") {
  const auto rho = [](const StressLevel& level) {
    return panel_effective_width(mm(592.0), mm(10.0), 1.0, si<Stress>(355e6), {}, level)->rho;
  };
  CHECK(rho({}) == Approx(0.6466).margin(1e-4));
  CHECK(rho({0.6, false}) == Approx(0.784).margin(5e-4));
  CHECK(rho({0.6, true}) == Approx(0.861).margin(5e-4));
  CHECK(rho({1.0, true}) == Approx(rho({})));
  CHECK(rho({0.0, true}) == 1.0);
  // Widths follow.
  const auto of =
      panel_effective_width(mm(592.0), mm(10.0), 1.0, si<Stress>(355e6), {}, {0.6, true});
  CHECK(of->b_eff.value() == Approx(of->rho * 0.592));
  CHECK((of->b_e1 + of->b_e2).value() == Approx(of->b_eff.value()));
  // A short plate buckles as a column, at yield.
  const auto shorter = [](const StressLevel& level) {
    return panel_effective_width(mm(592.0), mm(10.0), 1.0, si<Stress>(355e6), mm(300.0), level)
        ->rho;
  };
  CHECK(shorter({0.6, true}) == shorter({}));
}

TEST_CASE("rho grows as the stress falls, by annex E no less than by 4.4(4)", "[below_yield]") {
  for (const double psi : {1.0, 0.5, 0.0, -0.7, -1.0, -3.0}) {
    for (const double lambda : {0.7, 1.0, 1.5, 2.5, 4.0}) {
      double before = 0.0;
      for (double share = 1.0; share > 0.0; share -= 0.01) {
        CAPTURE(psi, lambda, share);
        const double rho = internal_reduction(lambda, psi, {share, false});
        const double by_E = internal_reduction(lambda, psi, {share, true});
        CHECK(rho >= before - 1e-12);
        CHECK(by_E >= rho - 1e-12);
        CHECK(by_E <= 1.0);
        before = rho;
      }
    }
  }
}

TEST_CASE("the factor at which plates below yield end is that of every level of load",
          "[below_yield]") {
  test::Uniform in(41);
  int settled = 0, milder = 0;
  for (int i = 0; i < 40; ++i) {
    const FourWalls walls = random_walls(in);
    const CutForces cut = random_forces(in);
    const EffectiveBox at_yield(walls);
    const bool annex_E = i % 2 == 0;
    const auto below = at_yield.below_yield(cut, annex_E);
    if (!below) continue;
    ++settled;
    const double use = below->use(cut);
    CAPTURE(i, use, at_yield.use(cut));
    // Where all forces are 1/use of these, the worst corner yields.
    CHECK(use_at_level(walls, times(1.0 / use, cut), annex_E) == Approx(1.0).epsilon(1e-6));
    // Below that load less is used, above it more.
    CHECK(use_at_level(walls, times(0.9 / use, cut), annex_E) < 1.0);
    CHECK(use_at_level(walls, times(1.1 / use, cut), annex_E) > 1.0);
    CHECK(at_yield.below_yield(times(3.0, cut), annex_E)->use(times(3.0, cut)) ==
          Approx(3.0 * use).epsilon(1e-7));
    if (use < 0.99 * at_yield.use(cut)) ++milder;
  }
  CHECK(settled > 35);
  CHECK(milder > 3);
}

TEST_CASE("where every plate yields nothing is gained", "[below_yield]") {
  // Even compression of four plates alike.
  const FourWalls walls = walls_of(800.0, 800.0, 8.0, 8.0, 8.0, 8.0);
  const EffectiveBox box(walls);
  const CutForces cut = forces(-1e6, 0.0, 0.0);
  for (const bool annex_E : {false, true}) {
    const auto below = box.below_yield(cut, annex_E);
    REQUIRE(below);
    CHECK(below->use(cut) == Approx(box.use(cut)).epsilon(1e-9));
  }
}

TEST_CASE("a compressed flange that is not stressed as the stretched one works more",
          "[below_yield]") {
  // A wide thick top flange over a narrow thin bottom one: sagging, the bottom yields first.
  const FourWalls walls = walls_of(700.0, 800.0, 12.0, 5.0, 8.0, 8.0);
  const EffectiveBox box(walls);
  const CutForces sagging = forces(0.0, -1e6, 0.0);
  REQUIRE(box.worst_corner(sagging).corner.flange == bottom_flange);
  const auto reduced = box.below_yield(sagging, false), by_E = box.below_yield(sagging, true);
  REQUIRE(reduced);
  REQUIRE(by_E);
  CHECK(reduced->use(sagging) < box.use(sagging));
  CHECK(by_E->use(sagging) <= reduced->use(sagging));
}

// c/t = 197/12, S355, k = 0.43: lambda_p = 16.417/(28.4 x 0.8136 x 0.6557) = 1.0835; at 0.5 f_y
// lambda_red = 0.7661: (0.7661 - 0.188)/0.7661^2 = 0.9850; by annex E 0.9850 + 0.18 (1.0835 -
// 0.7661)/(1.0835 - 0.6) = 1.10: 1. At 0.7 f_y 0.9065: 0.8743, by annex E 0.8743 + 0.18 x
// 0.1770/0.4835 = 0.9402.
TEST_CASE("an outstand below yield by hand", "[below_yield]") {
  const auto rho = [](const StressLevel& level) {
    return outstand_effective_width(mm(197.0), mm(12.0), 1.0, LargestCompression::at_tip,
                                    std::sqrt(235.0 / 355.0), level)
        ->rho;
  };
  CHECK(rho({}) == Approx(0.7628).margin(5e-4));
  CHECK(rho({0.5, false}) == Approx(0.9850).margin(5e-4));
  CHECK(rho({0.5, true}) == 1.0);
  CHECK(rho({0.7, false}) == Approx(0.8743).margin(5e-4));
  CHECK(rho({0.7, true}) == Approx(0.9402).margin(5e-4));
  for (const double lambda : {0.8, 1.2, 2.0, 4.0}) {
    double before = 0.0;
    for (double share = 1.0; share > 0.0; share -= 0.01) {
      CAPTURE(lambda, share);
      const double by_level = outstand_reduction(lambda, {share, false});
      const double by_E = outstand_reduction(lambda, {share, true});
      CHECK(by_level >= before - 1e-12);
      CHECK(by_E >= by_level - 1e-12);
      CHECK(by_E <= 1.0);
      before = by_level;
    }
    CHECK(outstand_reduction(lambda, {1.0, true}) == Approx(outstand_reduction(lambda)));
  }
}

namespace {

Material s355() {
  Material steel;
  steel.steps = {{mm(60.0), si<Stress>(355e6), si<Stress>(470e6)}};
  return steel;
}

/// As of boxes, of paths whose y and z are principal axes: the levels found here, of each plate by
/// the stress at both ends of all of it, node to node.
double use_at_level(const PathSection& path, const CutForces& cut, bool annex_E) {
  PathSection at = path;
  // From hardly any stress on, as where the forces grow.
  for (PathPlate& plate : at.plates) plate.level = {1e-3, annex_E};
  double use = 0.0;
  for (int i = 0; i < 200; ++i) {
    const EffectivePath of(at);
    use = of.use(cut);
    for (PathPlate& plate : at.plates) {
      double most = 0.0;
      double last = 0.0;
      for (const PathPlate::Part& part : plate.parts) last = std::max({last, part.from, part.to});
      for (const double along : {0.0, last}) {
        // A free end is where the wall's material ends, which is its node here.
        const Eigen::Vector2d place = plate.at(along);
        const double y = place.x(), z = place.y(), N = cut.N.value();
        const auto modulus = [&](ActingAlone acting) {
          return most_per_moment(of.alone(acting).sums, acting, y, z);
        };
        const EffectiveCentroid& c = of.centroid();
        for (int k = 0; k < 8; ++k) {
          if (k > 0 && !(N < 0.0)) continue;
          const double e_y = (c.y + ((k & 1) != 0 ? c.shift_y : Length{})).value();
          const double e_z = (c.z + ((k & 2) != 0 ? c.shift_z : Length{})).value();
          const double A = N < 0.0 && (k & 4) == 0 ? of.alone(ActingAlone::compression).sums.area
                                                   : path.gross.area;
          const double M_y = cut.M_y.value() - N * e_z, M_z = cut.M_z.value() + N * e_y;
          using enum ActingAlone;
          most = std::max(most, -(N / A + M_y * modulus(M_y < 0.0 ? M_y_negative : M_y_positive) +
                                  M_z * modulus(M_z < 0.0 ? M_z_negative : M_z_positive)));
        }
      }
      plate.level = {std::min(1.0, most / plate.class_strength.value()), annex_E};
    }
  }
  return use;
}

PathSection random_path(test::Uniform& in, int kind) {
  const double width = in(200.0, 500.0), depth = in(500.0, 1300.0), web = in(4.0, 9.0);
  const ThinWalled path =
      kind == 0   ? paths::i_section(width, in(6.0, 14.0), depth, web)
      : kind == 1 ? paths::i_section(width, in(6.0, 14.0), depth, web, in(6.0, 14.0), 0.6 * width)
                  : paths::channel(depth, 0.5 * width, web, in(6.0, 12.0));
  return *path_section_of(path, s355());
}

}  // namespace

TEST_CASE("the factor at which plates of paths below yield end is that of every level of load",
          "[below_yield]") {
  test::Uniform in(43);
  int found = 0, milder = 0, just_then = 0;
  for (int i = 0; i < 36; ++i) {
    const PathSection path = random_path(in, i % 3);
    CutForces cut = random_forces(in);
    if (i % 4 == 0) cut.M_z = {};
    const EffectivePath at_yield(path);
    const bool annex_E = i % 2 == 0;
    const auto below = at_yield.below_yield(cut, annex_E);
    if (!below) continue;
    ++found;
    const double use = below->use(cut);
    CAPTURE(i, use, at_yield.use(cut));
    // Where all forces are 1/use of these, the worst place yields; as they grow never earlier, and
    // mostly just then (several states may be in balance).
    const double there = use_at_level(path, times(1.0 / use, cut), annex_E);
    CHECK(there <= 1.0 + 1e-6);
    if (there > 1.0 - 1e-6) ++just_then;
    CHECK(use_at_level(path, times(0.9 / use, cut), annex_E) < 1.0);
    CHECK(at_yield.below_yield(times(3.0, cut), annex_E)->use(times(3.0, cut)) ==
          Approx(3.0 * use).epsilon(1e-7));
    if (use < 0.99 * at_yield.use(cut)) ++milder;
  }
  CHECK(found > 30);
  CHECK(3 * just_then > 2 * found);
  CHECK(milder > 5);
}

TEST_CASE("a box below yield is used alike as a path", "[below_yield]") {
  // Bottom flange thinner, M_y alone: the top works by less than its yield strength.
  const FourWalls walls = walls_of(700.0, 800.0, 12.0, 5.0, 12.0, 12.0);
  const PathSection path = *path_section_of(paths::box_path(700.0, 800.0, 12.0, 12.0, 5.0), s355());
  const CutForces sagging = forces(0.0, -1e6, 0.0);
  for (const bool annex_E : {false, true}) {
    const auto box = EffectiveBox(walls).below_yield(sagging, annex_E);
    const auto of = EffectivePath(path).below_yield(sagging, annex_E);
    REQUIRE(box);
    REQUIRE(of);
    CHECK(of->use(sagging) == Approx(box->use(sagging)).epsilon(2e-3));
    CHECK(of->use(sagging) < EffectivePath(path).use(sagging));
  }
}

}  // namespace below_yield_test
