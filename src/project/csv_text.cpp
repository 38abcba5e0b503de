#include "csv_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "text_file.hpp"

namespace boxbeam {

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t") + 1 - from);
}

std::vector<Field> fields_of(std::string_view line, char separator) {
  std::vector<Field> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(separator, from), line.size());
    const std::size_t text = std::min(line.find_first_not_of(" \t", from), to);
    fields.push_back({trimmed(line.substr(from, to - from)), position_of(line, text).column});
    from = to + 1;
  }
  return fields;
}

namespace {

/// What stands in the brackets at the end of a column's name, "[" where there are none.
std::string_view bracketed(std::string_view name) {
  const std::size_t open = name.find('[');
  if (open == std::string_view::npos || name.back() != ']') return "[";
  return name.substr(open + 1, name.size() - open - 2);
}

}  // namespace

std::variant<ParsedQuantity, std::string> unit_of_column(std::string_view name) {
  const std::string_view unit = bracketed(name);
  if (unit == "[") return fmt::format("the column \"{}\" has no unit in brackets", name);
  auto parsed = parse_quantity(fmt::format("1 {}", unit));
  if (auto* trouble = std::get_if<std::string>(&parsed)) {
    *trouble = fmt::format("\"[{}]\": {}", unit, *trouble);
  }
  return parsed;
}

std::string wrong_dimension(std::string_view column, const DimensionExponents& exponents,
                            const WantedDimension& wanted) {
  return fmt::format("this column is {}, but \"[{}]\" is {}", wanted.name, bracketed(column),
                     name_of(exponents));
}

std::string_view example_unit_of(const WantedDimension& wanted) {
  const std::string_view example = wanted.example;
  const std::size_t unit = example.find(' ') + 1;
  return example.substr(unit, example.find('"', unit) - unit);
}

std::variant<double, FieldTrouble> number_in_table(std::string_view text) {
  std::string_view number = text;
  if (number.starts_with('+') && !number.starts_with("+-")) number.remove_prefix(1);
  double value = 0.0;
  const char* const end = number.data() + number.size();
  const auto [at, error] = std::from_chars(number.data(), end, value);
  if (error == std::errc::invalid_argument || at != end) {
    return FieldTrouble{fmt::format("\"{}\" is not a number", text),
                        "write numbers without unit, with a decimal point"};
  }
  if (error != std::errc{} || !(std::abs(value) <= largest_table_number)) {
    return FieldTrouble{fmt::format("\"{}\" is not finite, or too large to be meant", text),
                        "write a number of the unit in the first line"};
  }
  return value;
}

}  // namespace boxbeam
