#include "time_tables.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "boxbeam/project/limits.hpp"
#include "csv_text.hpp"
#include "text_file.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t fewest_rows = 3;
constexpr double shortest_step = 1e-9;

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
    return fmt::format("the first line reads for example: time [s], {} [{}]; below it numbers",
                       column_, example_unit_of(*wanted_));
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
    const auto unit = unit_of_column(field.text);
    if (const auto* trouble = std::get_if<std::string>(&unit)) {
      fail(field, *trouble, header_hint());
      return std::nullopt;
    }
    const auto& quantity = std::get<ParsedQuantity>(unit);
    if (is_of(quantity.exponents, wanted)) return quantity.value;
    fail(field, wrong_dimension(field.text, quantity.exponents, wanted), header_hint());
    return std::nullopt;
  }

  bool take_header(std::string_view line) {
    const std::vector<Field> fields = fields_of(line, ',');
    if (!has_two(fields, "the first line")) return false;
    const std::optional<double> time = factor_of(fields[0], wanted::time);
    const std::optional<double> value = time ? factor_of(fields[1], *wanted_) : std::nullopt;
    if (!value) return false;
    time_factor_ = *time;
    value_factor_ = *value;
    return true;
  }

  std::optional<double> number_in(const Field& field) {
    const auto number = number_in_table(field.text);
    if (const auto* value = std::get_if<double>(&number)) return *value;
    const auto& trouble = std::get<FieldTrouble>(number);
    fail(field, trouble.message, trouble.hint);
    return std::nullopt;
  }

  bool take_row(std::string_view line) {
    const std::vector<Field> fields = fields_of(line, ',');
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
    if (table_.time.size() == limits::most_rows) {
      return fail(fields[0], fmt::format("the table has more than {} rows", limits::most_rows),
                  "give one period, or fewer points on it");
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
  const FileText file = read_regular_file(resolved);
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
