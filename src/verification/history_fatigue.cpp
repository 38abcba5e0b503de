#include "boxbeam/verification/history_fatigue.hpp"

#include <algorithm>
#include <numbers>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// The curves were measured with ranges of one size.
bool one_size(const ChannelFatigue& of) {
  constexpr double same = 1e-6;
  if (of.binned) return false;
  double low = of.largest.value();
  for (const SpectrumBin& bin : of.spectrum) {
    if (bin.count > 0.0) low = std::min(low, bin.range.value());
  }
  return of.largest.value() - low <= same * of.largest.value();
}

/// A stress on its way from samples to damage.
struct Channel {
  SpectrumCollector collector;
  RainflowCounter counter;

  Channel(const HistoryDemand& demand, const SnCurve& curve, bool reduced)
      : collector(curve, demand.demand, reduced),
        counter(demand.rule, [this](const CycleBatch& batch) { collector.add(batch); }) {}
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  ChannelFatigue result(const HistoryDemand& demand, const NamedResistance& resistance) const {
    const SnCurve& curve = resistance.curve;
    ChannelFatigue fatigue;
    fatigue.resistance = resistance;
    fatigue.spectrum = collector.spectrum(demand.repetitions);
    fatigue.binned = collector.binned();
    fatigue.cycles = collector.count() * demand.repetitions;
    fatigue.largest = collector.largest();
    fatigue.damage = collector.damage() * demand.repetitions;
    if (!one_size(fatigue)) fatigue.damage_limit = resistance.damage_limit;
    fatigue.equivalent_range = equivalent_range(fatigue.damage, curve, demand.demand);
    fatigue.fewest_endured =
        cycles_to_failure(scaled(curve, 1.0 / demand.demand.gamma_Mf),
                          demand.demand.gamma_Ff * fatigue.largest, demand.demand.loading);
    if (demand.yield_strength) {
      const double share = curve.kind == StressKind::direct ? 1.0 : 1.0 / std::numbers::sqrt3;
      fatigue.range_limit = 1.5 * share * *demand.yield_strength;
    }
    return fatigue;
  }
};

}  // namespace

HistoryFatigue fatigue_of_history(const HistoryDemand& demand,
                                  const std::function<void(std::uint64_t)>& progress) {
  Channel direct(demand, demand.direct.curve, demand.compression_reduced);
  std::optional<Channel> shear;
  if (demand.shear) shear.emplace(demand, demand.shear->curve, false);
  HistoryFatigue result;
  std::uint64_t read = 0;
  result.history = read_stress_history(demand.source, [&](const StressSamples& samples) {
    if (!samples.shear.empty() && !shear) {
      throw InputError("the history has a shear stress, and no detail resists it",
                       "add --shear-detail 80 (or 100)");
    }
    direct.counter.push(samples.normal);
    if (shear) shear->counter.push(samples.shear);
    read += samples.normal.size();
    if (progress) progress(read);
  });
  direct.counter.finish();
  result.direct = direct.result(demand, demand.direct);
  result.damage = result.direct.damage;
  result.use = result.direct.damage / result.direct.damage_limit;
  if (shear && result.history.has_shear) {
    shear->counter.finish();
    result.shear = shear->result(demand, *demand.shear);
    result.damage += result.shear->damage;
    result.use += result.shear->damage / result.shear->damage_limit;
  }
  result.ranges_pass = result.direct.range_passes(demand.demand.gamma_Ff) &&
                       (!result.shear || result.shear->range_passes(demand.demand.gamma_Ff));
  if (result.use > 0.0) result.life = demand.repetitions / result.use;
  return result;
}

}  // namespace boxbeam
