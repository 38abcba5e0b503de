// Accuracy of kinematics: what theory predicts, seen in the errors of the charts.

#include "charts/chart_values.hpp"
#include "charts/topics.hpp"

namespace kinematics_test {

using namespace boxbeam::charts;

namespace {

/// What must hold of any planar case that is made of dyads.
void check_kinematics(const TopicResult& result) {
  REQUIRE(result.not_applicable == "");
  for (const char* name :
       {"kinematics-positions", "kinematics-velocities", "kinematics-accelerations"}) {
    const Chart& chart = test::chart_named(result, name);
    INFO(name);
    CHECK(chart.reference == "closed-form dyads in long double");
    // The default: to a few units of round-off, far below what a check needs.
    CHECK(test::default_of(chart).error < 1e-14);
    CHECK(test::default_of(chart).error < 1e-9 * chart.needed_low);
    const Series& dense = chart.series[0];
    const Series& sparse = chart.series[1];
    const Series& plain = chart.series[2];
    REQUIRE(chart.series[3].points.front().failure == "");
    CHECK(chart.series[3].points.front().error < 1e-13);  // dyads
    for (std::size_t i = 0; i < dense.points.size(); ++i) {
      // The same iterations, the same digits, less work.
      CHECK(sparse.points[i].error == Approx(dense.points[i].error).margin(1e-14).epsilon(1e-3));
      CHECK(*sparse.points[i].operations < *dense.points[i].operations);
    }
    for (const Series* series : {&sparse, &plain}) {
      for (std::size_t i = 1; i < series->points.size(); ++i) {
        CHECK(series->points[i].error < 1.5 * series->points[i - 1].error + 1e-14);
        CHECK(*series->points[i].operations >= *series->points[i - 1].operations);
      }
      // Newton squares the error: steps below the root of round-off leave nothing but round-off.
      for (const Point& point : series->points) {
        if (point.parameter < 1e-7) CHECK(point.error < 1e-13);
      }
    }
    // What a step below the tolerance leaves is of the order of its square.
    for (const Point& point : plain.points) {
      CHECK(point.error < 100.0 * point.parameter * point.parameter + 1e-13);
    }
  }

  const Chart& differences = test::chart_named(result, "kinematics-differences");
  // Orders 2 and 4 of central differences; behind, round-off over the square of the step: -2.
  CHECK(test::falling_slope_of(differences.series[0]) == Approx(-2.0).margin(0.1));
  CHECK(test::falling_slope_of(differences.series[1]) == Approx(-4.0).margin(0.2));
  const auto& points = differences.series[1].points;
  CHECK(points.back().error > 100.0 * points[points.size() - 3].error);
  CHECK(points.back().error < 400.0 * points[points.size() - 3].error);
  CHECK(test::default_of(differences).error < 1e-13);

  const Chart& predictor = test::chart_named(result, "kinematics-predictor");
  // A Taylor series of order p leaves an error of order p + 1.
  for (std::size_t order = 0; order <= 2; ++order) {
    CHECK(test::slope_of(predictor.series[order], 1e-9, 1e-2) ==
          Approx(-1.0 - static_cast<double>(order)).margin(0.15));
  }

  const Chart& toggle = test::chart_named(result, "kinematics-toggle");
  // Positions lose digits with the root of the distance, velocities and accelerations with the
  // distance itself.
  CHECK(test::slope_of(toggle.series[0], 1e-16, 1e-3) == Approx(-0.5).margin(0.25));
  CHECK(test::slope_of(toggle.series[1], 1e-16, 1e-1) == Approx(-1.0).margin(0.25));
  CHECK(test::slope_of(toggle.series[2], 1e-16, 1e-1) == Approx(-1.0).margin(0.25));
  for (const Point& point : toggle.series[1].points) {
    if (point.failure.empty()) CHECK(point.error < 1e-14 / point.parameter);
  }
}

}  // namespace

TEST_CASE("kinematics of the sledge rig: orders, floors, and the same errors twice") {
  const TopicResult result = kinematics(reference_scenes(), {true});
  check_kinematics(result);
  CHECK(test::errors_of(kinematics(reference_scenes(), {true})) == test::errors_of(result));
}

TEST_CASE("kinematics of other shipped mechanisms") {
  for (const char* path : {"four-bar-rocker/rocker.toml", "slider-crank-press/press.toml"}) {
    INFO(path);
    check_kinematics(kinematics(test::shipped_scene(path), {true}));
  }
}

TEST_CASE("kinematics has nothing to say of elastic links, and says so") {
  const TopicResult result = kinematics(test::shipped_scene("drill-truck/truck.toml"), {true});
  CHECK(result.charts.empty());
  CHECK(result.not_applicable.find("elastic links") != std::string::npos);
}

}  // namespace kinematics_test
