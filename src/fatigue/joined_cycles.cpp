#include "boxbeam/fatigue/joined_cycles.hpp"

namespace boxbeam {

std::vector<Cycle> joined_cycles(std::vector<Cycle> cycles, Stress range, Stress rise) {
  if (range == Stress{}) return cycles;
  double count = 0.0;
  for (Cycle& cycle : cycles) {
    cycle.range += range;
    count += cycle.count;
  }
  const double more = rise / range - count;
  if (more > 0.0) cycles.push_back({range, Stress{}, more});
  return cycles;
}

}  // namespace boxbeam
