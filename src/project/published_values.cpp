#include "boxbeam/project/published_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "csv_text.hpp"
#include "text_file.hpp"

namespace boxbeam {
namespace {

constexpr const char* header_hint =
    "the first line reads: result,published,tolerance,reason,source (the last two may be missing)";

enum Column { result, published, tolerance, reason, source, column_count };
constexpr std::array<std::string_view, column_count> column_names{"result", "published",
                                                                  "tolerance", "reason", "source"};

/// A part of a line with its quotes taken off.
struct Part {
  std::string text;
  std::string trouble;  ///< of its quotes
  int column = 1;
};

/// A part in quotes, which begins at `at`; moves behind it and the blanks there.
Part quoted_part(std::string_view line, std::size_t& at) {
  Part part;
  part.column = position_of(line, at).column;
  for (++at;; ++at) {
    if (at >= line.size()) {
      part.trouble = "the quotation mark is not closed on this line";
      return part;
    }
    if (line[at] == '"') {
      if (line.substr(at + 1, 1) != "\"") break;
      ++at;
    }
    part.text += line[at];
  }
  at = std::min(line.find_first_not_of(" \t", at + 1), line.size());
  if (at < line.size() && line[at] != ',') {
    part.trouble = "behind a closing quotation mark a comma is wanted";
    at = std::min(line.find(',', at), line.size());
  }
  return part;
}

std::vector<Part> parts_of(std::string_view line) {
  std::vector<Part> parts;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    at = std::min(line.find_first_not_of(" \t", at), line.size());
    if (at < line.size() && line[at] == '"') {
      parts.push_back(quoted_part(line, at));
    } else {
      const std::size_t to = std::min(line.find(',', at), line.size());
      parts.push_back(
          {std::string(trimmed(line.substr(at, to - at))), {}, position_of(line, at).column});
      at = to;
    }
  }
  return parts;
}

/// How a quantity that can be read is written: digits of its number, its unit.
void take_writing(const std::string& text, PublishedValue& value) {
  value.written = text;
  const std::size_t number = std::min(text.find_first_of("0123456789."), text.size());
  std::size_t end = std::min(text.find_first_not_of("0123456789.", number), text.size());
  const std::size_t counts = std::min(text.find_first_not_of("0.", number), end);
  value.digits = static_cast<int>(std::count_if(text.begin() + static_cast<std::ptrdiff_t>(counts),
                                                text.begin() + static_cast<std::ptrdiff_t>(end),
                                                [](char c) { return c != '.'; }));
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    end = std::min(text.find_first_not_of("+-0123456789", end + 1), text.size());
  }
  value.unit = trimmed(std::string_view(text).substr(end));
  const auto one = parse_quantity("1 " + value.unit);
  if (const auto* quantity = std::get_if<ParsedQuantity>(&one)) value.scale = quantity->value;
}

class PublishedReader {
 public:
  explicit PublishedReader(const std::string& path) { values_.path = path; }

  PublishedValues read(const std::string& text) {
    for (const std::string& whole : split_lines(text)) {
      ++line_;
      source_line_ = whole;
      if (line_ == 1 && source_line_.starts_with("\uFEFF")) source_line_.erase(0, 3);
      const std::string_view content = trimmed(source_line_);
      if (content.empty() || content.starts_with('#')) continue;
      if (columns_.empty()) {
        take_header();
        if (!problems_.empty()) break;  // what the columns mean is not known
      } else {
        take_row();
      }
    }
    if (problems_.empty() && values_.rows.empty()) {
      problems_.push_back({values_.path,
                           0,
                           0,
                           {},
                           columns_.empty() ? "the file is empty" : "the table has no rows",
                           header_hint});
    }
    if (!problems_.empty()) throw InputError(std::move(problems_));
    return std::move(values_);
  }

 private:
  void fail(int column, std::string message, std::string hint) {
    problems_.push_back(
        {values_.path, line_, column, source_line_, std::move(message), std::move(hint)});
  }

  void take_header() {
    std::array<bool, column_count> seen{};
    for (const Part& part : parts_of(source_line_)) {
      const auto* const name = std::find(column_names.begin(), column_names.end(), part.text);
      const auto which = static_cast<std::size_t>(name - column_names.begin());
      columns_.push_back(which);
      if (name == column_names.end()) {
        const std::string near =
            nearest_word(part.text, {column_names.begin(), column_names.end()});
        fail(part.column, fmt::format("there is no column \"{}\"", part.text),
             near.empty() ? header_hint : fmt::format("did you mean {}?", near));
        continue;
      }
      if (seen[which]) {
        fail(part.column, fmt::format("the column {} stands twice", *name), header_hint);
      }
      seen[which] = true;
    }
    for (const Column wanted : {result, published, tolerance}) {
      if (!seen[wanted] && problems_.empty()) {
        fail(1, fmt::format("the column {} is missing", column_names[wanted]), header_hint);
      }
    }
  }

