#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boxbeam/section/cut_forces.hpp"

namespace boxbeam {

/// Between which each cut force of a station lies, over instants: what a stress that is linear in
/// them has at most, whose instants then need no look where even that would not count.
class CutForceHull {
 public:
  struct Bounds {
    double lowest = 0.0, highest = 0.0;

    double size() const { return std::max(std::abs(lowest), std::abs(highest)); }
  };

  void take(const CutForces& cut) {
    for (std::size_t k = 0; k < cut_force::count; ++k) {
      const double value = value_of(cut, static_cast<cut_force::Index>(k));
      lowest_[k] = std::min(lowest_[k], value);
      highest_[k] = std::max(highest_[k], value);
    }
  }

  /// Of what each cut force does by `factors`, those before `first` left out; not a number where a
  /// factor of one that is there is not known. Nothing taken: none.
  Bounds of(const std::array<double, cut_force::count>& factors, std::size_t first = 0) const {
    // Sums of the same products in another order differ by less.
    constexpr double round_off = 1e-12;
    Bounds bounds;
    double size = 0.0;
    for (std::size_t k = first; k < cut_force::count; ++k) {
      if (!(highest_[k] >= lowest_[k]) || (lowest_[k] == 0.0 && highest_[k] == 0.0)) continue;
      const double a = factors[k] * lowest_[k], b = factors[k] * highest_[k];
      if (std::isnan(a) || std::isnan(b))
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
      bounds.lowest += std::min(a, b);
      bounds.highest += std::max(a, b);
      size += std::max(std::abs(a), std::abs(b));
    }
    bounds.lowest -= round_off * size;
    bounds.highest += round_off * size;
    return bounds;
  }

 private:
  static constexpr std::array<double, cut_force::count> all(double value) {
    return {value, value, value, value, value, value};
  }

  std::array<double, cut_force::count> lowest_ = all(std::numeric_limits<double>::infinity());
  std::array<double, cut_force::count> highest_ = all(-std::numeric_limits<double>::infinity());
};

}  // namespace boxbeam
