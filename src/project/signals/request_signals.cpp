#include <fmt/format.h>

#include <utility>

#include "number_rows.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* table_hint =
    "give the table of one request: a line of names from TIME on, below it rows of numbers";
constexpr const char* steps_hint =
    "a request file has its version, the number of requests, a line for each (number, type, "
    "markers), and for each step the time and six numbers a request";

/// Adams and RecurDyn write no units.
NumberRows::Time first_column_time(const SignalSource& source) {
  return {0, source.time_unit.value_or(1.0), 0.0};
}

class RequestTableReader : public SignalReader {
 public:
  RequestTableReader(SignalBytes bytes, const SignalSource& source)
      : lines_(std::move(bytes)), time_(first_column_time(source)) {
    head_.path = source.path;
    head_.format = SignalFormat::request_table;
    refuse_time_step(lines_.bytes(), source);
    bool has_row = false;
    while (!has_row && lines_.next()) {
      const std::string_view line = trimmed(lines_.line());
      has_row = begins_with_number(line);
      if (line.empty() || has_row) continue;
      names_ = utf8_of(line);
      head_.names_line = static_cast<int>(lines_.number());
      head_.names_text = utf8_of(lines_.line());
    }
    if (!has_row) lines_.bytes().fail("the table has no rows", table_hint);
    width_ = signal_fields(lines_.line(), ' ').size();
    if (width_ < 2) lines_.fail(1, "a row holds the time and at least one value", table_hint);
    const std::vector<Field> words = signal_fields(names_, ' ');
    if (words.size() != width_) {
      lines_.fail(
          1,
          fmt::format("the words above the first row are {}, its numbers {}", words.size(), width_),
          table_hint);
    }
    if (words[0].text != "TIME" && words[0].text != "Time" && words[0].text != "time") {
      lines_.fail(1, fmt::format("the first column is called \"{}\", not TIME", words[0].text),
                  table_hint);
    }
    for (std::size_t i = 1; i < width_; ++i) {
      head_.channels.push_back({std::string(words[i].text), {}});
    }
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    std::vector<std::size_t> wanted;
    for (const std::size_t channel : columns) wanted.push_back(channel + 1);
    NumberRows rows(lines_, {' ', '.'}, width_, wanted, time_, block);
    std::string words = names_;
    do {
      const std::string_view line = lines_.line();
      if (trimmed(line).empty()) continue;
      if (!begins_with_number(line)) {
        words = utf8_of(trimmed(line));
        continue;
      }
      // A new page has the names once more; other names are another request.
      if (words != names_) {
        lines_.fail(1, fmt::format("a second table begins below \"{}\"", words.substr(0, 80)),
                    table_hint);
      }
      rows.take(line);
    } while (lines_.next());
  }

 private:
  TextLines lines_;
  NumberRows::Time time_;
  std::string names_;
  std::size_t width_ = 0;
};

class RequestStepsReader : public SignalReader {
 public:
  RequestStepsReader(SignalBytes bytes, const SignalSource& source)
      : lines_(std::move(bytes)), time_(first_column_time(source)) {
    head_.path = source.path;
    head_.format = SignalFormat::request_steps;
    refuse_time_step(lines_.bytes(), source);
    if (!next_line()) lines_.bytes().fail("the file is empty", steps_hint);
    if (!next_line()) lines_.bytes().fail("the number of requests is missing", steps_hint);
    const std::size_t count = number_of_requests();
    for (std::size_t i = 0; i < count; ++i) {
      if (!next_line()) {
        lines_.bytes().fail(fmt::format("the file ends behind {} of {} requests", i, count),
                            steps_hint);
      }
      take_request();
    }
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    const std::size_t requests = head_.channels.size() / values_each;
    std::vector<double> all(head_.channels.size());
    std::vector<bool> is_wanted(head_.channels.size());
    for (const std::size_t channel : columns) is_wanted[channel] = true;
    std::vector<double> values(columns.size());
    bool any = false;
    for (; next_line(); any = true) {
      double time = 0.0;
      read_numbers(lines_, lines_.line(), 1, &time, steps_hint);
      time *= time_.factor;
      if (const auto trouble = block.trouble_of_time(time)) {
        lines_.fail(1, trouble->message, trouble->hint);
      }
      for (std::size_t i = 0; i < requests; ++i) {
        if (!next_line()) {
          lines_.bytes().fail(fmt::format("the file ends within the step at {} s: {} of {} "
                                          "requests are there",
                                          time, i, requests),
                              steps_hint);
        }
        double* const six = &all[i * values_each];
        read_numbers(lines_, lines_.line(), values_each, six, steps_hint);
        for (std::size_t k = 0; k < values_each; ++k) {
          if (!is_wanted[i * values_each + k]) continue;
          const auto trouble = RowBlock::trouble_of_value(six[k]);
          if (trouble) lines_.fail(1, trouble->message, trouble->hint);
        }
      }
      for (std::size_t k = 0; k < columns.size(); ++k) values[k] = all[columns[k]];
      block.take(time, values.data());
    }
    if (!any) lines_.bytes().fail("the file has no steps", steps_hint);
  }

 private:
  static constexpr std::size_t values_each = 6;

  bool next_line() {
    while (lines_.next()) {
      if (!trimmed(lines_.line()).empty()) return true;
    }
    return false;
  }

  /// "nReq UCF": how many, and the factor of the model's units, which enters no value here.
  std::size_t number_of_requests() {
    double numbers[2] = {};
    read_numbers(lines_, lines_.line(), 2, numbers, steps_hint);
    const double count = numbers[0];
    // Each has a line of at least "1 4 0 0 0" and six numbers a step.
    const double most = static_cast<double>(lines_.bytes().size()) / 10.0;
    const bool whole = count >= 1.0 && count <= 1e6 &&
                       count == static_cast<double>(static_cast<std::size_t>(count));
    if (!whole || count > most) {
      lines_.fail(
          1,
          fmt::format("{} requests cannot be in a file of {} bytes", count, lines_.bytes().size()),
          steps_hint);
    }
    return static_cast<std::size_t>(count);
  }

  void take_request() {
    double numbers[5] = {};
    read_numbers(lines_, lines_.line(), 5, numbers, steps_hint);
    const bool whole =
        numbers[0] >= 0.0 && numbers[0] <= 1e9 && numbers[1] >= 0.0 && numbers[1] <= 100.0;
    if (!whole) lines_.fail(1, "this is no request", steps_hint);
    static constexpr const char* of_force[] = {"FX", "FY", "FZ", "TX", "TY", "TZ"};
    constexpr double force = 4.0;
    for (std::size_t k = 0; k < values_each; ++k) {
      const std::string component = numbers[1] == force ? of_force[k] : std::to_string(k + 1);
      head_.channels.push_back({fmt::format("{:.0f}.{}", numbers[0], component), {}});
    }
  }

  TextLines lines_;
  NumberRows::Time time_;
};

}  // namespace

OpenedSignals open_request_table(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<RequestTableReader>(std::move(bytes), source);
}

OpenedSignals open_request_steps(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<RequestStepsReader>(std::move(bytes), source);
}

}  // namespace boxbeam
