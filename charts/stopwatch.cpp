#include "charts/stopwatch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace boxbeam::charts {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_of(const std::function<void()>& work, std::size_t times) {
  const Clock::time_point begin = Clock::now();
  for (std::size_t i = 0; i < times; ++i) work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// How often a work is to be done to take so long; it is done a few times for that.
std::size_t repetitions_for(const std::function<void()>& work, double batch) {
  std::size_t times = 1;
  for (;;) {
    const double taken = seconds_of(work, times);
    if (taken >= 0.5 * batch) {
      const double wanted = std::ceil(static_cast<double>(times) * batch / taken);
      return std::max<std::size_t>(1, static_cast<std::size_t>(wanted));
    }
    times *= 4;
  }
}

}  // namespace

std::vector<Timing> times_of(const std::vector<std::function<void()>>& alternatives,
                             const Effort& effort) {
  std::vector<std::size_t> times;
  for (const auto& work : alternatives)
    times.push_back(effort.once ? 1 : repetitions_for(work, effort.batch()));
  std::vector<std::vector<double>> measured(alternatives.size());
  for (int turn = 0; turn < effort.repetitions(); ++turn) {
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      measured[i].push_back(seconds_of(alternatives[i], times[i]) / static_cast<double>(times[i]));
    }
  }
  std::vector<Timing> timings;
  for (std::vector<double>& of : measured) {
    std::sort(of.begin(), of.end());
    // Quartiles: the longest tells of what else the machine did.
    const std::size_t quarter = of.size() / 4;
    timings.push_back({of[of.size() / 2], of[quarter], of[of.size() - 1 - quarter]});
  }
  return timings;
}

}  // namespace boxbeam::charts