  void take_row() {
    const std::vector<Part> parts = parts_of(source_line_);
    const std::size_t before = problems_.size();
    for (const Part& part : parts) {
      if (part.trouble.empty()) continue;
      fail(part.column, part.trouble, "write \"text, with a comma\"; a quotation mark in it twice");
    }
    if (problems_.size() > before) return;
    if (parts.size() != columns_.size()) {
      fail(parts.back().column,
           fmt::format("the first line names {} columns, here {} {}", columns_.size(),
                       parts.size() == 1 ? "is" : "are", parts.size()),
           "put texts with a comma into quotation marks; the decimal sign is a point");
      return;
    }
    std::array<Part, column_count> row;
    for (std::size_t i = 0; i < parts.size(); ++i) row[columns_[i]] = parts[i];
    take_values(row);
  }

  void take_values(const std::array<Part, column_count>& row) {
    PublishedValue value;
    value.key = row[result].text;
    value.line = line_;
    value.key_column = row[result].column;
    value.value_column = row[published].column;
    value.source_line = source_line_;
    value.reason = row[reason].text;
    value.source = row[source].text;
    const std::size_t before = problems_.size();
    if (value.key.empty()) {
      fail(row[result].column, "the result is missing",
           "write what is compared, for example governing.fatigue.safety_factor");
    } else if (stands_already(value)) {
      fail(row[result].column,
           fmt::format("\"{}\" stands here a second time from the same source", value.key),
           "leave out one of them");
    }
    const auto quantity = quantity_in(row[published], "16.3 MPa");
    if (quantity) {
      value.value = *quantity;
      take_writing(row[published].text, value);
    }
    take_tolerance(row[tolerance], quantity, value.tolerance);
    if (problems_.size() == before) values_.rows.push_back(std::move(value));
  }

  bool stands_already(const PublishedValue& value) const {
    return std::any_of(values_.rows.begin(), values_.rows.end(), [&](const PublishedValue& other) {
      return other.key == value.key && other.source == value.source;
    });
  }

  std::optional<ParsedQuantity> quantity_in(const Part& part, const char* example) {
    const auto parsed = parse_quantity(part.text);
    if (const auto* quantity = std::get_if<ParsedQuantity>(&parsed)) return *quantity;
    fail(part.column, part.text.empty() ? "a number is missing" : std::get<std::string>(parsed),
         fmt::format("write a number with its unit, for example {}", example));
    return std::nullopt;
  }

  void take_tolerance(const Part& part, const std::optional<ParsedQuantity>& value,
                      PublishedTolerance& into) {
    into.written = part.text;
    into.relative = part.text.ends_with('%');
    Part number = part;
    if (into.relative) number.text.pop_back();
    const auto quantity = quantity_in(number, "1 % or 0.05 mm");
    if (!quantity) return;
    into.value = into.relative ? 0.01 * quantity->value : quantity->value;
    if (quantity->value < 0.0) {
      fail(part.column, "a tolerance is not negative", "it counts to both sides; write its size");
    } else if (into.relative && quantity->exponents != DimensionExponents{}) {
      fail(part.column, fmt::format("\"{}\" is neither a part nor a size", part.text),
           "write 1 % or 0.05 mm");
    } else if (into.relative && value && value->value == 0.0) {
      fail(part.column, "a part of zero is zero", "write an absolute tolerance, 0.05 mm");
    } else if (!into.relative && value && quantity->exponents != value->exponents) {
      fail(part.column,
           fmt::format("the tolerance is {}, the published value {}", name_of(quantity->exponents),
                       name_of(value->exponents)),
           "give both a unit of the same kind, or write the tolerance as 1 %");
    }
  }

  PublishedValues values_;
  std::vector<Problem> problems_;
  std::vector<std::size_t> columns_;  ///< which column each part of a line is
  std::string source_line_;
  int line_ = 0;
};

}  // namespace

PublishedValues read_published(const std::string& path) {
  const FileText file = read_regular_file(path);
  if (file.trouble != FileText::Trouble::none) {
    throw InputError({{path, 0, 0, {}, file.why, "give the path of a table of published values"}});
  }
  if (const std::size_t at = find_not_utf8(file.text); at != std::string::npos) {
    const LineColumn place = position_of(file.text, at);
    throw InputError({{path,
                       place.line,
                       place.column,
                       {},
                       "the file is not UTF-8 text",
                       "save it with UTF-8 encoding"}});
  }
  return PublishedReader(path).read(file.text);
}

}  // namespace boxbeam
