#pragma once

#include <algorithm>
#include <cmath>

namespace boxbeam {

/// Largest and smallest value over the instants.
struct Span {
  double low = 1e300, high = -1e300;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double range() const { return high - low; }
  double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

}  // namespace boxbeam
