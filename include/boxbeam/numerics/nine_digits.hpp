#pragma once

#include <cmath>

namespace boxbeam {

/// A number to 30 bits, some nine digits: the same of two that differ by round-off, but for those
/// few that lie on either side of where it is rounded. What is no finite number stays.
inline double nine_digits(double number) {
  constexpr int bits = 30;
  int exponent = 0;
  const double mantissa = std::frexp(number, &exponent);
  if (!std::isfinite(number)) return number;
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits)), exponent - bits);
}

}  // namespace boxbeam
