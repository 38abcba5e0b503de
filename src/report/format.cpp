#include "boxbeam/report/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace boxbeam::text {

std::string significant(double value, int digits) {
  if (value == 0.0 || std::abs(value) < 1e-12) return "0";
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (magnitude > 9 || magnitude < -6) return fmt::format("{:.{}e}", value, digits - 1);
  const int decimals = std::max(0, digits - 1 - magnitude);
  return fmt::format("{:.{}f}", value, decimals);
}

std::string kN(double newtons) { return significant(newtons * 1e-3) + " kN"; }
std::string kNm(double newton_metres) { return significant(newton_metres * 1e-3) + " kN m"; }
std::string MPa(double pascals) { return significant(pascals * 1e-6) + " MPa"; }
std::string mm(double metres) { return significant(metres * 1e3) + " mm"; }
std::string amount(double value, const std::string& unit) {
  if (unit == "Pa") return MPa(value);
  if (unit == "N") return kN(value);
  if (unit == "m") return mm(value);
  return significant(value);
}

std::string seconds(double time) { return fmt::format("{:.4f} s", time); }
std::string kilograms(double mass) { return fmt::format("{:.0f} kg", mass); }
std::string percent(double fraction) { return significant(fraction * 100.0, 3) + " %"; }

std::string cycles(double count) {
  const double exponent = std::floor(std::log10(count));
  const double mantissa = count / std::pow(10.0, exponent);
  if (exponent < 4) return fmt::format("{:.0f}", count);
  return fmt::format("{:.4g}e{:.0f}", mantissa, exponent);
}

}  // namespace boxbeam::text
