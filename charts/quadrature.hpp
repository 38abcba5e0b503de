#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace boxbeam::charts {

/// Gauss-Legendre rule on [0, 1]: exact for polynomials of degree 2 n - 1.
template <class T>
struct GaussRule {
  std::vector<T> x, w;
};

/// By Newton's method on Legendre's polynomial. Source: Davis and Rabinowitz, Methods of Numerical
/// Integration, 2.7.
template <class T>
GaussRule<T> gauss_rule(std::size_t n) {
  GaussRule<T> rule{std::vector<T>(n), std::vector<T>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    T x = std::cos(std::numbers::pi_v<T> * (static_cast<T>(i) + T(0.75)) /
                   (static_cast<T>(n) + T(0.5)));
    T slope = 1;
    for (int step = 0; step < 100; ++step) {
      T before = 1, value = x;
      for (std::size_t k = 2; k <= n; ++k) {
        const T next = (static_cast<T>(2 * k - 1) * x * value - static_cast<T>(k - 1) * before) /
                       static_cast<T>(k);
        before = value;
        value = next;
      }
      slope = static_cast<T>(n) * (x * value - before) / (x * x - 1);
      const T change = value / slope;
      x -= change;
      if (std::abs(change) < T(1e-18)) break;
    }
    rule.x[i] = (1 - x) / 2;
    rule.w[i] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace boxbeam::charts
