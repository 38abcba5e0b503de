#include "charts/trials.hpp"

#include <cmath>
#include <cstddef>

namespace boxbeam::charts {

std::vector<Series> timed(const std::vector<TriedMethod>& methods, const Effort& effort) {
  std::vector<std::function<void()>> works;
  for (const TriedMethod& method : methods) {
    for (const Trial& trial : method.trials) {
      if (trial.point.failure.empty() && trial.work) works.push_back(trial.work);
    }
  }
  const std::vector<Timing> timings = times_of(works, effort);
  std::vector<Series> all;
  std::size_t next = 0;
  for (const TriedMethod& method : methods) {
    Series series{method.method, {}, method.yardstick, method.other_scene};
    for (const Trial& trial : method.trials) {
      series.points.push_back(trial.point);
      if (trial.point.failure.empty() && trial.work) series.points.back().time = timings[next++];
    }
    all.push_back(std::move(series));
  }
  return all;
}

double order_over_work(const Point& coarse, const Point& fine) {
  return std::log(coarse.error / fine.error) / std::log(*fine.operations / *coarse.operations);
}

}  // namespace boxbeam::charts
