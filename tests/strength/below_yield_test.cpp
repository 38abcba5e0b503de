// Plates that buckle below yield: hand values, the load factor that a step-by-step calculation at
// each level of load has, and what must hold for every box.

#include <algorithm>
#include <cmath>
#include <random>

#include "boxbeam/strength/effective_box.hpp"
#include "catch.hpp"

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

FourWalls random_walls(std::mt19937& random) {
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  return walls_of(in(300.0, 900.0), in(400.0, 1300.0), in(5.0, 14.0), in(5.0, 14.0), in(4.0, 10.0),
                  in(4.0, 10.0));
}

CutForces random_forces(std::mt19937& random) {
  const auto in = [&](double most) { return std::uniform_real_distribution(-most, most)(random); };
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
  std::mt19937 random(41);
  int settled = 0, milder = 0;
  for (int i = 0; i < 40; ++i) {
    const FourWalls walls = random_walls(random);
    const CutForces cut = random_forces(random);
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

}  // namespace below_yield_test
