#include "boxbeam/study/written_quantity.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "boxbeam/project/quantity_text.hpp"

namespace boxbeam {
namespace {

/// One of a unit in base units; nothing where the text is no unit. A number without unit is 1.
std::optional<ParsedQuantity> one_of(const std::string& unit) {
  const auto parsed = parse_quantity(unit.empty() ? "1" : "1 " + unit);
  if (const auto* quantity = std::get_if<ParsedQuantity>(&parsed)) return *quantity;
  return std::nullopt;
}

}  // namespace

std::optional<WrittenQuantity> quantity_written_in(std::string_view text) {
  WrittenQuantity quantity;
  const char* const end = text.data() + text.size();
  const char* const begin = text.starts_with('+') ? text.data() + 1 : text.data();
  const auto [at, error] = std::from_chars(begin, end, quantity.value);
  if (error != std::errc{} || !std::isfinite(quantity.value)) return std::nullopt;
  std::string_view unit(at, static_cast<std::size_t>(end - at));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  while (unit.ends_with(' ')) unit.remove_suffix(1);
  quantity.unit = std::string(unit);
  if (!one_of(quantity.unit)) return std::nullopt;
  return quantity;
}

std::optional<WrittenQuantity> quantity_written_in(const Node& node) {
  if (node.kind == Node::Kind::number && std::isfinite(node.number))
    return WrittenQuantity{node.number, ""};
  if (node.kind == Node::Kind::text) return quantity_written_in(node.text);
  return std::nullopt;
}

std::string number_text(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end};
}

std::string to_text(const WrittenQuantity& quantity) {
  const std::string number = number_text(quantity.value);
  return quantity.unit.empty() ? number : number + " " + quantity.unit;
}

std::optional<double> ratio_of_units(const std::string& unit, const std::string& other) {
  const std::optional<ParsedQuantity> a = one_of(unit), b = one_of(other);
  if (!a || !b || a->exponents != b->exponents) return std::nullopt;
  return b->value / a->value;
}

}  // namespace boxbeam
