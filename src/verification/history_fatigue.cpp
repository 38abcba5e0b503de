#include "boxbeam/verification/history_fatigue.hpp"

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// A stress on its way from samples to damage.
struct Channel {
  SpectrumCollector collector;
  RainflowCounter counter;

  Channel(const HistoryDemand& demand, const SnCurve& curve, bool reduced)
      : collector(curve, demand.demand, reduced),
        counter(demand.rule, [this](const CycleBatch& batch) { collector.add(batch); }) {}
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  ChannelFatigue result(const HistoryDemand& demand, const SnCurve& curve) const {
    ChannelFatigue fatigue;
    fatigue.curve = curve;
    fatigue.spectrum = collector.spectrum(demand.repetitions);
    fatigue.binned = collector.binned();
    fatigue.cycles = collector.count() * demand.repetitions;
    fatigue.largest = collector.largest();
    fatigue.damage = collector.damage() * demand.repetitions;
    fatigue.equivalent_range = equivalent_range(fatigue.damage, curve, demand.demand);
    return fatigue;
  }
};

}  // namespace

HistoryFatigue fatigue_of_history(const HistoryDemand& demand,
                                  const std::function<void(std::uint64_t)>& progress) {
  Channel direct(demand, demand.direct, demand.compression_reduced);
  std::optional<Channel> shear;
  if (demand.shear) shear.emplace(demand, *demand.shear, false);
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
  if (shear && result.history.has_shear) {
    shear->counter.finish();
    result.shear = shear->result(demand, *demand.shear);
    result.damage += result.shear->damage;
  }
  if (result.damage > 0.0) result.life = demand.repetitions / result.damage;
  return result;
}

}  // namespace boxbeam
