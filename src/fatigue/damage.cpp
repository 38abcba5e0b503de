#include "boxbeam/fatigue/damage.hpp"

#include <algorithm>
#include <limits>

namespace boxbeam {

namespace {

Stress largest_range_of(const std::vector<Cycle>& cycles) {
  Stress largest;
  for (const Cycle& cycle : cycles) largest = std::max(largest, cycle.range);
  return largest;
}

}  // namespace

double cycles_to_failure_in(const std::vector<Cycle>& cycles, const Cycle& cycle,
                            const SnCurve& curve, const FatigueDemand& demand, double factor) {
  const double scale = demand.gamma_Ff * demand.gamma_Mf * factor;
  const bool limit_exceeded = scale * largest_range_of(cycles) > knee_of(curve);
  return cycles_to_failure(curve, scale * cycle.range,
                           limit_exceeded ? Loading::spectrum : demand.loading);
}

double damage_of(const std::vector<Cycle>& cycles, const SnCurve& curve,
                 const FatigueDemand& demand, double factor) {
  double damage = 0.0;
  for (const Cycle& cycle : cycles) {
    damage +=
        cycle.count * demand.periods / cycles_to_failure_in(cycles, cycle, curve, demand, factor);
  }
  return damage;
}

double largest_factor(const std::vector<Cycle>& cycles, const SnCurve& curve,
                      const FatigueDemand& demand) {
  const Stress largest = largest_range_of(cycles);
  if (largest.value() <= 0.0) return std::numeric_limits<double>::infinity();

  const auto single = [&](double count) {
    return strength_at(curve, count * demand.periods, demand.loading) /
           (demand.gamma_Ff * demand.gamma_Mf * largest);
  };
  if (cycles.size() == 1) return single(cycles.front().count);

  // Damage grows with the factor (and jumps where a range passes the cut-off): bisect for the
  // last factor with damage <= 1. As many cycles of the largest range as there are cycles at all
  // bound it below.
  double count = 0.0;
  for (const Cycle& cycle : cycles) count += cycle.count;
  double low = single(count);
  double high = 2.0 * low;
  while (damage_of(cycles, curve, demand, high) <= 1.0) high *= 2.0;
  while (high - low > 1e-15 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (damage_of(cycles, curve, demand, middle) <= 1.0 ? low : high) = middle;
  }
  return low;
}

}  // namespace boxbeam
