#include "boxbeam/project/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/code_points.hpp"
#include "csv_text.hpp"

namespace boxbeam {
namespace {

struct Unit {
  const char* symbol;
  double factor;
  DimensionExponents exponents;
  bool prefixes;  ///< whether k, M, m ... may stand before it
};

constexpr double degree = std::numbers::pi / 180.0;
constexpr Unit units_known[] = {
    {"m", 1.0, {1, 0, 0, 0}, true},     {"g", 1e-3, {0, 1, 0, 0}, true},
    {"t", 1e3, {0, 1, 0, 0}, false},    {"s", 1.0, {0, 0, 1, 0}, true},
    {"min", 60.0, {0, 0, 1, 0}, false}, {"h", 3600.0, {0, 0, 1, 0}, false},
    {"rad", 1.0, {0, 0, 0, 1}, true},   {"deg", degree, {0, 0, 0, 1}, false},
    {"Hz", 1.0, {0, 0, -1, 0}, true},   {"rpm", full_turn / 60.0, {0, 0, -1, 1}, false},
    {"N", 1.0, {1, 1, -2, 0}, true},    {"Pa", 1.0, {-1, 1, -2, 0}, true},
    {"bar", 1e5, {-1, 1, -2, 0}, true}, {"J", 1.0, {2, 1, -2, 0}, true},
    {"W", 1.0, {2, 1, -3, 0}, true},    {"K", 1.0, {0, 0, 0, 0, 1}, false},
};

struct Prefix {
  const char* symbol;
  double factor;
};
constexpr Prefix prefixes_known[] = {{"n", 1e-9}, {"u", 1e-6}, {"µ", 1e-6}, {"m", 1e-3},
                                     {"c", 1e-2}, {"k", 1e3},  {"M", 1e6},  {"G", 1e9}};

std::optional<Unit> find_unit(std::string_view word) {
  for (const Unit& unit : units_known) {
    if (word == unit.symbol) return unit;
  }
  for (const Prefix& prefix : prefixes_known) {
    const std::string_view symbol = prefix.symbol;
    if (!word.starts_with(symbol)) continue;
    for (const Unit& unit : units_known) {
      if (unit.prefixes && word.substr(symbol.size()) == unit.symbol) {
        return Unit{unit.symbol, unit.factor * prefix.factor, unit.exponents, false};
      }
    }
  }
  return std::nullopt;
}

/// Reads the unit part of a quantity, from left to right.
class UnitScanner {
 public:
  explicit UnitScanner(std::string_view text) : text_(text) {}

  std::optional<std::string> scan(ParsedQuantity& quantity) {
    bool divide = false;
    bool any = false;
    if (text_.starts_with(" 1/")) at_ = 2;  // "1.2e-5 1/K"
    while (skip_separators(divide)) {
      const std::string_view word = take_word();
      if (word.empty()) return fmt::format("\"{}\" cannot be read as a unit", text_.substr(at_));
      const std::optional<Unit> unit = find_unit(word);
      if (!unit) return fmt::format("\"{}\" is not a unit known here", word);
      int exponent = 1;
      if (auto trouble = take_exponent(exponent)) return trouble;
      if (divide) exponent = -exponent;
      quantity.value *= std::pow(unit->factor, exponent);
      quantity.exponents.length += exponent * unit->exponents.length;
      quantity.exponents.mass += exponent * unit->exponents.mass;
      quantity.exponents.time += exponent * unit->exponents.time;
      quantity.exponents.angle += exponent * unit->exponents.angle;
      quantity.exponents.temperature += exponent * unit->exponents.temperature;
      any = true;
    }
    if (divide && !any) return std::string("a unit is missing");
    return std::nullopt;
  }

