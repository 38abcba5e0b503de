// Lines of one level of values on a grid: circles by their radius, saddles by their middle.

#include "src/report/level_lines.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "catch.hpp"

namespace level_lines_test {

using namespace boxbeam::plot;

namespace {

GridOfValues grid_of_function(std::size_t nx, std::size_t ny, double (*f)(double, double)) {
  std::vector<double> x, y, values;
  for (std::size_t k = 0; k < nx * ny; ++k) {
    x.push_back(-1.0 + 2.0 * static_cast<double>(k % nx) / static_cast<double>(nx - 1));
    y.push_back(-1.0 + 2.0 * static_cast<double>(k / nx) / static_cast<double>(ny - 1));
    values.push_back(f(x.back(), y.back()));
  }
  const auto grid = grid_of(x, y, values);
  REQUIRE(grid);
  return *grid;
}

double length_of(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& lines) {
  double length = 0.0;
  for (const auto& [a, b] : lines) length += (a - b).norm();
  return length;
}

}  // namespace

TEST_CASE("lines of a level of x^2 + y^2 are a circle, as fine as the grid", "[report]") {
  double error = 1.0;
  for (const std::size_t n : {21UL, 41UL, 81UL}) {
    const GridOfValues grid =
        grid_of_function(n, n, [](double x, double y) { return x * x + y * y; });
    const auto lines = level_lines(grid, 0.36);
    double farthest = 0.0;
    for (const auto& [a, b] : lines)
      for (const Eigen::Vector2d& at : {a, b})
        farthest = std::max(farthest, std::abs(at.norm() - 0.6));
    CHECK(farthest < error / 3.0);  // by the square of the step
    error = farthest;
    CHECK(length_of(lines) == Approx(2.0 * std::numbers::pi * 0.6).epsilon(0.01));
    // The higher side stands always on the same hand: the circle is closed, each end a beginning.
    Eigen::Vector2d sum(0.0, 0.0);
    for (const auto& [a, b] : lines) sum += b - a;
    CHECK(sum.norm() < 1e-12);
    double turning = 0.0;
    for (const auto& [a, b] : lines) turning += 0.5 * (a.x() * b.y() - a.y() * b.x());
    CHECK(std::abs(turning) == Approx(std::numbers::pi * 0.36).epsilon(0.01));
  }
}

TEST_CASE("of a saddle the middle says which corners hang together", "[report]") {
  // Corners 1, 0 / 0, 1 about a middle of 0.5: below it the high corners are joined, above it not.
  for (const bool turned : {false, true}) {
    GridOfValues grid{{0.0, 1.0, 2.0}, {0.0, 1.0, 2.0}, {1, 0, 0, 0, 1, 0, 0, 0, 0}};
    if (turned) grid.values = {0, 1, 0, 1, 0, 0, 0, 0, 0};
    for (const double level : {0.4, 0.6}) {
      CAPTURE(turned, level);
      const auto lines = level_lines(grid, level);
      std::size_t inside = 0;
      for (const auto& [a, b] : lines) {
        if (std::max({a.x(), b.x(), a.y(), b.y()}) > 1.0) continue;
        ++inside;
        // What is cut off, by the side of the field's middle on which the line passes.
        const Eigen::Vector2d middle = 0.5 * (a + b) - Eigen::Vector2d(0.5, 0.5);
        const bool near_first = middle.x() * middle.y() > 0.0;  // corners (0, 0) and (1, 1)
        const bool first_high = !turned, cuts_high = level > 0.5;
        CHECK(near_first == (first_high == cuts_high));
      }
      CHECK(inside == 2);
    }
  }
}

TEST_CASE("values that are no whole grid are none; a missing one leaves its fields out",
          "[report]") {
  const std::vector<double> x{0, 1, 2, 0, 1, 2, 0, 1, 2}, y{0, 0, 0, 1, 1, 1, 2, 2, 2};
  const std::vector<double> values{0, 1, 2, 1, 2, 3, 2, 3, 4};
  CHECK(grid_of(x, y, values));
  CHECK_FALSE(grid_of({0, 1, 2, 0, 1, 2, 0, 1, 1}, y, values));
  CHECK_FALSE(grid_of({0, 1, 0, 1, 0, 1}, {0, 0, 1, 1, 2, 2}, {1, 2, 3, 4, 5, 6}));
  std::vector<double> with_gap = values;
  with_gap[4] = std::numeric_limits<double>::quiet_NaN();  // in the middle: of all four fields
  CHECK(level_lines(*grid_of(x, y, with_gap), 1.5).empty());
  CHECK(level_lines(*grid_of(x, y, values), 1.5).size() == 3);
  // Between places in proportion: the plane x + y.
  CHECK(grid_of(x, y, values)->at(1.25, 0.5) == Approx(1.75));
  CHECK(grid_of(x, y, values)->at(2.0, 2.0) == Approx(4.0));
}

}  // namespace level_lines_test
