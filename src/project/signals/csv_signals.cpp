#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/core/error.hpp"
#include "file_unit.hpp"
#include "number_rows.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* csv_head_hint =
    "the first line reads for example: time [s], force [kN]; below it numbers";

/// "T" is a torsional moment.
bool is_time_name(std::string_view name) { return name == "t" || small_letters(name) == "time"; }

bool is_time_unit(std::string_view unit) {
  const auto parsed = parse_file_unit(unit);
  const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
  return quantity != nullptr && is_of(quantity->exponents, wanted::time);
}

class CsvReader : public SignalReader {
 public:
  CsvReader(SignalBytes bytes, const SignalSource& source) : lines_(std::move(bytes)) {
    head_.path = source.path;
    head_.format = SignalFormat::csv;
    read_head();
    find_time(source);
    for (std::size_t column = 0; column < names_.size(); ++column) {
      if (column == time_.column) continue;
      head_.channels.push_back({names_[column].name, names_[column].unit});
      column_of_channel_.push_back(column);
    }
    if (head_.channels.empty()) {
      fail_in_head(0, "the table has no column but the time");
    }
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    std::vector<std::size_t> wanted;
    for (const std::size_t channel : columns) wanted.push_back(column_of_channel_[channel]);
    NumberRows rows(lines_, form_, names_.size(), wanted, time_, block);
    do {
      const std::string_view line = lines_.line();
      const bool has_comment = line.find('#') != std::string_view::npos;
      const std::string_view row = has_comment ? without_comment(line) : line;
      if (!trimmed(row).empty()) rows.take(row);
    } while (lines_.next());
  }

 private:
  struct HeadLine {
    std::string text;  ///< UTF-8
    int number = 0;
  };

  /// Up to the first row, which is then the current line.
  void read_head() {
    std::vector<HeadLine> head;
    bool has_row = false;
    while (!has_row && lines_.next()) {
      const std::string whole = utf8_of(lines_.line());
      take_sae_key(whole);
      const std::string_view line = without_comment(whole);
      if (trimmed(line).empty()) continue;
      has_row = begins_with_number(line);
      if (has_row) break;
      if (head.size() == 2) {
        lines_.fail(1, "a third line without numbers", csv_head_hint);
      }
      head.push_back({std::string(line), static_cast<int>(lines_.number())});
    }
    if (!has_row) {
      lines_.bytes().fail(head.empty() ? "the file is empty" : "the table has no rows",
                          csv_head_hint);
    }
    const std::string first_row(without_comment(utf8_of(lines_.line())));
    choose_form(head.empty() ? first_row : head.front().text, first_row);
    if (head.empty()) {
      if (!sae_step_) lines_.fail(1, "the columns have no names", csv_head_hint);
      const std::size_t width = signal_fields(first_row, form_.separator).size();
      for (std::size_t i = 0; i < width; ++i)
        names_.push_back({fmt::format("column {}", i + 1), {}, {}});
      return;
    }
    head_.names_line = head.front().number;
    head_.names_text = head.front().text;
    head_line_ = head.front();
    take_names(head.front());
    if (head.size() == 2) take_units(head[1]);
  }

  /// "#TIMEstep= 120 Seconds". Source: the text files of the SAE Fatigue Design and Evaluation
  /// Committee (fde.uwaterloo.ca).
  void take_sae_key(std::string_view line) {
    constexpr std::string_view key = "#timestep=";
    const std::string small = small_letters(trimmed(line));
    if (!small.starts_with(key)) return;
    const std::string_view text = trimmed(std::string_view(small).substr(key.size()));
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const auto unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    const auto parsed = parse_file_unit(unit.empty() ? "s" : unit);
    const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
    const bool known = error == std::errc{} && quantity != nullptr &&
                       is_of(quantity->exponents, wanted::time) && value >= 0.0 && value <= 1e9;
    if (!known) {
      lines_.fail(1, "the time step cannot be read",
                  "write for example #TIMEstep= 0.01 Seconds, or 0 where the first column is the "
                  "time");
    }
    sae_step_ = value * quantity->value;
  }

