#include "boxbeam/verification/turning_samples.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace boxbeam {

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

  // From the highest sample once round.
  std::vector<TurningSample>& turns = found.turns;
  turns.push_back({found.highest, true});
  std::size_t candidate = found.highest;
  double best = high, sense = -1.0;  // while they fall, 1 while they rise
  const auto follow = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const double further = sense * (values[i] - best);
      if (further > 0.0) {
        candidate = i;
        best = values[i];
      } else if (further < -noise) {
        turns.push_back({candidate, sense > 0.0});
        sense = -sense;
        candidate = i;
        best = values[i];
      }
    }
  };
  follow(found.highest + 1, n);
  follow(0, found.highest + 1);
  // Once round they ascend but where it begins anew.
  const auto first = std::is_sorted_until(
      turns.begin(), turns.end(),
      [](const TurningSample& a, const TurningSample& b) { return a.index < b.index; });
  std::rotate(turns.begin(), first, turns.end());
}

}  // namespace boxbeam
