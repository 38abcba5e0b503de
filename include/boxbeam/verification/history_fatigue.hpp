#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "boxbeam/fatigue/spectrum.hpp"
#include "boxbeam/project/stress_history.hpp"

namespace boxbeam {

/// A stress history to be judged by itself.
struct HistoryDemand {
  StressHistorySource source;
  CountingRule rule;
  SnCurve direct;                ///< resists the normal stress
  std::optional<SnCurve> shear;  ///< resists the shear stress, where the history has one
  FatigueDemand demand;
  bool compression_reduced = false;  ///< EN 1993-1-9, 7.2.1; of the normal stress
  double repetitions = 1.0;          ///< of the history in the wanted life
};

/// What one stress of the history does in the wanted life.
struct ChannelFatigue {
  SnCurve curve;
  std::vector<SpectrumBin> spectrum;  ///< largest range first
  bool binned = false;                ///< its rows are bins, not sizes
  double cycles = 0.0;
  Stress largest;
  double damage = 0.0;
  Stress equivalent_range;  ///< of 2e6 cycles with the same damage
};

struct HistoryFatigue {
  StressHistory history;
  ChannelFatigue direct;
  std::optional<ChannelFatigue> shear;
  double damage = 0.0;         ///< of both; EN 1993-1-9, 8(2) and 8(3)
  std::optional<double> life;  ///< repetitions of the history to a damage of 1; nothing: no damage

  bool passes() const { return damage <= 1.0; }
};

/// Counts a history and sums its damage, in one pass and with constant memory. `progress` is told
/// the number of samples read. Throws InputError: the file, or shear stress without a curve.
HistoryFatigue fatigue_of_history(const HistoryDemand& demand,
                                  const std::function<void(std::uint64_t)>& progress = {});

}  // namespace boxbeam
