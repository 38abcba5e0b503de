#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/study/chart.hpp"
#include "boxbeam/study/scene.hpp"
#include "catch.hpp"
#include "support/program.hpp"

/// Reading charts of the study, for its tests.
namespace test {

inline const boxbeam::study::Chart& chart_named(const boxbeam::study::TopicResult& result,
                                                const std::string& name) {
  const auto found = std::find_if(result.charts.begin(), result.charts.end(),
                                  [&](const auto& chart) { return chart.name == name; });
  INFO("chart " << name);
  REQUIRE(found != result.charts.end());
  return *found;
}

/// Slope of the line of least squares through (log parameter, log error) of the points between two
/// errors.
inline double slope_of(const boxbeam::study::Series& series, double lowest, double highest) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const boxbeam::study::Point& point : series.points) {
    if (!point.failure.empty() || point.error < lowest || point.error > highest) continue;
    const double u = std::log(point.parameter);
    const double w = std::log(point.error);
    n += 1.0;
    x += u;
    y += w;
    xx += u * u;
    xy += u * w;
  }
  REQUIRE(n >= 2.0);
  return (n * xy - x * y) / (n * xx - x * x);
}

/// The slope where a series falls: before its least error, and well above it, where round-off has
/// no part.
inline double falling_slope_of(const boxbeam::study::Series& series) {
  boxbeam::study::Series falling;
  const auto least =
      std::min_element(series.points.begin(), series.points.end(),
                       [](const auto& a, const auto& b) { return a.error < b.error; });
  for (auto point = series.points.begin(); point != least; ++point) {
    if (point->error > 30.0 * least->error) falling.points.push_back(*point);
  }
  return slope_of(falling, 0.0, 1.0);
}

/// All errors of a result, in order.
inline std::vector<double> errors_of(const boxbeam::study::TopicResult& result) {
  std::vector<double> errors;
  for (const auto& chart : result.charts) {
    for (const auto& series : chart.series) {
      for (const auto& point : series.points) errors.push_back(point.error);
    }
  }
  return errors;
}

/// The one point that the program takes unless it is told otherwise.
inline const boxbeam::study::Point& default_of(const boxbeam::study::Chart& chart) {
  const boxbeam::study::Point* found = nullptr;
  int count = 0;
  for (const auto& series : chart.series) {
    for (const auto& point : series.points) {
      if (!point.is_default) continue;
      found = &point;
      ++count;
    }
  }
  INFO("chart " << chart.name);
  REQUIRE(count == 1);
  return *found;
}

inline boxbeam::study::Scenes shipped_scene(const std::string& path) {
  return boxbeam::study::scenes_of(boxbeam::read_project(project_file("sections/" + path)));
}

}  // namespace test
