// Counting of places over all instants of long records.
#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>
#include <span>
#include <thread>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/fatigue/reduced_range.hpp"
#include "mixed_stress.hpp"
#include "whole_life_parts.hpp"

namespace boxbeam {
namespace {

/// Cycles of one stress in classes of a part of an octave.
class RangeClasses {
 public:
  /// `size`: of the stress; ranges far from it have no class of their own.
  explicit RangeClasses(double size)
      : first_((std::bit_cast<std::uint64_t>(size) >> dropped) - below * parts),
        classes_((below + above) * parts) {}

  void add(double range, double mean, double count) {
    const std::uint64_t key = std::bit_cast<std::uint64_t>(range) >> dropped;
    const std::uint64_t index = key > first_ ? key - first_ : 0;
    Class& of = classes_[std::min<std::uint64_t>(index, classes_.size() - 1)];
    of.count += count;
    of.range += count * range;
    of.mean += count * mean;
  }

  std::vector<Cycle> cycles() const {
    std::vector<Cycle> cycles;
    for (const Class& of : classes_) {
      if (of.count == 0.0) continue;
      cycles.push_back({si<Stress>(of.range / of.count), si<Stress>(of.mean / of.count), of.count});
    }
    return cycles;
  }

 private:
  static constexpr unsigned dropped = 44;  ///< bits of a number behind the 8 of its class
  static constexpr std::uint64_t parts = 256, below = 27, above = 13;  ///< octaves
  struct Class {
    double count = 0.0, range = 0.0, mean = 0.0;
  };
  std::uint64_t first_;
  std::vector<Class> classes_;
};
/// Counts one stress over what comes.
class PlaceCounter {
 public:
  PlaceCounter(double size, bool reduced)
      : classes_(size),
        reduced_(reduced),
        counter_({Counting::periodic}, [this](const CycleBatch& batch) { take(batch); }) {}
  PlaceCounter(const PlaceCounter&) = delete;
  PlaceCounter& operator=(const PlaceCounter&) = delete;

  void push(std::span<const double> stresses) { counter_.push(stresses); }
  void finish() { counter_.finish(); }
  std::vector<Cycle> cycles() const { return classes_.cycles(); }
  /// From the lowest to the highest stress.
  const Cycle& outermost() const { return outermost_; }

 private:
  void take(const CycleBatch& batch) {
    for (std::size_t i = 0; i < batch.range.size(); ++i) {
      const double whole = batch.range[i], mean = batch.mean[i];
      if (whole > outermost_.range.value()) outermost_ = {si<Stress>(whole), si<Stress>(mean), 1.0};
      const double range =
          reduced_ ? reduced_range(mean + 0.5 * whole, mean - 0.5 * whole, whole) : whole;
      classes_.add(range, mean, batch.count);
    }
  }

