#include "file_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "../csv_text.hpp"
#include "boxbeam/core/code_points.hpp"

namespace boxbeam {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Words of other programs for units that are known here.
std::string_view usual_word(std::string_view word) {
  static constexpr std::pair<std::string_view, std::string_view> words[] = {
      {"sec", "s"},         {"second", "s"},       {"seconds", "s"},  {"msec", "ms"},
      {"newton", "N"},      {"newtons", "N"},      {"meter", "m"},    {"meters", "m"},
      {"millimeter", "mm"}, {"millimeters", "mm"}, {"degree", "deg"}, {"degrees", "deg"},
      {"radian", "rad"},    {"radians", "rad"},    {"Nm", "N m"},     {"kNm", "kN m"},
      {"MNm", "MN m"},      {"Nmm", "N mm"},       {"kNmm", "kN mm"}, {"hz", "Hz"}};
  const std::string small = small_letters(word);
  for (const auto& [from, to] : words) {
    // Capitals count in symbols, not in words: "MNm" is no "mNm".
    const bool symbol =
        std::any_of(from.begin(), from.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    if (from == (symbol ? word : std::string_view(small))) return to;
  }
  return word;
}

/// The same unit in the way of `parse_quantity`.
std::string usual_unit(std::string_view unit) {
  std::string usual;
  for (std::size_t at = 0; at < unit.size();) {
    if (is_letter(unit[at])) {
      const std::size_t from = at;
      while (at < unit.size() && is_letter(unit[at])) ++at;
      usual += usual_word(unit.substr(from, at - from));
    } else if (unit.substr(at).starts_with("**")) {
      usual += '^';
      at += 2;
    } else if (unit.substr(at).starts_with("°")) {
      usual += "deg";
      at += std::string_view("°").size();
    } else if (unit[at] == '-' && !usual.empty() && usual.back() != '^') {
      usual += ' ';  // "kN-m"
      ++at;
    } else {
      usual += unit[at++];
    }
  }
  return usual;
}

}  // namespace

std::variant<ParsedQuantity, std::string> parse_file_unit(std::string_view unit) {
  const std::string_view text = trimmed(unit);
  if (text == "-" || text == "1") return ParsedQuantity{1.0, {}};
  if (text.starts_with("1/")) return parse_quantity("1 " + usual_unit(text.substr(1)));
  // A factor is no unit: "10 kN" would be taken for ten.
  if (text.empty() || text.front() == '+' || text.front() == '.' || text.front() == ',' ||
      std::isdigit(static_cast<unsigned char>(text.front())) != 0) {
    return fmt::format("\"{}\" is not a unit known here", text);
  }
  return parse_quantity("1 " + usual_unit(text));
}

std::string_view without_unit_brackets(std::string_view unit) {
  unit = trimmed(unit);
  for (const std::string_view brackets : {"[]", "()"}) {
    if (unit.size() >= 2 && unit.starts_with(brackets.front()) && unit.ends_with(brackets.back())) {
      return trimmed(unit.substr(1, unit.size() - 2));
    }
  }
  return unit;
}

NameWithUnit split_unit(std::string_view text) {
  text = trimmed(text);
  for (const std::string_view brackets : {"[]", "()"}) {
    if (!text.ends_with(brackets.back())) continue;
    const std::size_t open = text.rfind(brackets.front());
    if (open == std::string_view::npos) continue;
    std::string_view name = trimmed(text.substr(0, open));
    // OpenFAST's tools write "RootMyc1_[kN-m]".
    if (name.ends_with('_')) name.remove_suffix(1);
    return {std::string(name), std::string(trimmed(text.substr(open + 1, text.size() - open - 2)))};
  }
  return {std::string(text), {}};
}

}  // namespace boxbeam
