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

namespace {

constexpr char quote = '"';

/// The first place from which `stops` holds outside quotation marks, the end where there is none.
template <class Stops>
std::size_t find_outside_quotes(std::string_view line, std::size_t from, const Stops& stops) {
  bool quoted = false;
  for (std::size_t at = from; at < line.size(); ++at) {
    if (line[at] == quote) {
      quoted = !quoted;
    } else if (!quoted && stops(line[at])) {
      return at;
    }
  }
  return line.size();
}

std::string_view unquoted(std::string_view text) {
  const bool pair = text.size() >= 2 && text.front() == quote && text.back() == quote;
  return pair ? trimmed(text.substr(1, text.size() - 2)) : text;
}

}  // namespace

std::string_view without_comment(std::string_view line) {
  return line.substr(0, find_outside_quotes(line, 0, [](char c) { return c == '#'; }));
}

std::vector<Field> fields_of(std::string_view line, char separator) {
  std::vector<Field> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = find_outside_quotes(line, from, [&](char c) { return c == separator; });
    const std::size_t text = std::min(line.find_first_not_of(" \t", from), to);
    fields.push_back(
        {unquoted(trimmed(line.substr(from, to - from))), position_of(line, text).column});
    from = to + 1;
  }
  return fields;
}

std::string_view TableForm::separators() const {
  switch (separator) {
    case ';': return "semicolons";
    case '\t': return "tabs";
    case ' ': return "blanks";
    default: return "commas";
  }
}

TableForm form_of(std::string_view first_line) {
  for (const char separator : {';', '\t'}) {
    const auto stops = [&](char c) { return c == separator; };
    if (find_outside_quotes(first_line, 0, stops) < first_line.size()) {
      return {separator, TableForm::not_shown};
    }
  }
  return {};
}

namespace {

/// "1", "-.5", or nothing: no unit.
bool is_number_or_empty(const Field& field) {
  return field.text.find_first_of("0123456789") == field.text.find_first_not_of("+-.,");
}

std::string_view without_brackets(std::string_view unit) {
  for (const std::string_view brackets : {"[]", "()"}) {
    if (unit.starts_with(brackets.front()) && unit.ends_with(brackets.back())) {
      return unit.substr(1, unit.size() - 2);
    }
  }
  return unit;
}

}  // namespace

bool TableHead::wants_more_than(std::string_view line, int number) {
  if (!columns_.empty()) {
    take_units(line, number);
    return false;
  }
  form_ = form_of(line);
  line_ = line;
  line_number_ = number;
  bool units_below = true;
  for (const Field& field : fields_of(line, form_.separator)) {
    columns_.push_back({std::string(field.text), field.column});
    units_below = units_below && !field.text.ends_with(']');
  }
  return units_below;
}

void TableHead::take_units(std::string_view line, int number) {
  const std::vector<Field> units = fields_of(line, form_.separator);
  const bool other_row = units.size() != columns_.size() ||
                         std::any_of(units.begin(), units.end(), is_number_or_empty);
  if (other_row) return;  // the names have no units
  line_ = line;
  line_number_ = number;
  for (std::size_t i = 0; i < units.size(); ++i) {
    columns_[i].name += fmt::format(" [{}]", without_brackets(units[i].text));
    columns_[i].column = units[i].column;
  }
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

std::variant<double, FieldTrouble> number_in_table(std::string_view text, TableForm& form) {
  std::string number(text);
  const std::size_t sign = text.find_first_of(".,");
  if (sign != std::string_view::npos) {
    const bool between_commas = form.separator == ',';
    if (form.decimal_sign == TableForm::not_shown) form.decimal_sign = text[sign];
    if (text[sign] != form.decimal_sign && !between_commas) {
      return FieldTrouble{
          fmt::format("\"{}\" has another decimal sign than the numbers above", text),
          "write all numbers of a table with a point or all with a comma, and no sign between "
          "thousands"};
    }
    if (text[sign] == form.decimal_sign) number[sign] = '.';
  }
  if (number.starts_with('+') && !number.starts_with("+-")) number.erase(0, 1);
  double value = 0.0;
  const char* const end = number.data() + number.size();
  const auto [at, error] = std::from_chars(number.data(), end, value);
  if (const std::string trouble = look_alike_sign_in(text); !trouble.empty()) {
    return FieldTrouble{fmt::format("\"{}\" is not a number", text), trouble};
  }
  if (error == std::errc::invalid_argument || at != end) {
    return FieldTrouble{fmt::format("\"{}\" is not a number", text),
                        form.separator == ','
                            ? "write numbers without unit, with a decimal point; a decimal comma "
                              "wants semicolons or tabs between the columns"
                            : "write numbers without unit, with a decimal point or comma"};
  }
  if (error != std::errc{} || !(std::abs(value) <= largest_table_number)) {
    return FieldTrouble{fmt::format("\"{}\" is not finite, or too large to be meant", text),
                        "write a number of the unit in the first line"};
  }
  return value;
}

}  // namespace boxbeam
