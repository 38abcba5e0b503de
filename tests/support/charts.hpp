#pragma once

#include <stdexcept>
#include <string>

#include "boxbeam/study/chart.hpp"

/// Finding one's way in the results of a study.
namespace test {

inline const boxbeam::study::Chart& chart_of(const boxbeam::study::TopicResult& result,
                                             const std::string& name) {
  for (const auto& chart : result.charts) {
    if (chart.name == name) return chart;
  }
  throw std::out_of_range("no chart " + name);
}

/// Error of a method's setting with a number.
inline double error_at(const boxbeam::study::Chart& chart, const std::string& method,
                       double parameter) {
  for (const auto& series : chart.series) {
    if (series.method != method) continue;
    for (const auto& point : series.points) {
      if (point.parameter == parameter && point.failure.empty()) return point.error;
    }
  }
  throw std::out_of_range("no " + method + " in " + chart.name);
}

/// All errors of a study in their order, and where it failed a word of it.
inline std::string errors_of(const boxbeam::study::TopicResult& result) {
  std::string text;
  const auto add = [&](double value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const auto& chart : result.charts) {
    for (const auto& series : chart.series) {
      for (const auto& point : series.points) {
        add(point.error);
        text += point.failure;
      }
    }
  }
  for (const auto& map : result.maps) {
    for (const auto& panel : map.panels) {
      for (const auto& cell : panel.cells) {
        add(cell.value.value_or(-1.0));
        text += boxbeam::study::to_text(cell.outcome);
      }
    }
  }
  return text;
}

/// Points that came to nothing.
inline int failures_in(const boxbeam::study::TopicResult& result) {
  int count = 0;
  for (const auto& chart : result.charts) {
    for (const auto& series : chart.series) {
      for (const auto& point : series.points) count += point.failure.empty() ? 0 : 1;
    }
  }
  return count;
}

}  // namespace test
