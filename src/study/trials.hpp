#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "boxbeam/study/chart.hpp"
#include "boxbeam/study/stopwatch.hpp"

namespace boxbeam::study {

/// A chart in the making: its points, and what is to be timed for each of them.
class Trials {
 public:
  explicit Trials(Chart chart) : chart_(std::move(chart)) {}

  /// Begins a series; points go to the last one.
  void series(std::string method, bool yardstick) {
    chart_.series.push_back({std::move(method), {}, yardstick});
  }

  /// A setting and the unit of work that is timed.
  void add(Point point, std::function<void()> work) {
    chart_.series.back().points.push_back(std::move(point));
    works_.push_back(std::move(work));
  }

  const Chart& chart() const { return chart_; }

  /// The chart, with all its points timed by turns.
  Chart timed(const Effort& effort) const {
    Chart chart = chart_;
    const std::vector<Timing> times = times_of(works_, effort);
    std::size_t next = 0;
    for (Series& series : chart.series) {
      for (Point& point : series.points) point.time = times[next++];
    }
    return chart;
  }

 private:
  Chart chart_;
  std::vector<std::function<void()>> works_;
};

/// The setting that is as the program does it; nullptr where a chart has none.
inline const Point* default_of(const Chart& chart) {
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      if (point.is_default) return &point;
    }
  }
  return nullptr;
}

}  // namespace boxbeam::study
