#pragma once

#include <algorithm>
#include <cmath>

namespace test {

/// EN 1993-1-1, 6.3.1.2; alpha of curve a 0.21, of c 0.49, of d 0.76.
inline double chi_of(double lambda, double alpha = 0.49) {
  const double phi = 0.5 * (1.0 + alpha * (lambda - 0.2) + lambda * lambda);
  return std::min(1.0, 1.0 / (phi + std::sqrt(phi * phi - lambda * lambda)));
}

}  // namespace test
