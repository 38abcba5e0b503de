#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "boxbeam/report/formula_tree.hpp"

/// A pocket calculator for the formulas of a calculation sheet, with units and with the doubt that
/// rounding leaves: every printed number stands for all that would have been printed so.
namespace test {

/// Powers of N, m, s and kg.
using Dimension = std::array<double, 4>;

struct FormulaValue {
  double low = 0.0, high = 0.0;
  Dimension dimension{};
};

using FormulaValues = std::map<std::string, FormulaValue>;

inline Dimension combined(const Dimension& a, const Dimension& b, double sign) {
  Dimension of{};
  for (std::size_t i = 0; i < of.size(); ++i) of[i] = a[i] + sign * b[i];
  return of;
}

inline bool same_dimension(const Dimension& a, const Dimension& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > 1e-9) return false;
  }
  return true;
}

/// Whether two printed chains can be the same number.
inline bool agree(const FormulaValue& a, const FormulaValue& b) {
  const double slack = 1e-9 * std::max(std::abs(a.high), std::abs(b.high));
  const bool nothing = (a.low == 0.0 && a.high == 0.0) || (b.low == 0.0 && b.high == 0.0);
  return a.low <= b.high + slack && b.low <= a.high + slack &&
         (nothing || same_dimension(a.dimension, b.dimension));
}

inline FormulaValue number_value(const boxbeam::report::FormulaNode& node) {
  FormulaValue value;
  double scale = 1.0;
  std::size_t begin = 0;
  while (begin < node.index.size()) {
    const std::size_t end = std::min(node.index.find(' ', begin), node.index.size());
    const std::string part = node.index.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t hat = std::min(part.find('^'), part.size());
    const double power = hat < part.size() ? std::stod(part.substr(hat + 1)) : 1.0;
    static const std::map<std::string, std::pair<double, Dimension>> units{
        {"kN", {1e3, {1.0}}},
        {"MPa", {1e6, {1.0, -2.0}}},
        {"GPa", {1e9, {1.0, -2.0}}},
        {"mm", {1e-3, {0.0, 1.0}}},
        {"m", {1.0, {0.0, 1.0}}},
        {"s", {1.0, {0.0, 0.0, 1.0}}},
        {"kg", {1.0, {0.0, 0.0, 0.0, 1.0}}},
        {"Hz", {1.0, {0.0, 0.0, -1.0}}},
        {"deg", {std::numbers::pi / 180.0, {}}}};
    const auto& [size, dimension] = units.at(part.substr(0, hat));
    scale *= std::pow(size, power);
    for (std::size_t i = 0; i < dimension.size(); ++i) value.dimension[i] += power * dimension[i];
  }
  const double shown = std::stod(node.text);
  const std::size_t e = std::min(node.text.find('e'), node.text.size());
  const std::string mantissa = node.text.substr(0, e);
  const std::size_t point = mantissa.find('.');
  const double decimals =
      point == std::string::npos ? 0.0 : static_cast<double>(mantissa.size() - point - 1);
  const double exponent = e < node.text.size() ? std::stod(node.text.substr(e + 1)) : 0.0;
  std::string digits = mantissa;
  std::erase(digits, '.');
  digits.erase(0, digits.find_first_not_of('0'));
  // Factors, exponents and angles of few digits are exact; so is a zero.
  const bool exact =
      node.text == "0" || node.index == "deg" || (node.index.empty() && digits.size() <= 3);
  const double doubt = exact ? 0.0 : 0.5 * std::pow(10.0, exponent - decimals);
  value.low = (shown - doubt) * scale;
  value.high = (shown + doubt) * scale;
  return value;
}

