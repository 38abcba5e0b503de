// The thinnest walls of polygons by hand, and the lower bound of their torsion constant against
// closed forms.

#include "boxbeam/section/polygon_walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"

namespace polygon_walls_test {

using namespace boxbeam;

namespace {

using Corners = std::vector<SectionPlace>;

Corners corners(std::initializer_list<std::pair<double, double>> places) {
  Corners result;
  for (const auto& [y, z] : places) result.push_back({si<Length>(y), si<Length>(z)});
  return result;
}

Corners rectangle(double b, double h) {
  return corners({{-b / 2, -h / 2}, {b / 2, -h / 2}, {b / 2, h / 2}, {-b / 2, h / 2}});
}

/// Half axes a and b.
Corners ellipse(double a, double b, int count = 180) {
  Corners result;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    result.push_back({si<Length>(a * std::cos(angle)), si<Length>(b * std::sin(angle))});
  }
  return result;
}

/// Flanges b x t, a web s, h high in all.
Corners girder(double b, double t, double s, double h) {
  const double z = h / 2, in = h / 2 - t, w = s / 2;
  return corners({{-b / 2, -z},
                  {b / 2, -z},
                  {b / 2, -in},
                  {w, -in},
                  {w, in},
                  {b / 2, in},
                  {b / 2, z},
                  {-b / 2, z},
                  {-b / 2, in},
                  {-w, in},
                  {-w, -in},
                  {-b / 2, -in}});
}

double slenderness(const Polygon& polygon) { return most_slender_wall_of(polygon)->slenderness(); }

double least(const Polygon& polygon) { return least_torsion_constant_of(polygon).value(); }

}  // namespace

TEST_CASE("the thinnest wall of a polygon is its length over what stands behind it") {
  CHECK(slenderness({rectangle(0.2, 0.2)}) == Approx(1.0));
  CHECK(slenderness({rectangle(0.2, 0.02)}) == Approx(10.0));
  // A web 1200 x 3; the last steps of a 32nd before the flanges belong to it.
  CHECK(slenderness({girder(0.2, 0.012, 0.003, 1.224)}) == Approx(400.0).epsilon(1e-9));
  // Half a flange 300 x 10 beside the web, less than one step of 300/32 more on the outer side.
  const double flange = slenderness({girder(0.3, 0.01, 0.03, 0.3)});
  CHECK(flange >= 13.5 - 1e-9);
  CHECK(flange <= 15.0);
  // 390 x 390 with a hollow of 387: from without all but a corner's thickness.
  const double hollow = slenderness({rectangle(0.39, 0.39), {rectangle(0.387, 0.387)}});
  CHECK(hollow >= 387.0 / 1.5);
  CHECK(hollow <= 390.0 / 1.5 + 1e-9);
  // A solid round has none; a pipe of 60 x 0.5 does along the 60 degrees that a stretch turns.
  CHECK(slenderness({ellipse(0.1, 0.1)}) < 1.0);
  CHECK(slenderness({ellipse(0.03, 0.03), {ellipse(0.0295, 0.0295)}}) > 50.0);
}

TEST_CASE("walls of polygons do not hang on size, place, turning or the order of corners") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> size(0.05, 0.2), thin(0.01, 0.03), angle(0.0, 6.28);
  for (int k = 0; k < 50; ++k) {
    Polygon polygon{girder(size(random), thin(random), thin(random), 0.1 + size(random))};
    const double ratio = slenderness(polygon), I_T = least(polygon);
    const double turn = angle(random), times = 3.0;
    for (SectionPlace& of : polygon.outer) {
      const double y = of.y.value(), z = of.z.value();
      of.y = si<Length>(times * (y * std::cos(turn) - z * std::sin(turn)) + 0.1);
      of.z = si<Length>(times * (y * std::sin(turn) + z * std::cos(turn)) - 0.3);
    }
    std::reverse(polygon.outer.begin(), polygon.outer.end());
    CHECK(slenderness(polygon) == Approx(ratio).epsilon(1e-6));
    // A grid of at least six steps in the thinnest wall.
    CHECK(least(polygon) == Approx(std::pow(times, 4) * I_T).epsilon(0.08));
  }
}

TEST_CASE("the torsion constant of a polygon is not below its bound") {
  const double pi = std::numbers::pi;
  for (const double h : {0.01, 0.02, 0.05, 0.1, 0.15, 0.3, 1.0}) {
    const double exact = torsion_constant_of_rectangle(si<Length>(0.1), si<Length>(h)).value();
    CHECK(least({rectangle(0.1, h)}) <= exact);
    CHECK(least({rectangle(0.1, h)}) >= 0.65 * exact);
  }
  // pi a^3 b^3/(a^2 + b^2): Saint-Venant's ellipse.
  for (const double b : {0.01, 0.04, 0.1}) {
    const double exact = pi * 1e-3 * b * b * b / (1e-2 + b * b);
    CHECK(least({ellipse(0.1, b)}) <= exact);
    CHECK(least({ellipse(0.1, b)}) >= 0.65 * exact);
  }
  // sqrt(3)/80 a^4: the equal-sided triangle.
  const Polygon triangle{corners({{0.0, 0.0}, {0.1, 0.0}, {0.05, 0.1 * std::sqrt(0.75)}})};
  CHECK(least(triangle) <= std::sqrt(3.0) / 80.0 * 1e-4);
  // Sum of b t^3/3 of the three plates, which thin shapes have within the fillets.
  for (const double s : {0.012, 0.024, 0.036}) {
    const double exact = (2.0 * 0.2 * std::pow(0.024, 3) + 0.352 * std::pow(s, 3)) / 3.0;
    CHECK(least({girder(0.2, 0.024, s, 0.4)}) <= 1.05 * exact);
    CHECK(least({girder(0.2, 0.024, s, 0.4)}) >= 0.6 * exact);
  }
  // A round tube: pi/2 (R^4 - r^4); Bredt's formula within the wall's thickness.
  for (const double r : {0.099, 0.09, 0.05, 0.01}) {
    const double exact = 0.5 * pi * (1e-4 - std::pow(r, 4));
    CHECK(least({ellipse(0.1, 0.1), {ellipse(r, r)}}) <= exact);
  }
  CHECK(least({ellipse(0.1, 0.1), {ellipse(0.098, 0.098)}}) >=
        0.9 * 0.5 * pi * (1e-4 - std::pow(0.098, 4)));
  // An eccentric hollow: by the thinnest wall, below that of the even one.
  Polygon eccentric{rectangle(0.2, 0.2), {rectangle(0.18, 0.18)}};
  const double even = least(eccentric);
  for (SectionPlace& of : eccentric.hollows.front()) of.y += si<Length>(0.005);
  CHECK(least(eccentric) < even);
  Box box;
  box.width = box.height = si<Length>(0.2);
  box.top_flange = box.bottom_flange = box.left_web = box.right_web = si<Length>(0.01);
  CHECK(even <= torsion_constant_of_box(box).value());
  CHECK(even >= 0.85 * torsion_constant_of_box(box).value());
}

}  // namespace polygon_walls_test
