#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace boxbeam {

/// n Chebyshev points of the second kind, ascending in [-1, 1], and the polynomial of degree n - 1
/// through values at them.
template <std::size_t n>
struct ChebyshevPoints {
  static constexpr std::size_t last = n - 1;

  static double point(std::size_t k) {
    static const auto points = [] {
      std::array<double, n> of;
      for (std::size_t i = 0; i < n; ++i)
        of[i] = -std::cos(std::numbers::pi * static_cast<double>(i) / static_cast<double>(last));
      return of;
    }();
    return points[k];
  }

  /// The place of a point between two ends; exactly the ends, and the middle.
  static double between(double from, double to, std::size_t k) {
    if (k == 0) return from;
    if (k == last) return to;
    const double middle = 0.5 * (from + to);
    return 2 * k == last ? middle : middle + 0.5 * (to - from) * point(k);
  }

  /// What the value at each point counts in the polynomial's value at u, all times `sum`.
  struct Shares {
    std::array<double, n> weights{};
    double sum = 0.0;
  };

  /// Barycentric formula; weights of these points alternate in sign and are halved at the ends.
  /// Source: Berrut and Trefethen, SIAM Review 46 (2004).
  static Shares shares_at(double u) {
    Shares shares;
    for (std::size_t k = 0; k < n; ++k) {
      const double distance = u - point(k);
      if (distance == 0.0) {
        shares = {{}, 1.0};
        shares.weights[k] = 1.0;
        return shares;
      }
      shares.weights[k] = (k % 2 == 0 ? 1.0 : -1.0) / distance;
      if (k == 0 || k == last) shares.weights[k] *= 0.5;
      shares.sum += shares.weights[k];
    }
    return shares;
  }
};

}  // namespace boxbeam
