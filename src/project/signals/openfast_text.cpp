#include <fmt/format.h>

#include <utility>

#include "boxbeam/core/error.hpp"
#include "file_unit.hpp"
#include "number_rows.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* out_head_hint =
    "a line of names begins with Time, the one below it with the units: (s)";

/// Source: OpenFAST, WriteOutputToFile of the glue code; the reader of openfast_toolbox.
class OpenfastTextReader : public SignalReader {
 public:
  OpenfastTextReader(SignalBytes bytes, const SignalSource& source) : lines_(std::move(bytes)) {
    head_.path = source.path;
    head_.format = SignalFormat::openfast_text;
    refuse_time_step(lines_.bytes(), source);
    std::vector<std::string> names = find_names();
    head_.names_line = static_cast<int>(lines_.number());
    head_.names_text = utf8_of(lines_.line());
    if (!lines_.next()) lines_.fail(1, "the file ends behind the names", out_head_hint);
    const std::string line = utf8_of(lines_.line());
    const std::vector<Field> units = signal_fields(line, ' ');
    if (units.size() != names.size()) {
      lines_.fail(
          1,
          fmt::format("the line above names {} columns, here {} {}", names.size(),
                      units.size() == 1 ? "is the unit of" : "are the units of", units.size()),
          out_head_hint);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string_view text = units[i].text;
      if (!text.starts_with('(') || !text.ends_with(')')) {
        lines_.fail(units[i].column, fmt::format("\"{}\" is no unit in parentheses", text),
                    out_head_hint);
      }
      const std::string unit(without_unit_brackets(text));
      if (i > 0) head_.channels.push_back({std::move(names[i]), unit});
      if (i == 0) take_time_unit(unit);
    }
    if (head_.channels.empty()) lines_.fail(1, "the table has no column but the time", {});
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    std::vector<std::size_t> wanted;
    for (const std::size_t channel : columns) wanted.push_back(channel + 1);
    NumberRows rows(lines_, {' ', '.'}, head_.channels.size() + 1, wanted, time_, block);
    std::string closing;
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (trimmed(line).empty()) continue;
      const bool is_row = begins_with_number(line);
      if (is_row && closing.empty()) {
        rows.take(line);
      } else if (is_row) {
        lines_.fail(1, fmt::format("a row behind the closing line \"{}\"", closing.substr(0, 80)),
                    "keep one run in a file");
      } else if (closing.empty()) {
        // What is no number where rows are expected ends them, but not in front of them.
        if (rows.rows() == 0) lines_.fail(1, "this is no row of numbers", out_head_hint);
        closing = utf8_of(trimmed(line));
      }
    }
    if (rows.rows() == 0) lines_.bytes().fail("the table has no rows", out_head_hint);
  }

 private:
  /// Goes to the line of the names.
  std::vector<std::string> find_names() {
    constexpr int most_lines = 200;
    while (lines_.number() < most_lines && lines_.next()) {
      const std::string line = utf8_of(lines_.line());
      const std::vector<Field> words = signal_fields(line, ' ');
      if (words.empty() || (words[0].text != "Time" && words[0].text != "TIME")) continue;
      std::vector<std::string> names;
      for (const Field& word : words) names.emplace_back(word.text);
      return names;
    }
    lines_.bytes().fail("no line begins with Time", out_head_hint);
  }

  void take_time_unit(const std::string& unit) {
    const auto parsed = parse_file_unit(unit);
    const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
    if (quantity == nullptr || !is_of(quantity->exponents, wanted::time)) {
      lines_.fail(1, fmt::format("the time is in \"{}\", which is no unit of a time", unit),
                  out_head_hint);
    }
    time_ = {0, quantity->value, 0.0};
  }

  TextLines lines_;
  NumberRows::Time time_;
};

}  // namespace

OpenedSignals open_openfast_text(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<OpenfastTextReader>(std::move(bytes), source);
}

}  // namespace boxbeam
