#pragma once

#include <cstddef>
#include <vector>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/rainflow.hpp"

namespace boxbeam {

/// Cycles of one size, or of sizes near each other.
struct SpectrumBin {
  Stress range;  ///< mean of its cycles
  Stress mean;   ///< likewise
  double count = 0.0;
  double damage = 0.0;  ///< on the line of a spectrum, partial factors applied
  Stress largest;       ///< range in it
};

/// What a stream of cycles does to a detail; the memory stays the same however many come.
///
/// Damage is summed cycle by cycle and is exact. The spectrum is exact while it has at most
/// `most_sizes` different cycles; beyond, it is sorted into bins of one width by range, each with
/// its own share of the exact damage. The width is a power of two of 1 Pa, the least that gives at
/// most `most_bins`.
class SpectrumCollector {
 public:
  static constexpr std::size_t most_sizes = 1000;
  static constexpr std::size_t most_bins = 64;

  /// `compression_reduced`: EN 1993-1-9, 7.2.1.
  SpectrumCollector(const SnCurve& curve, const FatigueDemand& demand, bool compression_reduced);

  void add(const CycleBatch& batch);

  /// The sizes or bins so far, the largest range first; its cycles `times` as often.
  std::vector<SpectrumBin> spectrum(double times = 1.0) const;
  bool binned() const { return binned_; }
  double count() const { return count_; }
  Stress largest() const { return si<Stress>(largest_); }

  /// Damage so far: of the spectrum's line, or none under constant-amplitude loading while every
  /// range is below the limit.
  double damage() const;

 private:
  struct Bin {
    double count = 0.0, range_sum = 0.0, mean_sum = 0.0, damage = 0.0, largest = 0.0;
  };
  void put(double range, double mean, double count);
  void put_in_bin(double range, double mean, double count, double damage);
  void merge_sizes();
  void change_to_bins();

  SnLine line_;
  FatigueDemand demand_;
  bool compression_reduced_;
  double scale_;  ///< gamma_Ff gamma_Mf
  double damage_ = 0.0, count_ = 0.0, largest_ = 0.0;
  bool binned_ = false;
  std::vector<Cycle> sizes_;  ///< not yet merged
  std::vector<Bin> bins_;
  double width_ = 1.0;  ///< of a bin [Pa]
};

}  // namespace boxbeam