  void choose_form(const std::string& first, const std::string& row) {
    form_ = form_of(first);
    if (form_.separator != ',' || first.find(',') != std::string::npos) return;
    // Neither semicolons nor tabs nor commas: one column, or blanks between them.
    if (signal_fields(row, ' ').size() > 1) form_ = {' ', TableForm::not_shown};
  }

  void take_names(const HeadLine& line) {
    for (const Field& field : signal_fields(line.text, form_.separator)) {
      const bool unit_apart = form_.separator == ' ' && !names_.empty() &&
                              (field.text.starts_with('[') || field.text.starts_with('('));
      if (unit_apart) {
        names_.back().unit = std::string(without_unit_brackets(field.text));
        continue;
      }
      NameWithUnit name = split_unit(field.text);
      if (name.name.empty()) {
        fail_in_head(field.column, "a column has no name");
      }
      names_.push_back({std::move(name.name), std::move(name.unit), std::string(field.text)});
    }
  }

  /// A row of units below the names: brackets in the names are then part of them.
  void take_units(const HeadLine& line) {
    const std::vector<Field> units = signal_fields(line.text, form_.separator);
    if (units.size() != names_.size()) {
      throw InputError(
          {{head_.path, line.number, 1, line.text,
            fmt::format("the line above names {} columns, here {} {}", names_.size(),
                        units.size() == 1 ? "is a unit" : "are units for", units.size()),
            fmt::format("write a unit for each column, {} between them", form_.separators())}});
    }
    for (std::size_t i = 0; i < units.size(); ++i) {
      names_[i].name = names_[i].whole;
      names_[i].unit = std::string(without_unit_brackets(units[i].text));
    }
  }

  void find_time(const SignalSource& source) {
    const std::size_t column = time_column();
    const bool by_step = sae_step_ && *sae_step_ > 0.0;
    if (by_step || (source.time_step && column == names_.size())) {
      if (by_step) refuse_time_step(lines_.bytes(), source);
      time_.step = by_step ? *sae_step_ : *source.time_step;
      head_.time_step = time_.step;
      return;
    }
    refuse_time_step(lines_.bytes(), source);
    if (column == names_.size() && !sae_step_) {
      fail_in_head(1, "no column is the time: none has a time's unit and name");
    }
    time_.column = sae_step_ ? 0 : column;
    const std::string& unit = names_[*time_.column].unit;
    if (unit.empty()) {
      if (!source.time_unit && !sae_step_) fail_in_head(1, "the time has no unit");
      time_.factor = source.time_unit.value_or(1.0);
    } else if (!is_time_unit(unit)) {
      fail_in_head(
          1, fmt::format("the first column is the time, but \"{}\" is no unit of a time", unit));
    } else {
      time_.factor = std::get<ParsedQuantity>(parse_file_unit(unit)).value;
    }
  }

  /// A column of that name, else the first one where it has the unit of a time; the number of
  /// columns where there is none.
  std::size_t time_column() const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const Name& name = names_[i];
      if (is_time_name(name.name) && (name.unit.empty() || is_time_unit(name.unit))) return i;
    }
    return is_time_unit(names_.front().unit) ? 0 : names_.size();
  }

  [[noreturn]] void fail_in_head(int column, std::string message) const {
    throw InputError({{head_.path, head_line_.number, column, head_line_.text, std::move(message),
                       csv_head_hint}});
  }

  struct Name {
    std::string name, unit, whole;
  };

  TextLines lines_;
  HeadLine head_line_;
  std::optional<double> sae_step_;
  TableForm form_;
  std::vector<Name> names_;
  NumberRows::Time time_;
  std::vector<std::size_t> column_of_channel_;
};

}  // namespace

OpenedSignals open_csv_signals(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<CsvReader>(std::move(bytes), source);
}

}  // namespace boxbeam
