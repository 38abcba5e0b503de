#include "time_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "boxbeam/project/case_document.hpp"
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
    for (const std::string& whole : lines) {
      ++line_;
      std::string_view line = without_comment(whole);
      if (line_ == 1 && line.starts_with("\uFEFF")) line.remove_prefix(3);
      if (trimmed(line).empty()) continue;
      table_.end = {file_, line_, 1};
      if (in_head_ && head_.wants_more_than(line, line_)) continue;
      const bool is_row = !in_head_;
      if (in_head_ && !take_head()) return std::nullopt;
      if (is_row && !take_row(line)) return std::nullopt;
    }
    if (in_head_ && !head_.columns().empty() && !take_head()) return std::nullopt;
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

  std::string count_trouble(std::size_t parts) const {
    return fmt::format("the first line names two columns with {} between them, here {} {}",
                       form_.separators(), parts == 1 ? "is" : "are", parts);
  }

  std::string row_hint() const {
    return fmt::format("write two numbers in a row{}",
                       form_.separator == ','
                           ? "; a decimal comma wants semicolons or tabs between the columns"
                           : "");
  }

  bool fail(const Field& field, std::string message, std::string hint) {
    problems_->add({file_, std::max(1, line_), field.column}, std::move(message), std::move(hint));
    return false;
  }

  /// Of the head, which may stand lines above.
  bool fail_in_head(int column, std::string message) {
    problems_->add({file_, head_.line_number(), column}, std::move(message), header_hint());
    return false;
  }

  /// The factor to SI of the unit that a column names.
  std::optional<double> factor_of(const TableHead::Column& column, const WantedDimension& wanted) {
    const auto unit = unit_of_column(column.name);
    if (const auto* trouble = std::get_if<std::string>(&unit)) {
      fail_in_head(column.column, *trouble);
      return std::nullopt;
    }
    const auto& quantity = std::get<ParsedQuantity>(unit);
    if (is_of(quantity.exponents, wanted)) return quantity.value;
    fail_in_head(column.column, wrong_dimension(column.name, quantity.exponents, wanted));
    return std::nullopt;
  }

  /// Reads what the columns are, once the head is complete.
  bool take_head() {
    in_head_ = false;
    form_ = head_.form();
    const std::vector<TableHead::Column>& columns = head_.columns();
    if (columns.size() != 2) {
      return fail_in_head(columns.front().column,
                          fmt::format("a table has two columns, time and {}; the first line names "
                                      "{}",
                                      column_, columns.size()));
    }
    const std::optional<double> time = factor_of(columns[0], wanted::time);
    const std::optional<double> value = time ? factor_of(columns[1], *wanted_) : std::nullopt;
    if (!value) return false;
    time_factor_ = *time;
    value_factor_ = *value;
    return true;
  }

  std::optional<double> number_in(const Field& field) {
    const auto number = number_in_table(field.text, form_);
    if (const auto* value = std::get_if<double>(&number)) return *value;
    const auto& trouble = std::get<FieldTrouble>(number);
    fail(field, trouble.message, trouble.hint);
    return std::nullopt;
  }

  bool take_row(std::string_view line) {
    const std::vector<Field> fields = fields_of(line, form_.separator);
    if (fields.size() != 2) return fail(fields.front(), count_trouble(fields.size()), row_hint());
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
  bool in_head_ = true;
  TableHead head_;
  TableForm form_;
  double time_factor_ = 1.0;
  double value_factor_ = 1.0;
  TimeTable table_;
};

}  // namespace

std::shared_ptr<const KeptText> KeptFiles::text_at(const std::string& path) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = texts_.find(path);
    if (known != texts_.end()) return known->second;
  }
  const auto text = std::make_shared<KeptText>();
  text->file = read_regular_file(path);
  if (text->file.trouble != FileText::Trouble::none) return text;
  text->lines = split_lines(text->file.text);
  text->sha256 = sha256_of(text->file.text);
  const std::lock_guard lock(mutex_);
  return texts_.emplace(path, text).first->second;
}

std::optional<std::string> KeptFiles::sha256_at(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  const auto known = hashes_.find(path);
  return known != hashes_.end() ? std::optional(known->second) : std::nullopt;
}

void KeptFiles::keep_sha256(const std::string& path, std::string sha256) {
  const std::lock_guard lock(mutex_);
  hashes_.emplace(path, std::move(sha256));
}

std::shared_ptr<const recorded::Channels> KeptFiles::channels(const std::string& of) const {
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(channels_.begin(), channels_.end(),
                                  [&](const auto& kept) { return kept.first == of; });
  return known != channels_.end() ? known->second : nullptr;
}

void KeptFiles::keep_channels(std::string of, std::shared_ptr<const recorded::Channels> channels) {
  constexpr std::size_t most = 8;  // long records are large
  const std::lock_guard lock(mutex_);
  channels_.emplace_back(std::move(of), std::move(channels));
  if (channels_.size() > most) channels_.pop_front();
}

const std::vector<std::string>* TimeTables::lines_of(TableReader& table, std::string_view key,
                                                     const std::string& written,
                                                     const std::string& resolved) {
  if (is_known(resolved)) return &document_->lines.find(resolved)->second;
  const std::shared_ptr<const KeptText> kept = files_->text_at(resolved);
  const FileText& file = kept->file;
  if (file.trouble != FileText::Trouble::none) {
    table.problem(key, fmt::format("{}: {}", resolved, file.why),
                  "give the path of a table (.csv) from the folder of the case file");
    return nullptr;
  }
  const auto lines = document_->lines.insert_or_assign(resolved, kept->lines).first;
  document_->files.push_back({written, resolved, kept->sha256});
  if (const std::size_t at = find_not_utf8(file.text); at != std::string::npos) {
    std::string text = file.text;
    unify_line_ends(text);
    const LineColumn place = position_of(text, at);
    table.problems().add({lines->first, place.line, place.column}, "the file is not UTF-8 text",
                         "save it with UTF-8 encoding");
    return nullptr;
  }
  return &lines->second;
}

bool TimeTables::is_known(const std::string& resolved) const {
  return std::any_of(document_->files.begin(), document_->files.end(),
                     [&](const InputFile& file) { return file.resolved == resolved; });
}

void TimeTables::add_signals(const std::string& written) {
  const std::string path = resolved(written);
  if (is_known(path)) return;
  if (const auto sha256 = files_->sha256_at(path)) {
    document_->files.push_back({written, path, *sha256});
    return;
  }
  document_->add_large_file(written, path);
  files_->keep_sha256(path, document_->files.back().sha256);
}

std::string TimeTables::resolved(const std::string& written) const {
  return (std::filesystem::path(document_->path).parent_path() / written).string();
}

std::optional<TimeTable> TimeTables::read(TableReader& table, std::string_view key,
                                          const WantedDimension& wanted, const char* column) {
  const std::string written = table.text({key, "a CSV file, from the folder of the case"});
  if (written.empty()) return std::nullopt;
  const std::string path = resolved(written);
  const std::vector<std::string>* lines = lines_of(table, key, written, path);
  if (lines == nullptr) return std::nullopt;
  const std::string_view file = document_->lines.find(path)->first;
  return TimeTableParser(table.problems(), file, wanted, column).parse(*lines);
}

}  // namespace boxbeam
