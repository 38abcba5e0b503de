#include "boxbeam/report/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace boxbeam::text {
namespace {

struct Rule {
  Quantity quantity;
  int digits;  ///< significant
  double scale;
  const char* unit;
};

constexpr std::array rules{
    Rule{Quantity::force, 4, 1e-3, "kN"},
    Rule{Quantity::moment, 4, 1e-3, "kN m"},
    Rule{Quantity::stress, 4, 1e-6, "MPa"},
    Rule{Quantity::length, 4, 1e3, "mm"},
    Rule{Quantity::station, 4, 1.0, "m"},
    Rule{Quantity::factor, 3, 1.0, ""},
    Rule{Quantity::utilisation, 3, 1e2, "%"},
    Rule{Quantity::time, 4, 1.0, "s"},
    Rule{Quantity::area, 5, 1e3, "10^3 mm^2"},
    Rule{Quantity::second_moment, 5, 1e6, "10^6 mm^4"},
    Rule{Quantity::section_modulus, 5, 1e6, "10^3 mm^3"},
    Rule{Quantity::mass, 5, 1.0, "kg"},
    Rule{Quantity::inertia, 5, 1.0, "kg m^2"},
    Rule{Quantity::frequency, 4, 1.0, "Hz"},
    Rule{Quantity::ratio, 4, 1.0, ""},
};

const Rule& rule_of(Quantity quantity) {
  const Rule& rule = rules[static_cast<std::size_t>(quantity)];
  assert(rule.quantity == quantity);
  return rule;
}

/// With more digits than the rule says where a utilisation above 1 would read as 100 %.
std::string rounded_use(double percent, int digits) {
  std::string text = significant(percent, digits);
  const auto reads_as_100 = [&] {
    return text == "100" ||
           (text.starts_with("100.") && text.find_first_not_of('0', 4) == std::string::npos);
  };
  while (percent > 100.0 && reads_as_100() && digits < 12) text = significant(percent, ++digits);
  return text;
}

}  // namespace

std::string significant(double value, int digits) {
  if (value == 0.0 || std::abs(value) < 1e-12) return "0";
  int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  // 9.9996 has four digits as 10.00, not as 10.000.
  if (std::abs(value) * std::pow(10.0, digits - 1 - magnitude) >= std::pow(10.0, digits) - 0.5) {
    ++magnitude;
  }
  if (magnitude > 9 || magnitude < -6) return fmt::format("{:.{}e}", value, digits - 1);
  const int decimals = std::max(0, digits - 1 - magnitude);
  return fmt::format("{:.{}f}", value, decimals);
}

std::string rounded(Quantity quantity, double value) {
  const Rule& rule = rule_of(quantity);
  if (quantity == Quantity::time) return fmt::format("{:.{}f}", value, rule.digits);
  if (quantity == Quantity::utilisation) return rounded_use(value * rule.scale, rule.digits);
  return significant(value * rule.scale, rule.digits);
}

const char* unit_of(Quantity quantity) { return rule_of(quantity).unit; }

std::string with_unit(Quantity quantity, double value) {
  std::string text = rounded(quantity, value);
  const char* unit = unit_of(quantity);
  if (*unit != '\0') text += fmt::format(" {}", unit);
  return text;
}

std::string kN(double newtons) { return with_unit(Quantity::force, newtons); }
std::string kNm(double newton_metres) { return with_unit(Quantity::moment, newton_metres); }
std::string MPa(double pascals) { return with_unit(Quantity::stress, pascals); }
std::string mm(double metres) { return with_unit(Quantity::length, metres); }
std::string factor(double value) { return rounded(Quantity::factor, value); }
std::string amount(double value, const std::string& unit) {
  if (unit == "Pa") return MPa(value);
  if (unit == "N") return kN(value);
  if (unit == "m") return mm(value);
  return rounded(Quantity::ratio, value);
}

std::string seconds(double time) { return with_unit(Quantity::time, time); }
std::string kilograms(double mass) { return fmt::format("{:.0f} kg", mass); }
std::string percent(double fraction) { return with_unit(Quantity::utilisation, fraction); }

std::string cycles(double count) {
  if (count < 9999.5) return fmt::format("{:.4g}", count);
  double exponent = std::floor(std::log10(count));
  double mantissa = count / std::pow(10.0, exponent);
  if (mantissa >= 9.9995) {
    mantissa = 1.0;
    exponent += 1.0;
  }
  return fmt::format("{:.4g}e{:.0f}", mantissa, exponent);
}

}  // namespace boxbeam::text
