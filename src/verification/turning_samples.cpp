#include "boxbeam/verification/turning_samples.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

/// So many are looked at at once.
constexpr std::size_t samples_at_once = 8;
using SamplesAtOnce = Eigen::Map<const Eigen::Array<double, samples_at_once, 1>>;

/// How far values go on in one sense (1 rising, -1 falling) from `from` on: the first that is not
/// beyond the one before it.
template <int sense>
std::size_t end_of_run(const double* values, std::size_t from, std::size_t to) {
  std::size_t i = from;
  for (; i + samples_at_once <= to; i += samples_at_once) {
    const SamplesAtOnce at(values + i), before(values + i - 1);
    const double least = sense > 0 ? (at - before).minCoeff() : (before - at).minCoeff();
    if (!(least > 0.0)) break;
  }
  const auto goes_on = [&](std::size_t k) {
    return sense > 0 ? values[k] > values[k - 1] : values[k] < values[k - 1];
  };
  while (i < to && goes_on(i)) ++i;
  return i;
}

/// The extremes of some samples, and the last of the largest.
struct SampleExtremes {
  double low, high;
  std::size_t highest;
};

SampleExtremes extremes_of(const std::vector<double>& values) {
  const std::size_t n = values.size();
  double low = values.front(), high = low;
  std::size_t from = 0, i = 0;  // among the samples from `from` on is the last of the largest
  for (; i + samples_at_once <= n; i += samples_at_once) {
    const SamplesAtOnce at(values.data() + i);
    const double most = at.maxCoeff();
    low = std::min(low, at.minCoeff());
    if (most < high) continue;
    high = most;
    from = i;
  }
  std::size_t highest = std::min(from + samples_at_once, n) - 1;
  while (highest > from && values[highest] < high) --highest;
  for (; i < n; ++i) {
    low = std::min(low, values[i]);
    if (values[i] < high) continue;
    high = values[i];
    highest = i;
  }
  return {low, high, highest};
}

/// The turns among some samples behind the furthest one in the sense in which they go; returns that
/// one of the last sense.
TurningSample follow(const double* values, std::size_t from, std::size_t to, double noise,
                     TurningSample furthest, std::vector<TurningSample>& turns) {
  auto [candidate, rises] = furthest;
  double best = values[candidate];
  for (std::size_t i = from; i < to; ++i) {
    const std::size_t start = i;
    if (rises ? values[i] > best : values[i] < best) {
      i = rises ? end_of_run<1>(values, i + 1, to) : end_of_run<-1>(values, i + 1, to);
      best = values[i - 1];
    }
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
  const auto [low, high, highest] = extremes_of(values);
  const double noise = noise_between(low, high);
  found.turns.clear();
  found.highest = highest;
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
