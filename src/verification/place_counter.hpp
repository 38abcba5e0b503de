#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/fatigue/reduced_range.hpp"

namespace boxbeam {

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

}  // namespace boxbeam
