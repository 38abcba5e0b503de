#include <fmt/format.h>

#include <utility>

#include "number_rows.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* sensor_hint =
    "give a sensor file as Exudyn writes it: lines with #, then the time and the values, commas "
    "between them";

/// Source: files of Exudyn 1.13; its manual, sensors.
class ExudynReader : public SignalReader {
 public:
  ExudynReader(SignalBytes bytes, const SignalSource& source) : lines_(std::move(bytes)) {
    head_.path = source.path;
    head_.format = SignalFormat::exudyn;
    refuse_time_step(lines_.bytes(), source);
    time_.column = 0;
    time_.factor = source.time_unit.value_or(1.0);
    bool has_row = false;
    while (!has_row && lines_.next()) {
      const std::string_view line = trimmed(lines_.line());
      if (line.starts_with('#')) take_head_line(line);
      has_row = !line.empty() && !line.starts_with('#');
    }
    if (!has_row) lines_.bytes().fail("the file has no rows", sensor_hint);
    if (!begins_with_number(lines_.line())) {
      lines_.fail(1, "this is neither a row of numbers nor a line with #", sensor_hint);
    }
    const std::size_t width = fields_of(lines_.line(), ',').size();
    if (width < 2) lines_.fail(1, "a row holds the time and at least one value", sensor_hint);
    if (values_told_ && *values_told_ + 1 != width) {
      lines_.fail(1,
                  fmt::format("the head tells {} sensor values, here {} {} behind the time",
                              *values_told_, width == 2 ? "is" : "are", width - 1),
                  sensor_hint);
    }
    for (std::size_t i = 1; i < width; ++i) {
      const std::string axis = width == 4 ? std::string(1, "xyz"[i - 1]) : std::to_string(i);
      head_.channels.push_back({width == 2 ? kind_ : fmt::format("{}.{}", kind_, axis), {}});
    }
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    std::vector<std::size_t> wanted;
    for (const std::size_t channel : columns) wanted.push_back(channel + 1);
    NumberRows rows(lines_, {}, head_.channels.size() + 1, wanted, time_, block);
    do {
      const std::string_view line = lines_.line();
      const std::string_view text = trimmed(line);
      if (text.empty() || text.starts_with('#')) continue;
      rows.take(line);
    } while (lines_.next());
  }

 private:
  void take_head_line(std::string_view line) {
    const auto behind = [&](std::string_view key) -> std::optional<std::string> {
      if (!line.starts_with(key)) return std::nullopt;
      return utf8_of(trimmed(line.substr(key.size())));
    };
    if (const auto kind = behind("#OutputVariableType ="); kind && !kind->empty()) kind_ = *kind;
    if (const auto count = behind("#number of sensor values =")) {
      const bool digits = !count->empty() && count->size() <= 6 &&
                          count->find_first_not_of("0123456789") == std::string::npos;
      if (!digits)
        lines_.fail(1, fmt::format("\"{}\" is no number of values", *count), sensor_hint);
      values_told_ = std::stoul(*count);
    }
  }

  TextLines lines_;
  std::string kind_ = "value";
  std::optional<std::size_t> values_told_;
  NumberRows::Time time_;
};

}  // namespace

OpenedSignals open_exudyn_sensor(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<ExudynReader>(std::move(bytes), source);
}

}  // namespace boxbeam
