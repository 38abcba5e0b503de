#include <cmath>

#include "boxbeam/section/torsion.hpp"
#include "catch.hpp"
#include "charts/chart.hpp"
#include "charts/stress_function.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"
#include "support/program.hpp"

namespace sections_test {

using namespace boxbeam;
using namespace boxbeam::charts;

namespace {

void check_charts(const TopicResult& result) {
  REQUIRE(result.charts.size() == 3);
  const Chart& walls = result.charts[0];
  const Chart& torsion = result.charts[1];
  const Chart& tube = result.charts[2];

  // Integrals along the border are exact; the difference of two loops loses the digits of b/t.
  for (std::size_t own = 0; own < 4; ++own) {
    for (const Point& point : walls.series[own].points) {
      CAPTURE(walls.series[own].method, point.setting);
      CHECK(point.error < 1e-15 * (10.0 + point.parameter));
    }
  }
  // Mid-lines leave out the walls' own bending, of (t/h)^2; their fibre lies half a wall too low.
  for (const auto& [series, order] : {std::pair{4U, 2.0}, {5U, 1.0}, {6U, 2.0}}) {
    const auto& points = walls.series[series].points;
    const std::size_t last = points.size() - 1;
    CHECK(order_over_work(points[last - 1], points[last]) == Approx(order).margin(0.05));
  }
  // W = I/(h/2): of a thin box the error is t/h of the height to the mid-lines.
  REQUIRE(default_point(walls) != nullptr);

  // Corners matched: valid for clear sides longer than 1.5 times the plates.
  REQUIRE(default_point(torsion) != nullptr);
  for (const Point& point : torsion.series[0].points) {
    CAPTURE(point.setting);
    if (point.parameter >= 5.0) CHECK(point.error < 2e-5);
    if (point.parameter >= 20.0) CHECK(point.error < 1e-6);
  }
  const auto& bredt = torsion.series[2].points;
  CHECK(order_over_work(bredt[bredt.size() - 2], bredt.back()) == Approx(1.0).margin(0.1));

  // Polygons: inside the circle order 2; of the same area the second moment is too large by
  // (2 pi/n)^4/180 of it.
  REQUIRE(default_point(tube)->error < 1e-14);
  const auto& inside = tube.series[1].points;
  const auto& same_area = tube.series[2].points;
  CHECK(order_over_work(inside[1], inside[3]) == Approx(2.0).margin(0.02));
  CHECK(order_over_work(same_area[1], same_area[2]) == Approx(4.0).margin(0.02));
  CHECK(same_area[1].error ==
        Approx(std::pow(2.0 * std::acos(-1.0) / 32.0, 4) / 180.0).epsilon(0.02));
  for (const Chart& chart : result.charts) CHECK_FALSE(chart.lesson.empty());
}

}  // namespace

TEST_CASE("chart section: orders, floors, the default", "[charts]") {
  check_charts(sections(reference_scenes(), {true}));
}

TEST_CASE("chart section: on the box of another case", "[charts]") {
  check_charts(sections(
      scenes_of(read_project(test::project_file("sections/drill-truck/truck.toml"))), {true}));
}

TEST_CASE("torsion by elements: seven digits, against published and independent figures",
          "[charts]") {
  // An independent stress-function solution of the box 400 x 1000 x 50 has 8.8577e9 mm^4.
  CHECK(torsion_constant_by_elements(0.4, 1.0, 0.05, 32) * 1e12 == Approx(8.8577e9).epsilon(5e-5));
  // The finer the mesh, the smaller the step to the next.
  const double coarse = torsion_constant_by_elements(0.4, 1.0, 0.05, 16);
  const double fine = torsion_constant_by_elements(0.4, 1.0, 0.05, 32);
  CHECK(std::abs(fine / coarse - 1.0) < 1e-5);
}

}  // namespace sections_test
