#include "boxbeam/verification/drawn_samples.hpp"

#include <algorithm>
#include <numeric>

namespace boxbeam {

std::vector<std::size_t> drawn_samples(
    std::size_t n, const std::vector<std::function<double(std::size_t)>>& values) {
  constexpr std::size_t most = 4000;
  std::vector<std::size_t> drawn;
  if (n <= most) {
    drawn.resize(n);
    std::iota(drawn.begin(), drawn.end(), std::size_t{0});
    return drawn;
  }
  const std::size_t stretches = most / (2 * std::max<std::size_t>(1, values.size()));
  drawn = {0, n - 1};
  for (std::size_t k = 0; k < stretches; ++k) {
    const std::size_t from = k * n / stretches, to = (k + 1) * n / stretches;
    for (const auto& value : values) {
      std::size_t low = from, high = from;
      for (std::size_t i = from; i < to; ++i) {
        if (value(i) < value(low)) low = i;
        if (value(i) > value(high)) high = i;
      }
      drawn.push_back(low);
      drawn.push_back(high);
    }
  }
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  return drawn;
}

}  // namespace boxbeam
