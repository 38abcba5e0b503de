#include "boxbeam/fatigue/damage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/fatigue/reduced_range.hpp"
#include "sn_formulas.hpp"

namespace boxbeam {

namespace {

Stress largest_range_of(const std::vector<Cycle>& cycles) {
  Stress largest;
  for (const Cycle& cycle : cycles) largest = std::max(largest, cycle.range);
  return largest;
}

/// A channel prepared for many evaluations.
struct Prepared {
  const std::vector<Cycle>* cycles;
  SnLine line;
  double largest;  ///< range [Pa]

  double damage(const FatigueDemand& demand, double factor) const {
    const double scale = demand.gamma_Ff * demand.gamma_Mf * factor;
    const Loading loading = scale * largest > line.limit() ? Loading::spectrum : demand.loading;
    double damage = 0.0;
    for (const Cycle& cycle : *cycles) {
      damage += cycle.count / line.cycles_to_failure(scale * cycle.range.value(), loading);
    }
    return damage;
  }
};

Prepared prepare(const std::vector<Cycle>& cycles, const SnCurve& curve) {
  return {&cycles, SnLine(curve), largest_range_of(cycles).value()};
}

double count_of(const std::vector<Cycle>& cycles) {
  double count = 0.0;
  for (const Cycle& cycle : cycles) count += cycle.count;
  return count;
}

double largest_factor_of(const std::vector<Prepared>& channels, const FatigueDemand& demand) {
  // As many cycles of the largest range as there are cycles at all bound the factor of a channel
  // below; a share of the damage for each channel bounds that of all.
  double low = std::numeric_limits<double>::infinity();
  const auto share = static_cast<double>(channels.size());
  for (const Prepared& channel : channels) {
    const double strength =
        channel.line.strength_at(share * count_of(*channel.cycles), demand.loading);
    low = std::min(low, strength / (demand.gamma_Ff * demand.gamma_Mf * channel.largest));
  }
  if (channels.size() == 1 && channels.front().cycles->size() == 1) return low;

  const auto damage = [&](double factor) {
    double sum = 0.0;
    for (const Prepared& channel : channels) sum += channel.damage(demand, factor);
    return sum;
  };
  // Damage grows with the factor, and jumps where a range passes the cut-off: bisect for the last
  // factor with damage <= 1.
  double high = 2.0 * low;
  while (damage(high) <= 1.0) {
    low = high;
    high *= 2.0;
  }
  while (high - low > 1e-15 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (damage(middle) <= 1.0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::vector<double> cycles_to_failure_in(const std::vector<Cycle>& cycles, const SnCurve& curve,
                                         const FatigueDemand& demand, double factor) {
  const double scale = demand.gamma_Ff * demand.gamma_Mf * factor;
  const SnLine line(curve);
  const bool limit_exceeded = scale * largest_range_of(cycles).value() > line.limit();
  const Loading loading = limit_exceeded ? Loading::spectrum : demand.loading;
  std::vector<double> endured;
  endured.reserve(cycles.size());
  for (const Cycle& cycle : cycles)
    endured.push_back(line.cycles_to_failure(scale * cycle.range.value(), loading));
  return endured;
}

double damage_of(const std::vector<Cycle>& cycles, const SnCurve& curve,
                 const FatigueDemand& demand, double factor) {
  return prepare(cycles, curve).damage(demand, factor);
}

double largest_factor(std::span<const FatigueChannel> channels, const FatigueDemand& demand) {
  std::vector<Prepared> prepared;
  for (const FatigueChannel& channel : channels) {
    Prepared ready = prepare(channel.cycles, channel.curve);
    if (ready.largest > 0.0) prepared.push_back(std::move(ready));
  }
  if (prepared.empty()) return std::numeric_limits<double>::infinity();
  return largest_factor_of(prepared, demand);
}

double largest_factor(const std::vector<Cycle>& cycles, const SnCurve& curve,
                      const FatigueDemand& demand) {
  const Prepared ready = prepare(cycles, curve);
  if (ready.largest <= 0.0) return std::numeric_limits<double>::infinity();
  return largest_factor_of({ready}, demand);
}

Stress equivalent_range(double damage, const SnCurve& curve, const FatigueDemand& demand,
                        double cycles) {
  const double m = curve.branches.front().slope;
  return si<Stress>(sn::equivalent_from(curve.reference.value(),
                                        damage * curve.reference_cycles / cycles, m,
                                        demand.gamma_Ff * demand.gamma_Mf));
}

std::vector<Cycle> compression_reduced(std::vector<Cycle> cycles) {
  for (Cycle& cycle : cycles) {
    const double highest = (cycle.mean + 0.5 * cycle.range).value();
    const double lowest = (cycle.mean - 0.5 * cycle.range).value();
    cycle.range = si<Stress>(reduced_range(highest, lowest, highest - lowest));
  }
  return cycles;
}

}  // namespace boxbeam