/// The value of a formula; nothing where it holds names that are not known, sums or integrals.
inline std::optional<FormulaValue> value_of(const boxbeam::report::FormulaNode& node,
                                            const FormulaValues& known = {}) {
  using Kind = boxbeam::report::FormulaNode::Kind;
  const auto part = [&](std::size_t i) { return value_of(node.parts.at(i), known); };
  const auto product = [](const FormulaValue& a, const FormulaValue& b) {
    const auto [low, high] =
        std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return FormulaValue{low, high, combined(a.dimension, b.dimension, 1.0)};
  };
  const auto inverse = [](const FormulaValue& a) -> std::optional<FormulaValue> {
    if (a.low <= 0.0 && a.high >= 0.0) return std::nullopt;
    return FormulaValue{1.0 / a.high, 1.0 / a.low, combined({}, a.dimension, -1.0)};
  };
  const auto raised = [](const FormulaValue& base, double exponent) -> std::optional<FormulaValue> {
    Dimension dimension = base.dimension;
    for (double& of : dimension) of *= exponent;
    if (base.low < 0.0 && exponent != std::round(exponent)) return std::nullopt;
    const auto [low, high] =
        std::minmax({std::pow(base.low, exponent), std::pow(base.high, exponent)});
    const bool across = base.low < 0.0 && base.high > 0.0 && std::fmod(exponent, 2.0) == 0.0;
    return FormulaValue{across ? 0.0 : low, high, dimension};
  };
  switch (node.kind) {
    case Kind::number: return number_value(node);
    case Kind::name: {
      if (node.text == "pi" && node.index.empty())
        return FormulaValue{std::numbers::pi, std::numbers::pi, {}};
      const auto found = known.find(node.index.empty() ? node.text : node.text + "_" + node.index);
      if (found == known.end()) return std::nullopt;
      return found->second;
    }
    case Kind::product:
    case Kind::times: {
      FormulaValue value{1.0, 1.0, {}};
      for (std::size_t i = 0; i < node.parts.size(); ++i) {
        const auto factor = part(i);
        if (!factor) return std::nullopt;
        value = product(value, *factor);
      }
      return value;
    }
    case Kind::fraction: {
      const auto top = part(0), bottom = part(1);
      const auto of = bottom ? inverse(*bottom) : std::nullopt;
      if (!top || !of) return std::nullopt;
      return product(*top, *of);
    }
    case Kind::sum: {
      std::optional<FormulaValue> value;
      for (std::size_t i = 0; i < node.parts.size(); ++i) {
        const auto of = part(i);
        if (!of) return std::nullopt;
        if (!value) {
          value = of;
          continue;
        }
        const bool zero = of->low == 0.0 && of->high == 0.0;
        if (value->low == 0.0 && value->high == 0.0) value->dimension = of->dimension;
        if (!zero && !same_dimension(value->dimension, of->dimension)) return std::nullopt;
        value->low += of->low;
        value->high += of->high;
      }
      return value;
    }
    case Kind::negative: {
      const auto of = part(0);
      if (!of) return std::nullopt;
      return FormulaValue{-of->high, -of->low, of->dimension};
    }
    case Kind::power: {
      const auto base = part(0), exponent = part(1);
      if (!base || !exponent || exponent->low != exponent->high) return std::nullopt;
      return raised(*base, exponent->low);
    }
    case Kind::group: return part(0);
    case Kind::call: {
      const auto first = part(0);
      if (!first) return std::nullopt;
      const auto on_both = [&](double (*f)(double)) {
        const auto [low, high] = std::minmax({f(first->low), f(first->high)});
        return FormulaValue{low, high, {}};
      };
      if (node.text == "sqrt")
        return raised({std::max(0.0, first->low), first->high, first->dimension}, 0.5);
      if (node.text == "exp") return on_both(std::exp);
      if (node.text == "sin") return on_both(std::sin);
      if (node.text == "cos") return on_both(std::cos);
      if (node.text == "abs") {
        const bool across = first->low < 0.0 && first->high > 0.0;
        const auto [low, high] = std::minmax({std::abs(first->low), std::abs(first->high)});
        return FormulaValue{across ? 0.0 : low, high, first->dimension};
      }
      if (node.text == "max" || node.text == "min") {
        FormulaValue value = *first;
        for (std::size_t i = 1; i < node.parts.size(); ++i) {
          const auto of = part(i);
          if (!of) return std::nullopt;
          const bool largest = node.text == "max";
          value.low = largest ? std::max(value.low, of->low) : std::min(value.low, of->low);
          value.high = largest ? std::max(value.high, of->high) : std::min(value.high, of->high);
        }
        return value;
      }
      return std::nullopt;
    }
    case Kind::derivative:
    case Kind::large:
    case Kind::relation: return std::nullopt;
  }
  return std::nullopt;
}

inline std::optional<FormulaValue> value_of(const std::string& formula,
                                            const FormulaValues& known = {}) {
  const auto tree = boxbeam::report::parse_formula(formula);
  if (!tree) return std::nullopt;
  return value_of(*tree, known);
}

}  // namespace test
