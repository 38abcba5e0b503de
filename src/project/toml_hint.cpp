#include "toml_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "csv_text.hpp"

namespace boxbeam {
namespace {

using Hint = std::optional<std::string>;

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A line "key = value  # comment" in its parts; both are empty where there is no "=".
struct Assignment {
  std::string_view key, value;
};

Assignment assignment_in(std::string_view line) {
  const std::string_view code = without_comment(line);
  const std::size_t equals = code.find('=');
  if (equals == std::string_view::npos) return {};
  return {trimmed(code.substr(0, equals)), trimmed(code.substr(equals + 1))};
}

/// Characters that look like others, where the parser stopped.
Hint look_alike_hint(std::string_view at) {
  static constexpr std::array<std::string_view, 7> quotes{"\u201C", "\u201D", "\u201E", "\u2018",
                                                          "\u2019", "\u00AB", "\u00BB"};
  static constexpr std::array<std::string_view, 3> blanks{"\u00A0", "\u202F", "\u2009"};
  const auto begins = [&](std::string_view with) { return at.starts_with(with); };
  if (std::any_of(quotes.begin(), quotes.end(), begins)) {
    return "write straight quotation marks, \"1.5 m\", not typographic ones";
  }
  constexpr std::size_t sign_and_digit = 4;
  if (std::string trouble = look_alike_sign_in(at.substr(0, sign_and_digit)); !trouble.empty()) {
    return trouble;
  }
  if (std::any_of(blanks.begin(), blanks.end(), begins)) {
    return "a blank that does not break, as from a word processor, stands there; write a plain one";
  }
  return std::nullopt;
}

/// The line is no line of TOML at all.
Hint other_language_hint(std::string_view line) {
  const std::string_view text = trimmed(line);
  for (const std::string_view comment : {"//", "/*", "--", ";", "%", "!"}) {
    if (text.starts_with(comment)) return "a comment begins with #";
  }
  if (text.starts_with('{') || text.starts_with('<')) {
    return "a case is TOML: [tables] with lines key = value; boxbeam init planar writes one";
  }
  return std::nullopt;
}

Hint repetition_hint(std::string_view line, std::string_view description) {
  if (!contains(description, "cannot redefine")) return std::nullopt;
  if (!trimmed(line).starts_with('[')) {
    return "a key stands once in its table; take one of the two away";
  }
  if (contains(description, "as table")) {
    return "the name is that of a value already; take one of the two away";
  }
  return "a table has one header; put what stands below both under the first, or give it another "
         "name";
}

/// Brackets, braces, quotation marks and backslashes.
Hint enclosure_hint(std::string_view line, std::string_view at, std::string_view description) {
  if (contains(description, "escape sequence") || contains(description, "unicode scalar")) {
    return "a backslash begins an escape in \"..\"; write '..' with single quotation marks, or two "
           "backslashes";
  }
  if (contains(description, "string")) {
    return at.empty() ? "the text is not closed: put its quotation mark at its end, in the same "
                        "line"
                      : "a text holds no control characters; take this one away";
  }
  if (contains(description, "table header")) {
    const bool list = trimmed(line).starts_with("[[");
    return fmt::format("close the header of the table with {}", list ? "]]" : "]");
  }
  if (contains(description, "inline table")) {
    return "a table in braces stands in one line, commas between its keys and none behind the "
           "last; or give it a header of its own, [name]";
  }
  if (contains(description, "array")) {
    return "put commas between the items of a list, and ] behind the last";
  }
  return std::nullopt;
}

/// Of the value of a key, which is neither a number nor in quotation marks.
Hint value_hint(const Assignment& line) {
  const std::string_view value = line.value;
  if (value.empty()) return fmt::format("a value is missing: {} = \"1.5 m\"", line.key);
  if (value.ends_with(';') || value.ends_with(',')) {
    return fmt::format("nothing stands behind a value; take away the {}", value.back());
  }
  const std::string lower = small_letters(value);
  for (const auto& [word, meant] : {std::pair{"true", "true"},
                                    {"false", "false"},
                                    {"yes", "true"},
                                    {"no", "false"},
                                    {"on", "true"},
                                    {"off", "false"}}) {
    if (lower == word) return fmt::format("write {} = {}", line.key, meant);
  }
  if (value.starts_with('=')) {
    const std::size_t from = value.find_first_not_of("= ");
    return fmt::format("a single = stands between a key and its value: {} = {}", line.key,
                       from == std::string_view::npos ? "\"1.5 m\"" : value.substr(from));
  }
  if (contains(value, "=")) return "one key = value stands in a line; begin a new line";
  const std::size_t comma = value.find(',');
  if (comma != std::string_view::npos && comma > 0 && is_digit(value[comma - 1]) &&
      comma + 1 < value.size() && is_digit(value[comma + 1])) {
    std::string point(value);
    point[comma] = '.';
    const auto quantity = parse_quantity(point);
    const auto* read = std::get_if<ParsedQuantity>(&quantity);
    const bool bare = read != nullptr && read->exponents == DimensionExponents{};
    const char* mark = bare ? "" : "\"";
    return fmt::format("the decimal sign is a point: {} = {}{}{}", line.key, mark, point, mark);
  }
  if (value.front() == '"' || value.front() == '\'') {
    return "behind the closing quotation mark the line ends";
  }
  const std::size_t sign = value.front() == '-' || value.front() == '+' ? 1 : 0;
  const std::string_view size = value.substr(sign);
  const std::string_view before = value.substr(0, sign);
  if (size.starts_with('.')) {
    return fmt::format("a digit stands on both sides of the point: {}0{}", before, size);
  }
  if (size.ends_with('.')) {
    return fmt::format("a digit stands on both sides of the point: {}0", value);
  }
  if (size.size() > 1 && size[0] == '0' && is_digit(size[1])) {
    return fmt::format("no zero stands before a number: {}{}", before,
                       size.substr(std::min(size.find_first_not_of('0'), size.size() - 1)));
  }
  const bool unit = std::holds_alternative<ParsedQuantity>(parse_quantity(value));
  const char* what = unit ? "a value with its unit" : "a text";
  return fmt::format("{} stands in quotation marks: {} = \"{}\"", what, line.key, value);
}

Hint key_hint(std::string_view line, const Assignment& parts) {
  if (parts.key.empty() && !contains(line, "=")) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return "a line reads key = value, or [table]";
    return fmt::format("write an equals sign: {} = {}", trimmed(line.substr(0, colon)),
                       trimmed(line.substr(colon + 1)));
  }
  if (parts.key.empty()) return "a key is missing before the equals sign";
  const bool plain = std::all_of(parts.key.begin(), parts.key.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
  if (!plain && !contains(parts.key, "\"")) {
    return fmt::format(
        "a key has letters without accents, digits, _ and -; others stand in quotation marks: "
        "\"{}\" = ...",
        parts.key);
  }
  return std::nullopt;
}

}  // namespace

std::string toml_hint(std::string_view line, int column, std::string_view description) {
  std::size_t from = 0;
  for (int i = 1; i < column && from < line.size(); ++i) from += code_point_at(line, from).length;
  const std::string_view at = trimmed(line.substr(from));
  if (contains(description, "after '\\r'")) {
    return "a line ends with LF or CR LF; save the file with such ends";
  }
  if (const Hint hint = look_alike_hint(at)) return *hint;
  if (const Hint hint = repetition_hint(line, description)) return *hint;
  if (const Hint hint = enclosure_hint(line, at, description)) return *hint;
  if (contains(description, "could not be interpreted")) {
    return "the number is too large or too small to be meant";
  }
  if (const Hint hint = other_language_hint(line)) return *hint;
  const Assignment parts = assignment_in(line);
  if (const Hint hint = key_hint(line, parts)) return *hint;
  if (const Hint hint = value_hint(parts)) return *hint;
  return "a line reads key = value; texts and values with units stand in quotation marks";
}

}  // namespace boxbeam
