#pragma once

#include <cstddef>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"

namespace test {

/// Square of the angular frequency of a structure's k-th free vibration, k = 1, 2, ..., by
/// bisection on the count of natural frequencies below.
inline double natural_square(const boxbeam::flexible::Structure& structure, std::size_t k,
                             double guess) {
  const auto count = [&](double square) {
    return boxbeam::flexible::DynamicStiffness<double>(structure, square, 0.0).frequencies_below();
  };
  double low = 0.0, high = guess;
  while (count(high) < k) {
    low = high;
    high *= 2.0;
  }
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    try {
      (count(middle) < k ? low : high) = middle;
    } catch (const boxbeam::AnalysisError&) {
      return middle;  // exactly there
    }
  }
  return 0.5 * (low + high);
}

}  // namespace test
