#include "channel_life.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "check_sources.hpp"

namespace boxbeam {
namespace {

/// A spectrum of many sizes in classes: each has the range of its largest cycle, and the life that
/// all of its cycles together take.
std::vector<SpectrumRow> in_classes(std::vector<SpectrumRow> spectrum) {
  constexpr std::size_t most_sizes = 1000, classes = 1000;
  if (spectrum.size() <= most_sizes) return spectrum;
  double largest = 0.0;
  for (const SpectrumRow& row : spectrum) largest = std::max(largest, row.cycle.range.value());
  std::map<std::tuple<std::string, StressKind, std::size_t>, SpectrumRow> merged;
  for (const SpectrumRow& row : spectrum) {
    const double part = std::ceil(row.cycle.range.value() / largest * classes);
    SpectrumRow& of = merged[{row.situation, row.kind, static_cast<std::size_t>(part)}];
    const double count = of.cycle.count + row.cycle.count;
    if (!(count > 0.0)) continue;
    // Sums of life first, the cycles endured behind the loop.
    of.situation = row.situation;
    of.kind = row.kind;
    of.endured += row.cycle.count / row.endured;
    of.damage += row.damage;
    of.cycle.mean += row.cycle.count / count * (row.cycle.mean - of.cycle.mean);
    of.cycle.range = std::max(of.cycle.range, row.cycle.range);
    of.cycle.count = count;
  }
  std::vector<SpectrumRow> rows;
  for (auto& [key, row] : merged) {
    if (!(row.cycle.count > 0.0)) continue;
    row.endured = row.cycle.count / row.endured;
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Channels prepared for many evaluations.
class PreparedChannels {
 public:
  explicit PreparedChannels(const std::vector<LifeChannel>& channels) {
    cycles_.reserve(channels.size());
    lines_.reserve(channels.size());
    loads_.reserve(channels.size());
    for (const LifeChannel& channel : channels) {
      std::vector<Cycle>& cycles = cycles_.emplace_back();
      cycles.reserve(channel.spectrum.size());
      for (const SpectrumRow& row : channel.spectrum) cycles.push_back(row.cycle);
      loads_.push_back({cycles, &lines_.emplace_back(channel.curve)});
    }
  }
  PreparedChannels(const PreparedChannels&) = delete;
  PreparedChannels& operator=(const PreparedChannels&) = delete;

  std::span<const FatigueLoad> loads() const { return loads_; }

 private:
  std::vector<std::vector<Cycle>> cycles_;
  std::vector<SnLine> lines_;
  std::vector<FatigueLoad> loads_;
};

/// The situation whose cycles take the largest part of the life, the loads taken k times, or have
/// the largest range where none does damage; of equal ones the first.
std::size_t governing_situation(const Project& project, const std::vector<LifeChannel>& channels,
                                const PreparedChannels& prepared, double k) {
  if (project.situations.size() == 1) return 0;
  std::unordered_map<std::string_view, std::pair<double, double>> shares;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::vector<double> endured =
        cycles_to_failure_in(prepared.loads()[i], project.fatigue.demand, k);
    for (std::size_t j = 0; j < endured.size(); ++j) {
      const SpectrumRow& row = channels[i].spectrum[j];
      auto& [life, range] = shares[row.situation];
      life += row.cycle.count / endured[j];
      range = std::max(range, row.cycle.range.value());
    }
  }
  std::size_t worst = 0;
  std::pair<double, double> most{-1.0, -1.0};
  for (std::size_t i = 0; i < project.situations.size(); ++i) {
    const auto share = shares.find(project.situations[i].name);
    const auto of = share == shares.end() ? std::pair{0.0, 0.0} : share->second;
    if (of <= most) continue;
    most = of;
    worst = i;
  }
  return worst;
}

/// With the cycles that they endure, the loads taken k times.
std::vector<SpectrumRow> spectrum_at(const Project& project,
                                     const std::vector<LifeChannel>& channels,
                                     const PreparedChannels& prepared, double k) {
  std::vector<SpectrumRow> rows;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto endured_at = [&](double times) {
      return cycles_to_failure_in(prepared.loads()[i], project.fatigue.demand, times);
    };
    const std::vector<double> endured = endured_at(k), as_it_is = endured_at(1.0);
    for (std::size_t j = 0; j < endured.size(); ++j) {
      SpectrumRow& row = rows.emplace_back(channels[i].spectrum[j]);
      row.endured = endured[j];
      row.damage = row.cycle.count / as_it_is[j];
    }
  }
  return rows;
}

}  // namespace

FatigueChannel LifeChannel::for_damage() const {
  FatigueChannel channel{{}, curve};
  for (const SpectrumRow& row : spectrum) channel.cycles.push_back(row.cycle);
  return channel;
}

std::vector<SpectrumRow> rows_of(const std::string& situation, StressKind kind,
                                 const std::vector<Cycle>& cycles) {
  std::vector<SpectrumRow> rows;
  for (const Cycle& cycle : cycles) rows.push_back({situation, kind, cycle});
  return rows;
}

ChannelLife life_of(const Project& project, const std::vector<LifeChannel>& channels) {
  const PreparedChannels prepared(channels);
  ChannelLife life;
  life.factor = largest_factor(prepared.loads(), project.fatigue.demand);
  // Just above the factor, where the life is used up: at it a range may stand below the cut-off.
  life.governing = governing_situation(project, channels, prepared, life.factor * (1.0 + 1e-9));
  return life;
}

void take_life(const Project& project, const std::vector<LifeChannel>& channels,
               const ChannelLife& life, Check& check, CheckBasis& basis) {
  const FatigueDemand& demand = project.fatigue.demand;
  const PreparedChannels prepared(channels);
  check.safety_factor = life.factor;
  check.required = project.fatigue.required;
  for (const LifeChannel& channel : channels) basis.curves.push_back(channel.curve);
  check.source = fatigue_source(project.fatigue, basis.curves);
  for (const FatigueLoad& load : prepared.loads()) basis.damage += damage_of(load, demand);
  if (channels.size() == 1)
    basis.equivalent = equivalent_range(basis.damage, basis.curves.front(), demand);
  basis.spectrum = in_classes(spectrum_at(project, channels, prepared, life.factor));
  FatigueDemand constant = demand;
  constant.loading = Loading::constant_amplitude;
  basis.constant_amplitude_factor = largest_factor(prepared.loads(), constant);
}

}  // namespace boxbeam
