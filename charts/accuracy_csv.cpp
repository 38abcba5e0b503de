#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "charts/accuracy.hpp"

namespace boxbeam {
namespace {

/// A field, in quotes where it holds what would end it.
/// Source: RFC 4180, 2.5 to 2.7.
std::string field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

/// With the fewest digits that are read back as the same number.
std::string field(double number) { return fmt::format("{}", number); }

std::string field(const std::optional<double>& number) { return number ? field(*number) : ""; }

std::string flag(bool yes) { return yes ? "yes" : ""; }

std::string line_of(const std::vector<std::string>& fields) {
  return fmt::format("{}\n", fmt::join(fields, ","));
}

}  // namespace

std::string chart_csv(const charts::Chart& chart) {
  const std::string operations = chart.operations.empty() ? "operations" : chart.operations;
  std::string out =
      line_of({"method", "setting", "parameter", field(operations), "time_median_s", "time_low_s",
               "time_high_s", "error", "failure", "default", "yardstick"});
  for (const charts::Series& series : chart.series) {
    for (const charts::Point& point : series.points) {
      const bool failed = !point.failure.empty();
      out += line_of({field(series.method), field(point.setting), field(point.parameter),
                      field(point.operations), point.time ? field(point.time->median) : "",
                      point.time ? field(point.time->low) : "",
                      point.time ? field(point.time->high) : "", failed ? "" : field(point.error),
                      field(point.failure), flag(point.is_default), flag(series.yardstick)});
    }
  }
  return out;
}

std::string map_csv(const charts::Map& map) {
  const std::string value = map.value.empty() ? "value" : map.value;
  std::string out = line_of(
      {"method", field(map.x.title), field(map.y.title), "outcome", field(value), "reason"});
  for (const charts::MapPanel& panel : map.panels) {
    for (const charts::Cell& cell : panel.cells) {
      out += line_of({field(panel.method), field(cell.x), field(cell.y),
                      charts::to_text(cell.outcome), field(cell.value), field(cell.reason)});
    }
  }
  return out;
}

}  // namespace boxbeam
