#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "charts/chart.hpp"
#include "charts/scene.hpp"
#include "support/program.hpp"

/// Reading charts of the study, for its tests.
namespace test {

inline const boxbeam::charts::Chart& chart_named(const boxbeam::charts::TopicResult& result,
                                                 const std::string& name) {
  for (const boxbeam::charts::Chart& chart : result.charts) {
    if (chart.name == name) return chart;
  }
  throw std::out_of_range("no chart " + name);
}

/// Slope of the line of least squares through (log parameter, log error) of the points between two
/// errors.
inline double slope_of(const boxbeam::charts::Series& series, double lowest, double highest) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const boxbeam::charts::Point& point : series.points) {
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
inline double falling_slope_of(const boxbeam::charts::Series& series) {
  boxbeam::charts::Series falling;
  const auto least =
      std::min_element(series.points.begin(), series.points.end(),
                       [](const auto& a, const auto& b) { return a.error < b.error; });
  for (auto point = series.points.begin(); point != least; ++point) {
    if (point->error > 30.0 * least->error) falling.points.push_back(*point);
  }
  return slope_of(falling, 0.0, 1.0);
}

/// The one point that the program takes unless it is told otherwise.
inline const boxbeam::charts::Point& default_of(const boxbeam::charts::Chart& chart) {
  const boxbeam::charts::Point* found = nullptr;
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

inline boxbeam::charts::Scenes shipped_scene(const std::string& path) {
  return boxbeam::charts::scenes_of(boxbeam::read_project(project_file("sections/" + path)));
}

/// The first series whose method contains a word.
inline const boxbeam::charts::Series& series_of(const boxbeam::charts::Chart& chart,
                                                const std::string& word) {
  for (const boxbeam::charts::Series& series : chart.series) {
    if (series.method.find(word) != std::string::npos) return series;
  }
  throw std::out_of_range("no series " + word);
}

inline double error_at(const boxbeam::charts::Series& series, double parameter) {
  for (const boxbeam::charts::Point& point : series.points) {
    if (point.parameter == parameter) return point.error;
  }
  throw std::out_of_range("no such setting in " + series.method);
}

inline double error_of(const boxbeam::charts::Chart& chart, const std::string& method,
                       double parameter) {
  return error_at(series_of(chart, method), parameter);
}

/// Order between two settings: how the error falls with the parameter.
inline double order_between(const boxbeam::charts::Series& series, double from, double to) {
  return std::log(error_at(series, from) / error_at(series, to)) / std::log(to / from);
}

inline std::vector<boxbeam::charts::Point> defaults_of(const boxbeam::charts::Chart& chart) {
  std::vector<boxbeam::charts::Point> found;
  for (const boxbeam::charts::Series& series : chart.series) {
    std::copy_if(series.points.begin(), series.points.end(), std::back_inserter(found),
                 [](const boxbeam::charts::Point& point) { return point.is_default; });
  }
  return found;
}

/// Settings that came to nothing.
inline std::size_t failures_in(const boxbeam::charts::TopicResult& result) {
  std::size_t count = 0;
  for (const boxbeam::charts::Chart& chart : result.charts) {
    for (const boxbeam::charts::Series& series : chart.series) {
      for (const boxbeam::charts::Point& point : series.points) count += !point.failure.empty();
    }
  }
  return count;
}

/// All errors of a topic and the values of its maps, in order.
inline std::vector<double> errors_of(const boxbeam::charts::TopicResult& result) {
  std::vector<double> errors;
  for (const boxbeam::charts::Chart& chart : result.charts) {
    for (const boxbeam::charts::Series& series : chart.series) {
      for (const boxbeam::charts::Point& point : series.points) errors.push_back(point.error);
    }
  }
  for (const boxbeam::charts::Map& map : result.maps) {
    for (const boxbeam::charts::MapPanel& panel : map.panels) {
      for (const boxbeam::charts::Cell& cell : panel.cells) {
        errors.push_back(cell.value.value_or(-1.0 - static_cast<double>(cell.outcome)));
      }
    }
  }
  return errors;
}

}  // namespace test
