#include "boxbeam/verification/turning_samples.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

/// The turns among some samples behind the furthest one in the sense in which they go; returns that
/// one of the last sense.
TurningSample follow(const double* values, std::size_t from, std::size_t to, double noise,
                     TurningSample furthest, std::vector<TurningSample>& turns) {
  auto [candidate, rises] = furthest;
  double best = values[candidate];
  for (std::size_t i = from; i < to; ++i) {
    const std::size_t start = i;
    if (rises)
      while (i < to && values[i] > best) best = values[i++];
    else
      while (i < to && values[i] < best) best = values[i++];
    if (i > start) candidate = i - 1;
    if (i == to || !(std::abs(values[i] - best) > noise)) continue;
    turns.push_back({candidate, rises});
    rises = !rises;
    candidate = i;
    best = values[i];
  }
  return {candidate, rises};
}

}  // namespace

double noise_between(double lowest, double highest) {
  return 1e-9 * std::max(std::abs(lowest), std::abs(highest));
}

TurningSamples turning_samples_of(const std::vector<double>& values) {
  TurningSamples found;
  find_turning_samples(values, found);
  return found;
}

void find_turning_samples(const std::vector<double>& values, TurningSamples& found) {
  const std::size_t n = values.size();
  const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(n));
  const double low = all.minCoeff(), high = all.maxCoeff();
  const double noise = noise_between(low, high);
  found.turns.clear();
  found.highest = n - 1;
  while (found.highest > 0 && values[found.highest] < high) --found.highest;
  if (!(high - low > noise)) return;

  // From the highest sample once round: on while they fall, or rise, to the one behind which they
  // come back by more than the noise.
  std::vector<TurningSample>& turns = found.turns;
  turns.push_back({found.highest, true});
  TurningSample last{found.highest, false};
  last = follow(values.data(), found.highest + 1, n, noise, last, turns);
  follow(values.data(), 0, found.highest + 1, noise, last, turns);
  // Once round they ascend but where it begins anew.
  const auto first = std::is_sorted_until(
      turns.begin(), turns.end(),
      [](const TurningSample& a, const TurningSample& b) { return a.index < b.index; });
  std::rotate(turns.begin(), first, turns.end());
}

}  // namespace boxbeam
