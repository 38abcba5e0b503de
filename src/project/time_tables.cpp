#include "time_tables.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>

#include "text_file.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t fewest_rows = 3;
/// Beyond these no time or value is meant, as in the case file.
constexpr double largest_magnitude = 1e20;
constexpr double shortest_step = 1e-9;

/// A piece of a line and where it begins.
struct Field {
  std::string_view text;
  int column = 1;
};

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t") + 1 - from);
}

std::vector<Field> fields_of(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    const std::size_t text = std::min(line.find_first_not_of(" \t", from), to);
    fields.push_back({trimmed(line.substr(from, to - from)), position_of(line, text).column});
    from = to + 1;
  }
  return fields;
}

/// Reads the lines of one table up to the first thing that is wrong.
class TimeTableParser {
 public:
  TimeTableParser(ProblemList& problems, std::string_view file, const WantedDimension& wanted,
                  const char* column)
      : problems_(&problems), file_(file), wanted_(&wanted), column_(column) {}

  std::optional<TimeTable> parse(const std::vector<std::string>& lines) {
    bool header = true;
    for (const std::string& whole : lines) {
      ++line_;
      std::string_view line = std::string_view(whole).substr(0, whole.find('#'));
      if (line_ == 1 && line.starts_with("\uFEFF")) line.remove_prefix(3);
      if (trimmed(line).empty()) continue;
      if (!(header ? take_header(line) : take_row(line))) return std::nullopt;
      header = false;
      table_.end = {file_, line_, 1};
    }
    if (table_.time.size() < fewest_rows) {
      fail({},
           fmt::format("the table has {} rows, at least {} are wanted", table_.time.size(),
                       fewest_rows),
           header_hint());
      return std::nullopt;
    }
    return table_;
  }

 private:
  std::string header_hint() const {
    const std::string_view example = wanted_->example;
    const std::size_t unit = example.find(' ') + 1;
    return fmt::format("the first line reads for example: time [s], {} [{}]; below it numbers",
                       column_, example.substr(unit, example.find('"', unit) - unit));
  }

  bool fail(const Field& field, std::string message, std::string hint) {
    problems_->add({file_, std::max(1, line_), field.column}, std::move(message), std::move(hint));
    return false;
  }

  bool has_two(const std::vector<Field>& fields, const char* what) {
    if (fields.size() == 2) return true;
    return fail(fields.front(),
                fmt::format("{} has two parts with a comma between them, time and {}; here {} {}",
                            what, column_, fields.size() == 1 ? "is" : "are", fields.size()),
                header_hint());
  }

  /// The factor to SI of the unit in the brackets of a column's name.
  std::optional<double> factor_of(const Field& field, const WantedDimension& wanted) {
    const std::size_t open = field.text.find('[');
    if (open == std::string_view::npos || field.text.back() != ']') {
      fail(field, fmt::format("the column \"{}\" has no unit in brackets", field.text),
           header_hint());
      return std::nullopt;
    }
    const std::string_view unit = field.text.substr(open + 1, field.text.size() - open - 2);
    const auto parsed = parse_quantity(fmt::format("1 {}", unit));
    if (const auto* trouble = std::get_if<std::string>(&parsed)) {
      fail(field, fmt::format("\"[{}]\": {}", unit, *trouble), header_hint());
      return std::nullopt;
    }
    const auto& quantity = std::get<ParsedQuantity>(parsed);
    if (is_of(quantity.exponents, wanted)) return quantity.value;
    fail(field,
         fmt::format("this column is {}, but \"[{}]\" is {}", wanted.name, unit,
                     name_of(quantity.exponents)),
         header_hint());
    return std::nullopt;
  }

  bool take_header(std::string_view line) {
    const std::vector<Field> fields = fields_of(line);
    if (!has_two(fields, "the first line")) return false;
    const std::optional<double> time = factor_of(fields[0], wanted::time);
    const std::optional<double> value = time ? factor_of(fields[1], *wanted_) : std::nullopt;
    if (!value) return false;
    time_factor_ = *time;
    value_factor_ = *value;
    return true;
  }

  std::optional<double> number_in(const Field& field) {
    std::string_view text = field.text;
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
      fail(field, fmt::format("\"{}\" is not a number", field.text),
           "write numbers without unit, with a decimal point, and a comma between the columns");
      return std::nullopt;
    }
    if (error != std::errc{} || !(std::abs(value) <= largest_magnitude)) {
      fail(field, fmt::format("\"{}\" is not finite, or too large to be meant", field.text),
           "write a number of the unit in the first line");
      return std::nullopt;
    }
    return value;
  }

  bool take_row(std::string_view line) {
    const std::vector<Field> fields = fields_of(line);
    if (!has_two(fields, "a row")) return false;
    const std::optional<double> time = number_in(fields[0]);
    const std::optional<double> value = time ? number_in(fields[1]) : std::nullopt;
    if (!value) return false;
    const double seconds = *time * time_factor_;
    if (!table_.time.empty() && !(seconds - table_.time.back() >= shortest_step)) {
      return fail(
          fields[0],
          fmt::format("the time {} does not come after that of the row before", fields[0].text),
          "write the rows in the order of time, each instant once, at least 1 ns apart");
    }
    table_.time.push_back(seconds);
    table_.value.push_back(*value * value_factor_);
    return true;
  }

  ProblemList* problems_;
  std::string_view file_;
  const WantedDimension* wanted_;
  const char* column_;
  int line_ = 0;
  double time_factor_ = 1.0;
  double value_factor_ = 1.0;
  TimeTable table_;
};

}  // namespace

const std::vector<std::string>* TimeTables::lines_of(TableReader& table, std::string_view key,
                                                     const std::string& written,
                                                     const std::string& resolved) {
  const auto same = [&](const InputFile& file) { return file.resolved == resolved; };
  if (std::any_of(document_->files.begin(), document_->files.end(), same)) {
    return &document_->lines.find(resolved)->second;
  }
  const FileText file = read_text_file(resolved);
  if (file.trouble != FileText::Trouble::none) {
    table.problem(key, fmt::format("{}: {}", resolved, file.why),
                  "give the path of a table (.csv) from the folder of the case file");
    return nullptr;
  }
  document_->add_file(written, resolved, file.text);
  if (const std::size_t at = find_not_utf8(file.text); at != std::string::npos) {
    const LineColumn place = position_of(file.text, at);
    table.problems().add({document_->lines.find(resolved)->first, place.line, place.column},
                         "the file is not UTF-8 text", "save it with UTF-8 encoding");
    return nullptr;
  }
  return &document_->lines.find(resolved)->second;
}

std::optional<TimeTable> TimeTables::read(TableReader& table, std::string_view key,
                                          const WantedDimension& wanted, const char* column) {
  const std::string written = table.text(key);
  if (written.empty()) return std::nullopt;
  namespace fs = std::filesystem;
  const std::string resolved = (fs::path(document_->path).parent_path() / written).string();
  const std::vector<std::string>* lines = lines_of(table, key, written, resolved);
  if (lines == nullptr) return std::nullopt;
  const std::string_view file = document_->lines.find(resolved)->first;
  return TimeTableParser(table.problems(), file, wanted, column).parse(*lines);
}

}  // namespace boxbeam
