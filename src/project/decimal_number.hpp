#pragma once

#include <array>
#include <cstdint>

namespace boxbeam {

/// Reads a short decimal number, "-12.345" or "1.2e3", exactly rounded; returns its end, nullptr
/// where the text begins with no number or with one that is not short. `text` ends with a character
/// that belongs to no number; a digit as `decimal_sign` is none.
///
/// Short: digits that are a whole number up to 2^53 without the point, and a power of ten up to 22,
/// so that both are doubles and one multiplication or division rounds once.
/// Source: Clinger, How to read floating point numbers accurately (1990).
inline const char* parse_short_decimal(const char* text, char decimal_sign, double& value) {
  static constexpr std::array<double, 23> powers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  constexpr std::int64_t most_digits = 18;  // they fit into 64 bits
  constexpr std::int64_t largest_power = 22;
  const char* at = text;
  std::uint64_t digits = 0;
  const auto take_digits = [&] {
    const char* const from = at;
    for (; static_cast<unsigned char>(*at - '0') < 10; ++at) {
      digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
    }
    return at - from;
  };

  const bool negative = *at == '-';
  if (negative || *at == '+') ++at;
  std::int64_t count = take_digits();
  std::int64_t power = 0;
  if (*at == decimal_sign) {
    ++at;
    power = -take_digits();
    count -= power;
  }
  if (count == 0 || count > most_digits || digits > (std::uint64_t{1} << 53U)) return nullptr;
  if (*at == 'e' || *at == 'E') {
    ++at;
    const bool divides = *at == '-';
    if (divides || *at == '+') ++at;
    std::int64_t exponent = 0;
    const char* const from = at;
    for (; static_cast<unsigned char>(*at - '0') < 10 && at - from < 4; ++at) {
      exponent = 10 * exponent + (*at - '0');
    }
    if (at == from || at - from == 4) return nullptr;
    power += divides ? -exponent : exponent;
  }
  if (power < -largest_power || power > largest_power) return nullptr;
  const auto whole = static_cast<double>(digits);
  const double size = power < 0 ? whole / powers[static_cast<std::size_t>(-power)]
                                : whole * powers[static_cast<std::size_t>(power)];
  value = negative ? -size : size;
  return at;
}

}  // namespace boxbeam
