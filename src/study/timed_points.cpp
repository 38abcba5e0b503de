#include "boxbeam/study/timed_points.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace boxbeam::study {

Point solved_point(const std::string& setting, double parameter, double operations, double error) {
  return {setting, parameter, operations, {}, error, "", false};
}

Point failed_point(const std::string& setting, double parameter, double operations,
                   const std::string& failure) {
  return {setting, parameter, operations, {}, 0.0, failure, false};
}

Chart without_answer(Chart chart, const std::string& failure) {
  chart.series = {{"reference", {failed_point("the case as it is", 1.0, 1.0, failure)}, false}};
  chart.lesson = "No answer: " + failure;
  return chart;
}

void PointTimer::add(const Chart& chart, std::function<void()> work) {
  assert(!chart.series.empty() && !chart.series.back().points.empty());
  places_.push_back({chart.series.size() - 1, chart.series.back().points.size() - 1});
  works_.push_back(std::move(work));
}

void PointTimer::measure(Chart& chart, const Effort& effort) const {
  const std::vector<Timing> timings = times_of(works_, effort);
  for (std::size_t i = 0; i < timings.size(); ++i) {
    chart.series[places_[i].series].points[places_[i].point].time = timings[i];
  }
}

const Point* default_of(const Chart& chart) {
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      if (point.is_default) return &point;
    }
  }
  return nullptr;
}

double order_between(const Point& coarse, const Point& fine) {
  return std::log(coarse.error / fine.error) / std::log(fine.parameter / coarse.parameter);
}

}  // namespace boxbeam::study
