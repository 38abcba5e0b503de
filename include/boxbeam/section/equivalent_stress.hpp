#pragma once

#include <cmath>

namespace boxbeam {

/// Equivalent stress of plane stress with one normal component.
///
///     sigma_v = sqrt(sigma^2 + 3 tau^2)
///
/// Source: von Mises (1913).
template <class Value>
Value equivalent_stress(const Value& sigma, const Value& tau) {
  using std::sqrt;
  return sqrt(sigma * sigma + 3.0 * tau * tau);
}

}  // namespace boxbeam
