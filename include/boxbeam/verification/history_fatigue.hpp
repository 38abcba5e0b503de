#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "boxbeam/fatigue/spectrum.hpp"
#include "boxbeam/project/named_resistance.hpp"
#include "boxbeam/project/stress_history.hpp"

namespace boxbeam {

/// A stress history to be judged by itself.
struct HistoryDemand {
  StressHistorySource source;
  CountingRule rule;
  NamedResistance direct;                ///< of the normal stress
  std::optional<NamedResistance> shear;  ///< of the shear stress, where the history has one
  /// Of the plate, for the limit of a range, 1.5 f_y; nothing: not known.
  std::optional<Stress> yield_strength;
  FatigueDemand demand;
  bool compression_reduced = false;  ///< EN 1993-1-9, 7.2.1; of the normal stress
  double repetitions = 1.0;          ///< of the history in the wanted life
};

/// What one stress of the history does in the wanted life.
struct ChannelFatigue {
  NamedResistance resistance;
  std::vector<SpectrumBin> spectrum;  ///< largest range first
  bool binned = false;                ///< its rows are bins, not sizes
  double cycles = 0.0;
  Stress largest;
  double damage = 0.0;
  double damage_limit = 1.0;  ///< of its code; 1 where all its ranges have one size
  Stress equivalent_range;    ///< of 2e6 cycles with the same damage
  /// What the largest range may be, 1.5 f_y or 1.5 f_y/sqrt(3); nothing where f_y is not known.
  /// Source: EN 1993-1-9:2005, 8(1), equation 8.1.
  std::optional<Stress> range_limit;
  double fewest_endured = 0.0;  ///< cycles to failure of the largest range; infinity: no damage

  /// `gamma_Ff`: on the range.
  bool range_passes(double gamma_Ff) const {
    return !range_limit || gamma_Ff * largest <= *range_limit;
  }
};

struct HistoryFatigue {
  StressHistory history;
  ChannelFatigue direct;
  std::optional<ChannelFatigue> shear;
  double damage = 0.0;         ///< of both; EN 1993-1-9, 8(2) and 8(3)
  double use = 0.0;            ///< of both, each by its limit
  std::optional<double> life;  ///< repetitions of the history to a use of 1; nothing: no damage
  bool ranges_pass = true;     ///< none is above its limit, or the limits are not known

  bool passes() const { return use <= 1.0 && ranges_pass; }
};

/// Counts a history and sums its damage, in one pass and with constant memory. `progress` is told
/// the number of samples read. Throws InputError: the file, or shear stress without a curve.
HistoryFatigue fatigue_of_history(const HistoryDemand& demand,
                                  const std::function<void(std::uint64_t)>& progress = {});

}  // namespace boxbeam
