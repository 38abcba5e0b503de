#include "formula_names.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace boxbeam::report {

std::optional<GreekLetter> greek_letter_of(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, GreekLetter>, 22> letters{{
      {"alpha", {"\\alpha", "α"}}, {"beta", {"\\beta", "β"}},
      {"gamma", {"\\gamma", "γ"}}, {"delta", {"\\delta", "δ"}},
      {"Delta", {"\\Delta", "Δ"}}, {"epsilon", {"\\varepsilon", "ε"}},
      {"eta", {"\\eta", "η"}},     {"theta", {"\\theta", "θ"}},
      {"kappa", {"\\kappa", "κ"}}, {"lambda", {"\\lambda", "λ"}},
      {"mu", {"\\mu", "μ"}},       {"nu", {"\\nu", "ν"}},
      {"xi", {"\\xi", "ξ"}},       {"pi", {"\\pi", "π"}},
      {"rho", {"\\rho", "ρ"}},     {"sigma", {"\\sigma", "σ"}},
      {"tau", {"\\tau", "τ"}},     {"phi", {"\\varphi", "φ"}},
      {"chi", {"\\chi", "χ"}},     {"psi", {"\\psi", "ψ"}},
      {"omega", {"\\omega", "ω"}}, {"Omega", {"\\Omega", "Ω"}},
  }};
  const auto found = std::find_if(letters.begin(), letters.end(),
                                  [&](const auto& letter) { return letter.first == name; });
  if (found == letters.end()) return std::nullopt;
  return found->second;
}

NumberParts parts_of_number(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return {number, ""};
  std::string exponent = number.substr(e + 1);
  std::erase(exponent, '+');
  // "e+09" is nine.
  const std::size_t first = exponent.starts_with('-') ? 1 : 0;
  while (exponent.size() > first + 1 && exponent[first] == '0') exponent.erase(first, 1);
  return {number.substr(0, e), exponent};
}

std::vector<UnitPart> parts_of_unit(const std::string& unit) {
  std::vector<UnitPart> parts;
  std::size_t begin = 0;
  while (begin < unit.size()) {
    const std::size_t end = std::min(unit.find(' ', begin), unit.size());
    const std::string part = unit.substr(begin, end - begin);
    const std::size_t power = std::min(part.find('^'), part.size());
    parts.push_back({part.substr(0, power), power < part.size() ? part.substr(power + 1) : ""});
    begin = end + 1;
  }
  return parts;
}

std::vector<std::string> parts_of_index(const std::string& index) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= index.size()) {
    const std::size_t end = std::min(index.find(',', begin), index.size());
    parts.push_back(index.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::optional<char> differential_of(std::string_view name) {
  if (name.size() != 2 || name[0] != 'd' || name[1] < 'a' || name[1] > 'z') return std::nullopt;
  return name[1];
}

}  // namespace boxbeam::report
