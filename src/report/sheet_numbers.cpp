#include "sheet_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "boxbeam/report/format.hpp"

namespace boxbeam::report {
namespace {

/// Decimals with which a value has so many significant digits.
int decimals_for(double value, int digits) {
  if (value == 0.0) return 0;
  return digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// Decimals for four digits of a sum, but at most seven of its largest term.
int decimals_of(const std::vector<double>& terms, double sum) {
  double largest = 0.0;
  for (const double value : terms) largest = std::max(largest, std::abs(value));
  if (largest == 0.0) return 0;
  // Of a sum of zero the round-off is no number worth four digits.
  const bool nothing = std::abs(sum) < 1e-9 * largest;
  const int wanted = decimals_for(nothing ? largest : sum, 4);
  return std::max(0, std::min(wanted, decimals_for(largest, 7)));
}

/// Round-off of a stress of zero is zero.
double in_MPa(double pascals) {
  constexpr double round_off = 1e-3;
  return std::abs(pascals) < round_off ? 0.0 : pascals * 1e-6;
}

std::string with_decimals(double value, int decimals) {
  std::string text = fmt::format("{:.{}f} MPa", value, decimals);
  // A negative number that rounds to zero is no longer negative.
  if (text.find_first_of("123456789") == std::string::npos && text.front() == '-') text.erase(0, 1);
  return text;
}

}  // namespace

void append(Steps& steps, Steps others) {
  steps.insert(steps.end(), std::make_move_iterator(others.begin()),
               std::make_move_iterator(others.end()));
}

std::string term(const std::string& number) {
  return number.starts_with('-') ? "(" + number + ")" : number;
}

std::string scientific(double value, int digits) {
  if (value == 0.0) return "0";
  std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  return fmt::format("{}e{}", text.substr(0, e), exponent);
}

std::string share(double value) {
  constexpr double small = 1e-3;
  return value != 0.0 && std::abs(value) < small ? scientific(value, 4) : text::significant(value);
}

std::string mm2(double m2) {
  // 9999.9999999 has as many digits before the point as 10000.
  const double rounded = std::stod(fmt::format("{:.4e}", m2 * 1e6));
  return text::significant(rounded, 5) + " mm^2";
}

std::string mm3(double m3) { return scientific(m3 * 1e9, 5) + " mm^3"; }
std::string mm4(double m4) { return scientific(m4 * 1e12, 5) + " mm^4"; }

std::string number(double value) {
  const std::string shortest = fmt::format("{:.4g}", value);
  const std::string fixed = fmt::format("{:.2f}", value);
  return std::stod(fixed) == std::stod(shortest) ? fixed : shortest;
}

StressSum sum_of(const std::vector<double>& pascals, const std::vector<bool>& minus) {
  const auto is_minus = [&](std::size_t i) { return !minus.empty() && minus[i]; };
  std::vector<double> stresses;
  double sum = 0.0;
  for (std::size_t i = 0; i < pascals.size(); ++i) {
    stresses.push_back(in_MPa(pascals[i]));
    sum += is_minus(i) ? -stresses.back() : stresses.back();
  }
  const int decimals = decimals_of(stresses, sum);
  StressSum text;
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    const std::string stress = with_decimals(stresses[i], decimals);
    if (text.terms.empty())
      text.terms = (is_minus(i) ? "-" : "") + stress;
    else
      text.terms += (is_minus(i) ? " - " : " + ") + term(stress);
  }
  text.sum = with_decimals(sum, decimals);
  return text;
}

}  // namespace boxbeam::report
