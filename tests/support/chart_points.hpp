#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "boxbeam/study/chart.hpp"

/// What charts say, for tests of their errors.
namespace test {

inline const boxbeam::study::Chart& chart_named(const boxbeam::study::TopicResult& result,
                                                const std::string& name) {
  for (const boxbeam::study::Chart& chart : result.charts) {
    if (chart.name == name) return chart;
  }
  throw std::out_of_range("no chart " + name);
}

/// The first series whose method contains a word.
inline const boxbeam::study::Series& series_of(const boxbeam::study::Chart& chart,
                                               const std::string& word) {
  for (const boxbeam::study::Series& series : chart.series) {
    if (series.method.find(word) != std::string::npos) return series;
  }
  throw std::out_of_range("no series " + word);
}

inline double error_at(const boxbeam::study::Series& series, double parameter) {
  for (const boxbeam::study::Point& point : series.points) {
    if (point.parameter == parameter) return point.error;
  }
  throw std::out_of_range("no such setting in " + series.method);
}

/// Order between two settings: how the error falls with the parameter.
inline double order_between(const boxbeam::study::Series& series, double from, double to) {
  return std::log(error_at(series, from) / error_at(series, to)) / std::log(to / from);
}

inline std::vector<boxbeam::study::Point> defaults_of(const boxbeam::study::Chart& chart) {
  std::vector<boxbeam::study::Point> found;
  for (const boxbeam::study::Series& series : chart.series) {
    std::copy_if(series.points.begin(), series.points.end(), std::back_inserter(found),
                 [](const boxbeam::study::Point& point) { return point.is_default; });
  }
  return found;
}

/// Settings that came to nothing.
inline std::size_t failures_in(const boxbeam::study::TopicResult& result) {
  std::size_t count = 0;
  for (const boxbeam::study::Chart& chart : result.charts) {
    for (const boxbeam::study::Series& series : chart.series) {
      for (const boxbeam::study::Point& point : series.points) count += !point.failure.empty();
    }
  }
  return count;
}

/// All errors of a topic and the values of its maps, in order.
inline std::vector<double> errors_of(const boxbeam::study::TopicResult& result) {
  std::vector<double> errors;
  for (const boxbeam::study::Chart& chart : result.charts) {
    for (const boxbeam::study::Series& series : chart.series) {
      for (const boxbeam::study::Point& point : series.points) errors.push_back(point.error);
    }
  }
  for (const boxbeam::study::Map& map : result.maps) {
    for (const boxbeam::study::MapPanel& panel : map.panels) {
      for (const boxbeam::study::Cell& cell : panel.cells) {
        errors.push_back(cell.value.value_or(-1.0 - static_cast<double>(cell.outcome)));
      }
    }
  }
  return errors;
}

}  // namespace test
