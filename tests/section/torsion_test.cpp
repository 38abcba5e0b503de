// Torsion constants against closed forms and an independent finite-element solution.

#include "boxbeam/section/torsion.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>
#include <vector>

#include "catch.hpp"
#include "section/random_sections.hpp"

namespace torsion_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

double constant_of(const Profile& profile) { return torsion_constant_of(profile)->value() * 1e12; }

/// Prandtl's stress function of a doubly symmetric box on a quarter of it, bilinear elements of
/// size h: zero on the outside, one unknown for the whole hollow. I_T = 2 int phi dA [mm^4].
double finite_element_constant(double width, double height, double flange, double web, double h) {
  const auto nx = static_cast<int>(std::lround(0.5 * width / h));
  const auto ny = static_cast<int>(std::lround(0.5 * height / h));
  const auto hollow_x = static_cast<int>(std::lround((0.5 * width - web) / h));
  const auto hollow_y = static_cast<int>(std::lround((0.5 * height - flange) / h));
  std::vector<int> unknown(static_cast<std::size_t>((nx + 1) * (ny + 1)), -1);
  const auto index = [&](int i, int j) { return static_cast<std::size_t>(i * (ny + 1) + j); };
  int count = 1;  // 0: the hollow
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      unknown[index(i, j)] = i <= hollow_x && j <= hollow_y ? 0 : count++;
    }
  }
  const double stiffness[4] = {4.0 / 6, -1.0 / 6, -2.0 / 6, -1.0 / 6};
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(count);
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      const std::size_t corners[4] = {index(i, j), index(i + 1, j), index(i + 1, j + 1),
                                      index(i, j + 1)};
      for (int a = 0; a < 4; ++a) {
        const int row = unknown[corners[a]];
        if (row < 0) continue;
        load[row] += 2.0 * h * h / 4.0;
        for (int b = 0; b < 4; ++b) {
          const int column = unknown[corners[b]];
          if (column >= 0) entries.emplace_back(row, column, stiffness[(b - a + 4) % 4]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  return 4.0 * load.dot(solver.solve(load).eval());
}

/// Extrapolated at the order 4/3 of the re-entrant corners.
double extrapolated_constant(double width, double height, double flange, double web, double h) {
  const double coarse = finite_element_constant(width, height, flange, web, h);
  const double fine = finite_element_constant(width, height, flange, web, 0.5 * h);
  return fine + (fine - coarse) / (std::pow(2.0, 4.0 / 3.0) - 1.0);
}

}  // namespace

TEST_CASE("thick-walled box 400 x 1000 x 50: 8.8577e9 mm^4, where Bredt alone is 4 % low",
          "[section]") {
  const Box box = symmetric_box(mm(400), mm(1000), mm(50), mm(50));
  // From an independent stress-function solution.
  CHECK(constant_of(box) == Approx(8.8577e9).epsilon(5e-4));
  const double bredt = 4.0 * 350 * 950 * 350 * 950 / ((2 * 350 + 2 * 950) / 50.0);
  CHECK(bredt / 8.8577e9 == Approx(0.96).margin(0.002));
}

TEST_CASE(
    "boxes of plates thicker than they are long are never stiffer than they are, nor "
    "negative",
    "[section]") {
  // Width, height, flange, web: the corners fill the box and meet each other.
  struct Dimensions {
    double width, height, flange, web;
  };
  for (const Dimensions& of : {Dimensions{160, 40, 15, 70}, Dimensions{160, 40, 15, 40},
                               Dimensions{100, 100, 40, 40}, Dimensions{120, 60, 25, 40}}) {
    CAPTURE(of.width, of.height, of.flange, of.web);
    const double exact = extrapolated_constant(of.width, of.height, of.flange, of.web, 1.0);
    const double ours =
        constant_of(symmetric_box(mm(of.width), mm(of.height), mm(of.flange), mm(of.web)));
    CHECK(ours < 1.001 * exact);
    CHECK(ours > 0.7 * exact);
  }
}

TEST_CASE("boxes against finite elements, within 0.2 %", "[section]") {
  const double cases[][4] = {{400, 1000, 50, 50},
                             {400, 600, 50, 50},
                             {400, 600, 50, 25},
                             {300, 500, 12.5, 50},
                             {500, 300, 75, 50}};
  for (const auto& [width, height, flange, web] : cases) {
    CAPTURE(width, height, flange, web);
    CHECK(constant_of(symmetric_box(mm(width), mm(height), mm(flange), mm(web))) ==
          Approx(extrapolated_constant(width, height, flange, web, 6.25)).epsilon(2e-3));
  }
}

TEST_CASE("a thin box has Bredt's constant", "[section]") {
  const double b = 400, h = 600, t = 1;
  CHECK(constant_of(symmetric_box(mm(b + t), mm(h + t), mm(t), mm(t))) ==
        Approx(4 * b * b * h * h / ((2 * b + 2 * h) / t)).epsilon(5e-3));
}

TEST_CASE("round tube: polar second moment", "[section]") {
  CHECK(constant_of(RoundTube{mm(200), mm(20)}) ==
        Approx(std::numbers::pi / 32 * (std::pow(200, 4) - std::pow(160, 4))).epsilon(1e-12));
}

TEST_CASE("solid rectangles: Timoshenko's table of b^3 h k_1 and b^2 h k_2", "[section]") {
  // Theory of Elasticity, article 109: h/b, k_1 (constant), k_2 (largest stress, on the long side).
  const double table[][3] = {{1.0, 0.1406, 0.208}, {1.5, 0.196, 0.231}, {2.0, 0.229, 0.246},
                             {3.0, 0.263, 0.267},  {5.0, 0.291, 0.291}, {10.0, 0.312, 0.312}};
  for (const auto& [ratio, k_1, k_2] : table) {
    CAPTURE(ratio);
    const double b = 10, h = 10 * ratio;
    CHECK(constant_of(Plate{mm(b), mm(h)}) == Approx(k_1 * b * b * b * h).epsilon(3e-3));
    CHECK(constant_of(Plate{mm(h), mm(b)}) == Approx(k_1 * b * b * b * h).epsilon(3e-3));
    CHECK(torsion_shear_of_rectangle(mm(h), mm(b)) * 1e-9 ==
          Approx(1 / (k_2 * b * b * h)).epsilon(3e-3));
  }
}

TEST_CASE("solid rectangles: the middle of the short side, however thin", "[section]") {
  // Thin: 8 G/pi^2 of the stress on the long side, G = 0.915965594177219 (Catalan's constant),
  // which is T/(b^2 h/3) up to 0.63 b/h.
  for (const double ratio : {1e3, 1e4, 1e6, 1e9}) {
    CAPTURE(ratio);
    const double b = 1.0, h = ratio;
    const double expected = 8 * 0.915965594177219 / (std::numbers::pi * std::numbers::pi) * 3 /
                            (b * b * h) / (1 - 0.6302 * b / h);
    CHECK(torsion_shear_of_rectangle(si<Length>(b), si<Length>(h)) ==
          Approx(expected).epsilon(1e-6));
  }
  // The same article's other series, 1 - 8/pi^2 sum 1/(n^2 cosh(n pi h/(2 b))), which converges
  // for any side.
  for (const double ratio : {1.0, 1.5, 3.0, 10.0}) {
    CAPTURE(ratio);
    const double side = 1.0, other = ratio;
    double sum = 0.0;
    for (int n = 1; n < 20000; n += 2) {
      sum += 1.0 /
             (1.0 * n * n * std::cosh(std::min(0.5 * n * std::numbers::pi * side / other, 700.0)));
    }
    const double I = torsion_constant_of_rectangle(si<Length>(side), si<Length>(other)).value();
    CHECK(torsion_shear_of_rectangle(si<Length>(side), si<Length>(other)) ==
          Approx(other / I * (1 - 8 / (std::numbers::pi * std::numbers::pi) * sum)).epsilon(1e-12));
  }
}

TEST_CASE("a box whose hollow closes is at most 1.5 % softer than the solid rectangle",
          "[section]") {
  // Outside the range of the formula, where one corner feels the next: a bound, no accuracy.
  for (const double height : {1000.0, 2000.0, 5000.0, 10000.0}) {
    CAPTURE(height);
    const double wall = 499.999;
    const double solid = constant_of(Plate{mm(1000), mm(height)});
    const double box = constant_of(symmetric_box(mm(1000), mm(height), mm(wall), mm(wall)));
    CHECK(box < solid);
    CHECK(box > 0.985 * solid);
  }
}

TEST_CASE("open path: sum of s t^3/3; polygons have no constant", "[section]") {
  const auto at = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  const ThinWalled angle{{at(100, 0), at(0, 0), at(0, 80)},
                         {{0, 1, mm(6), {}, {}}, {1, 2, mm(4), {}, {}}}};
  CHECK(constant_of(angle) == Approx((100 * 216 + 80 * 64) / 3.0).epsilon(1e-12));
  CHECK_FALSE(torsion_constant_of(Polygon{{at(0, 0), at(10, 0), at(0, 10)}}));
  CHECK_FALSE(torsion_properties_of({Polygon{{at(0, 0), at(10, 0), at(0, 10)}}, {}}).shear_centre);
}

TEST_CASE("a box as a path of four walls has the same cell, up to the corners", "[section]") {
  const auto at = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  const ThinWalled path{{at(-195, -295), at(195, -295), at(195, 295), at(-195, 295)},
                        {{0, 1, mm(10), {}, {}},
                         {1, 2, mm(10), {}, {}},
                         {2, 3, mm(10), {}, {}},
                         {3, 0, mm(10), {}, {}}}};
  CHECK(enclosed_area_of(path).value() * 1e6 == Approx(390 * 590.0).epsilon(1e-12));
  CHECK(constant_of(path) ==
        Approx(constant_of(symmetric_box(mm(400), mm(600), mm(10), mm(10)))).epsilon(0.01));
}

TEST_CASE("a wall in the middle of a box carries no torsion: two equal cells", "[section]") {
  const auto at = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  ThinWalled path{
      {at(-200, -100), at(0, -100), at(200, -100), at(200, 100), at(0, 100), at(-200, 100)}, {}};
  for (std::size_t i = 0; i < 6; ++i) path.walls.push_back({i, (i + 1) % 6, mm(5), {}, {}});
  const double one_cell = constant_of(path);
  path.walls.push_back({1, 4, mm(5), {}, {}});
  CHECK(constant_of(path) == Approx(one_cell + 200 * 125 / 3.0).epsilon(1e-9));
  CHECK(enclosed_area_of(path).value() * 1e6 == Approx(400 * 200.0).epsilon(1e-12));
}

TEST_CASE("nested profiles twist alike: constants add", "[section]") {
  const Box outer = symmetric_box(mm(400), mm(600), mm(50), mm(50));
  const RectangularTube inner{mm(290), mm(490), mm(56)};
  CHECK(torsion_properties_of({outer, inner}).I_T->value() * 1e12 ==
        Approx(constant_of(outer) + constant_of(inner)).epsilon(1e-12));
}

}  // namespace torsion_test