  RangeClasses classes_;
  bool reduced_;
  Cycle outermost_{Stress{}, Stress{}, 1.0};
  RainflowCounter counter_;
};

constexpr std::size_t block = RainflowCounter::block_size;

/// The same cycles in some classes. Damage is of a power between 3 and 5: by that of the higher.
std::vector<Cycle> in_few_classes(const std::vector<Cycle>& cycles) {
  std::vector<Cycle> few;
  constexpr double octave = 1.0 / 16.0;
  double border = 0.0, weight = 0.0;
  for (const Cycle& cycle : cycles) {
    if (few.empty() || cycle.range.value() > border) {
      few.push_back({Stress{}, Stress{}, 0.0});
      border = cycle.range.value() * std::exp2(octave);
      weight = 0.0;
    }
    Cycle& in = few.back();
    weight += cycle.count * std::pow(cycle.range.value(), 5.0);
    in.mean = (in.mean * in.count + cycle.mean * cycle.count) / (in.count + cycle.count);
    in.count += cycle.count;
    in.range = si<Stress>(std::pow(weight / in.count, 0.2));
  }
  return few;
}

}  // namespace

void WholeLife::count(const std::vector<WholePlace>& places) {
  std::vector<Counted> fresh;
  for (const WholePlace& place : places) {
    const double norm = std::sqrt(product(place, place));
    if (!(norm > 0.0) || is_counted(place)) continue;
    const bool twice = std::any_of(fresh.begin(), fresh.end(), [&](const Counted& of) {
      return of.place.compression_reduced == place.compression_reduced &&
             unlikeness(place, norm, of) < 1e-12;
    });
    if (!twice) fresh.push_back({place, norm, {}, {}, {}, {}});
  }
  // Each place by one thread alone: the same however many there are.
  const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
  std::vector<std::vector<Counted*>> shares(std::min(threads, fresh.size()));
  for (std::size_t i = 0; i < fresh.size(); ++i) shares[i % shares.size()].push_back(&fresh[i]);
  {
    std::vector<std::jthread> running;
    for (std::size_t t = 1; t < shares.size(); ++t)
      running.emplace_back([&, t] { count_in_one_thread(shares[t]); });
    if (!shares.empty()) count_in_one_thread(shares.front());
  }
  summary.counted += fresh.size();
  for (Counted& of : fresh) {
    // What the outermost cycle has over the working instants.
    for (std::size_t j = 0; j < of.cycles.size(); ++j) {
      const std::size_t index = of.cycles[j].situation;
      const Situation& situation = project_->situations[index];
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (const Part& part : parts_) {
        const bool own = part.situation == index;
        if (!own && std::find(situation.between.begin(), situation.between.end(), part.situation) ==
                        situation.between.end())
          continue;
        for (std::size_t i = 0; i < part.channels->times.size(); ++i) {
          double stress = of.place.factors[part.first];
          for (std::size_t k = 0; k < part.channels->values.size(); ++k)
            stress += of.place.factors[part.first + 1 + k] * part.channels->values[k][i];
          lowest = std::min(lowest, stress);
          highest = std::max(highest, stress);
        }
      }
      if (of.largest[j] > 0.0) {
        summary.extreme_error =
            std::max(summary.extreme_error, 1.0 - (highest - lowest) / of.largest[j]);
      }
    }
    counted_.push_back(std::move(of));
  }
}

void WholeLife::count_in_one_thread(std::span<Counted*> places) const {
  std::size_t most = 0;
  for (const Part& part : parts_) most = std::max(most, part.record->channels());
  std::vector<double> values(most * block), stresses(block);
  for (std::size_t i = 0; i < project_->situations.size(); ++i) {
    const Situation& situation = project_->situations[i];
    if (situation.cycles == 0.0) continue;
    std::vector<std::size_t> of = situation.between;
    if (of.empty()) of.push_back(i);
    // Of a change: the extremes of its first situation.
    std::vector<std::pair<double, double>> first_extremes;
    std::deque<PlaceCounter> counters;
    for (const Counted* at : places) counters.emplace_back(at->norm, at->place.compression_reduced);
    for (const std::size_t index : of) {
      const auto found = std::find_if(parts_.begin(), parts_.end(),
                                      [&](const Part& part) { return part.situation == index; });
      assert(found != parts_.end());
      const Part& part = *found;
      const auto K = static_cast<std::size_t>(part.centre.size());
      for (std::size_t from = 0; from < part.record->instants(); from += block) {
        const std::size_t count = std::min(block, part.record->instants() - from);
        for (std::size_t k = 0; k < K; ++k)
          part.record->copy(k, from, {values.data() + k * block, count});
        for (std::size_t p = 0; p < places.size(); ++p) {
          const double* const factors = places[p]->place.factors.data() + part.first;
          mix_stress({factors, K + 1}, values.data(), block, {stresses.data(), count});
          counters[p].push({stresses.data(), count});
          if (!situation.is_change() || index != of.front()) continue;
          const auto [low, high] = std::minmax_element(
              stresses.begin(), stresses.begin() + static_cast<std::ptrdiff_t>(count));
          if (p == first_extremes.size()) first_extremes.emplace_back(*low, *high);
          first_extremes[p] = {std::min(first_extremes[p].first, *low),
                               std::max(first_extremes[p].second, *high)};
        }
      }
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
      counters[p].finish();
      std::vector<Cycle> cycles;
      if (situation.is_change()) {
        const auto [low, high] = first_extremes[p];
        cycles = change_cycles(situation, counters[p].outermost(), si<Stress>(0.5 * (low + high)));
        if (places[p]->place.compression_reduced) cycles = compression_reduced(std::move(cycles));
      } else {
        cycles = counters[p].cycles();
        for (Cycle& cycle : cycles) cycle.count *= situation.cycles;
      }
      places[p]->largest.push_back(counters[p].outermost().range.value());
      places[p]->few.push_back({i, in_few_classes(cycles)});
      places[p]->cycles.push_back({i, std::move(cycles)});
    }
  }
}

}  // namespace boxbeam
