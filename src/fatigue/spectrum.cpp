#include "boxbeam/fatigue/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boxbeam {
namespace {

/// Cycles gathered before equal ones are put together.
constexpr std::size_t most_gathered = 8 * SpectrumCollector::most_sizes;

std::pair<double, double> key_of(const Cycle& cycle) {
  return {cycle.range.value(), cycle.mean.value()};
}

}  // namespace

SpectrumCollector::SpectrumCollector(const SnCurve& curve, const FatigueDemand& demand,
                                     bool compression_reduced)
    : line_(curve),
      demand_(demand),
      compression_reduced_(compression_reduced),
      scale_(demand.gamma_Ff * demand.gamma_Mf) {}

void SpectrumCollector::add(const CycleBatch& batch) {
  for (std::size_t i = 0; i < batch.range.size(); ++i) {
    put(batch.range[i], batch.mean[i], batch.count);
  }
}

void SpectrumCollector::put(double range, double mean, double count) {
  if (compression_reduced_) {
    const std::vector<Cycle> reduced =
        boxbeam::compression_reduced({{si<Stress>(range), si<Stress>(mean), count}});
    range = reduced.front().range.value();
  }
  count_ += count;
  largest_ = std::max(largest_, range);
  const double damage = count / line_.cycles_to_failure(scale_ * range, Loading::spectrum);
  damage_ += damage;
  if (binned_) {
    put_in_bin(range, mean, count, damage);
    return;
  }
  sizes_.push_back({si<Stress>(range), si<Stress>(mean), count});
  if (sizes_.size() < most_gathered) return;
  merge_sizes();
  if (sizes_.size() > most_sizes) change_to_bins();
}

void SpectrumCollector::merge_sizes() {
  std::sort(sizes_.begin(), sizes_.end(),
            [](const Cycle& a, const Cycle& b) { return key_of(a) > key_of(b); });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < sizes_.size(); ++i) {
    if (key_of(sizes_[i]) == key_of(sizes_[kept]))
      sizes_[kept].count += sizes_[i].count;
    else
      sizes_[++kept] = sizes_[i];
  }
  if (!sizes_.empty()) sizes_.resize(kept + 1);
}

void SpectrumCollector::change_to_bins() {
  binned_ = true;
  bins_.assign(most_bins, {});
  for (const Cycle& cycle : sizes_) {
    const double range = cycle.range.value();
    put_in_bin(range, cycle.mean.value(), cycle.count,
               cycle.count / line_.cycles_to_failure(scale_ * range, Loading::spectrum));
  }
  sizes_.clear();
  sizes_.shrink_to_fit();
}

void SpectrumCollector::put_in_bin(double range, double mean, double count, double damage) {
  while (range >= width_ * static_cast<double>(most_bins)) {
    for (std::size_t i = 0; i < most_bins; ++i) {
      const Bin bin = std::exchange(bins_[i], {});
      Bin& into = bins_[i / 2];
      into = {into.count + bin.count, into.range_sum + bin.range_sum, into.mean_sum + bin.mean_sum,
              into.damage + bin.damage, std::max(into.largest, bin.largest)};
    }
    width_ *= 2.0;
  }
  Bin& bin = bins_[static_cast<std::size_t>(range / width_)];
  bin.count += count;
  bin.range_sum += count * range;
  bin.mean_sum += count * mean;
  bin.damage += damage;
  bin.largest = std::max(bin.largest, range);
}

std::vector<SpectrumBin> SpectrumCollector::spectrum(double times) const {
  std::vector<SpectrumBin> spectrum;
  if (binned_) {
    for (auto bin = bins_.rbegin(); bin != bins_.rend(); ++bin) {
      if (bin->count == 0.0) continue;
      spectrum.push_back({si<Stress>(bin->range_sum / bin->count),
                          si<Stress>(bin->mean_sum / bin->count), bin->count * times,
                          bin->damage * times, si<Stress>(bin->largest)});
    }
    return spectrum;
  }
  SpectrumCollector merged = *this;
  merged.merge_sizes();
  if (merged.sizes_.size() > most_sizes) {
    merged.change_to_bins();
    return merged.spectrum(times);
  }
  for (const Cycle& cycle : merged.sizes_) {
    const double endured = line_.cycles_to_failure(scale_ * cycle.range.value(), Loading::spectrum);
    spectrum.push_back(
        {cycle.range, cycle.mean, cycle.count * times, cycle.count * times / endured, cycle.range});
  }
  return spectrum;
}

double SpectrumCollector::damage() const {
  const bool harmless = demand_.loading == Loading::constant_amplitude && line_.limit() > 0.0 &&
                        scale_ * largest_ <= line_.limit();
  return harmless ? 0.0 : damage_;
}

}  // namespace boxbeam
