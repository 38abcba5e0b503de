#pragma once

#include <cstddef>
#include <vector>

/// Where sampled values turn: what rises to a sample and falls behind it, or the other way round.
namespace boxbeam {

struct TurningSample {
  std::size_t index = 0;
  bool maximum = true;

  friend bool operator==(const TurningSample&, const TurningSample&) = default;
};

struct TurningSamples {
  std::size_t highest = 0;           ///< index of the last of the largest
  std::vector<TurningSample> turns;  ///< ascending; none where the values do not change
};

/// Differences of values between these two that are rounding and no change.
double noise_between(double lowest, double highest);

/// The turns of at least one value, whose first follows the last: a history that does not repeat
/// jumps from its end to its begin. A turn counts where the values come back from it by more than
/// the noise.
TurningSamples turning_samples_of(const std::vector<double>& values);
/// The same into what had turns before, whose room is used again.
void find_turning_samples(const std::vector<double>& values, TurningSamples& found);

}  // namespace boxbeam