 private:
  bool take(std::string_view token) {
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  /// Spaces, product signs and one "/"; false at the end of the text.
  bool skip_separators(bool& divide) {
    while (at_ < text_.size()) {
      if (take("/")) {
        divide = true;
      } else if (!take(" ") && !take("*") && !take("·") && !take("\u00a0")) {
        return true;
      }
    }
    return false;
  }

  std::string_view take_word() {
    const std::size_t from = at_;
    while (at_ < text_.size()) {
      const auto c = static_cast<unsigned char>(text_[at_]);
      if (!std::isalpha(c) && !text_.substr(at_).starts_with("µ")) break;
      at_ += std::isalpha(c) ? 1 : std::string_view("µ").size();
    }
    return text_.substr(from, at_ - from);
  }

  std::optional<std::string> take_exponent(int& exponent) {
    if (take("²")) {
      exponent = 2;
    } else if (take("³")) {
      exponent = 3;
    } else if (take("^")) {
      const auto [end, error] =
          std::from_chars(text_.data() + at_, text_.data() + text_.size(), exponent);
      if (error != std::errc{} || exponent < -9 || exponent > 9 || exponent == 0) {
        return std::string("behind \"^\" a whole number from -9 to 9 is wanted");
      }
      at_ = static_cast<std::size_t>(end - text_.data());
    }
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Levenshtein's distance in which two neighbours that changed places count as one edit.
std::size_t edit_distance(std::string_view word, std::string_view candidate) {
  std::vector<std::size_t> before_last, last, row(candidate.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= word.size(); ++i) {
    before_last = std::move(last);
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= candidate.size(); ++j) {
      const std::size_t change = last[j - 1] + (word[i - 1] == candidate[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped =
          i > 1 && j > 1 && word[i - 1] == candidate[j - 2] && word[i - 2] == candidate[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::variant<ParsedQuantity, std::string> parse_quantity(std::string_view text) {
  std::string_view rest = trimmed(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  ParsedQuantity quantity;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), quantity.value);
  if (error == std::errc::result_out_of_range) return std::string("the number is out of range");
  if (error != std::errc{}) {
    if (std::string trouble = look_alike_sign_in(rest.substr(0, 4)); !trouble.empty())
      return trouble;
    return fmt::format("\"{}\" does not begin with a number", text);
  }
  if (!std::isfinite(quantity.value)) return std::string("the number must be finite");
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (rest.starts_with(',')) return std::string("the decimal sign is a point, not a comma");
  if (auto trouble = UnitScanner(rest).scan(quantity)) return *trouble;
  if (!std::isfinite(quantity.value)) return std::string("the number must be finite");
  return quantity;
}

std::string name_of(const DimensionExponents& exponents) {
  static constexpr const WantedDimension* named[] = {&wanted::length,
                                                     &wanted::area,
                                                     &wanted::mass,
                                                     &wanted::angle,
                                                     &wanted::frequency,
                                                     &wanted::angular_frequency,
                                                     &wanted::velocity,
                                                     &wanted::acceleration,
                                                     &wanted::force,
                                                     &wanted::moment,
                                                     &wanted::stiffness,
                                                     &wanted::damping,
                                                     &wanted::torsional_stiffness,
                                                     &wanted::torsional_damping,
                                                     &wanted::stress,
                                                     &wanted::line_mass,
                                                     &wanted::bending_stiffness,
                                                     &wanted::density,
                                                     &wanted::inertia,
                                                     &wanted::time,
                                                     &wanted::temperature,
                                                     &wanted::temperature_gradient,
                                                     &wanted::expansion,
                                                     &wanted::pure_number,
                                                     &wanted::volume};
  for (const WantedDimension* known : named) {
    if (known->exponents == exponents) return known->name;
  }
  std::string text = "something in";
  const auto add = [&](const char* unit, int exponent) {
    if (exponent == 1)
      text += fmt::format(" {}", unit);
    else if (exponent != 0)
      text += fmt::format(" {}^{}", unit, exponent);
  };
  add("kg", exponents.mass);
  add("m", exponents.length);
  add("s", exponents.time);
  add("rad", exponents.angle);
  add("K", exponents.temperature);
  return text;
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  std::string best;
  std::pair best_distance(std::max<std::size_t>(1, word.size() / 3) + 1, std::size_t{0});
  if (word.size() > 100) return best;
  const std::string small = small_letters(word);
  for (const std::string& candidate : known) {
    // So many edits the lengths alone take.
    const std::size_t a = word.size(), b = candidate.size();
    if (std::max(a, b) - std::min(a, b) > best_distance.first) continue;
    const std::pair distance(edit_distance(small, small_letters(candidate)),
                             edit_distance(word, candidate));
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string look_alike_sign_in(std::string_view text) {
  struct Sign {
    std::string_view sign;
    const char* name;
  };
  static constexpr Sign signs[] = {{"\u2212", "the minus sign U+2212"},
                                   {"\u2013", "the dash U+2013"},
                                   {"\u2014", "the dash U+2014"},
                                   {"\u2010", "the hyphen U+2010"},
                                   {"\u2011", "the hyphen U+2011"}};
  for (const Sign& sign : signs) {
    const std::size_t at = text.find(sign.sign);
    if (at == std::string_view::npos) continue;
    const std::string_view rest = text.substr(at + sign.sign.size());
    if (rest.empty() ||
        std::string_view("0123456789. \"'").find(rest.front()) == std::string_view::npos)
      continue;
    return fmt::format("{} stands there; write the minus of the keyboard, -", sign.name);
  }
  return "";
}

}  // namespace boxbeam
