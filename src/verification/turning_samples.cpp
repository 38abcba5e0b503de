#include "boxbeam/verification/turning_samples.hpp"

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
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double noise = noise_between(*low, *high);
  found.turns.clear();
  found.highest = static_cast<std::size_t>(high - values.begin());
  if (!(*high - *low > noise)) return;

  // From the highest sample once round.
  std::vector<TurningSample>& turns = found.turns;
  turns.push_back({found.highest, true});
  std::size_t candidate = found.highest;
  bool falling = true;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = found.highest + k < n ? found.highest + k : found.highest + k - n;
    const double towards = falling ? values[candidate] - values[i] : values[i] - values[candidate];
    if (towards > 0.0) {
      candidate = i;
    } else if (towards < -noise) {
      turns.push_back({candidate, !falling});
      falling = !falling;
      candidate = i;
    }
  }
  // Once round they ascend but where it begins anew.
  const auto first = std::is_sorted_until(
      turns.begin(), turns.end(),
      [](const TurningSample& a, const TurningSample& b) { return a.index < b.index; });
  std::rotate(turns.begin(), first, turns.end());
}

}  // namespace boxbeam
