#include "life.hpp"

#include <algorithm>
#include <limits>

#include "instants.hpp"

namespace oracle {

using namespace boxbeam;

std::pair<double, double> Life::extremes(const Histories& histories, std::size_t i) const {
  const Situation& situation = project_.situations[i];
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto take = [&](std::size_t of) {
    if (histories[of].size() == 0) return;
    const auto [lowest, highest] = extremes_of(histories[of]);
    low = std::min(low, lowest);
    high = std::max(high, highest);
  };
  if (situation.between.empty()) take(i);
  for (const std::size_t part : situation.between) take(part);
  return {low, high};
}

double Life::largest_range(const Histories& histories) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < project_.situations.size(); ++i) {
    if (project_.situations[i].cycles == 0.0) continue;
    const auto [low, high] = extremes(histories, i);
    largest = std::max(largest, high - low);
  }
  return largest;
}

std::vector<Cycle> Life::cycles_of(const Histories& histories, bool reduced) const {
  std::vector<Cycle> all;
  for (std::size_t i = 0; i < project_.situations.size(); ++i) {
    const Situation& situation = project_.situations[i];
    if (situation.cycles == 0.0) continue;
    std::vector<Cycle> cycles;
    if (!situation.between.empty() && !situation.in_order) {
      const auto [low, high] = extremes(histories, i);
      cycles = {{si<Stress>(high - low), si<Stress>(0.5 * (high + low)), 1.0}};
    } else {
      std::vector<double> history = histories[i];
      for (const std::size_t part : situation.between) {
        const std::vector<double>& of = histories[part];
        history.insert(history.end(), of.begin(), of.end());
        if (closed(part)) history.push_back(of[0]);
      }
      cycles = count_cycles(history, {Counting::periodic});
    }
    for (Cycle& cycle : cycles) {
      cycle.count *= situation.cycles;
      if (reduced) {
        // 7.2.1: the compressive part counts 60 %.
        const double high = cycle.mean.value() + 0.5 * cycle.range.value();
        const double low = high - cycle.range.value();
        const double tension = std::max(high, 0.0) - std::max(low, 0.0);
        cycle.range = si<Stress>(tension + 0.6 * (high - low - tension));
      }
      all.push_back(cycle);
    }
  }
  return all;
}

bool Life::closed(std::size_t situation) const {
  for (const Run& run : sampled_) {
    if (run.situation == situation) return run.closed;
  }
  return true;
}

}  // namespace oracle
