#include "charts/chart_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "charts/front.hpp"

namespace boxbeam {
namespace {

/// "1e-04" as "1e-4", "1.0e+01" as "1.0e1".
std::string short_power(std::string number) {
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return number;
  if (number[e + 1] == '+') number.erase(e + 1, 1);
  const std::size_t first = e + (number[e + 1] == '-' ? 2 : 1);
  while (first + 1 < number.size() && number[first] == '0') number.erase(first, 1);
  return number;
}

}  // namespace

bool has_failed(const charts::Point& point) {
  return !point.failure.empty() || !std::isfinite(point.error);
}

std::vector<FailedSettings> failures_of(const charts::Chart& chart) {
  std::vector<FailedSettings> failures;
  for (const charts::Series& series : chart.series) {
    const auto first = static_cast<std::ptrdiff_t>(failures.size());
    for (const charts::Point& point : series.points) {
      if (!has_failed(point)) continue;
      const std::string reason = point.failure.empty() ? "its error is no number" : point.failure;
      const auto same =
          std::find_if(failures.begin() + first, failures.end(),
                       [&](const FailedSettings& other) { return other.reason == reason; });
      if (same != failures.end())
        same->settings.push_back(point.setting);
      else
        failures.push_back({series.method, {point.setting}, reason});
    }
  }
  return failures;
}

std::string settings_text(const std::vector<std::string>& settings) {
  constexpr std::size_t most = 3;
  if (settings.size() <= most) return fmt::format("{}", fmt::join(settings, ", "));
  return fmt::format("{} to {} ({} settings)", settings.front(), settings.back(), settings.size());
}

std::vector<DefaultSetting> defaults_of(const charts::Chart& chart) {
  std::vector<DefaultSetting> found;
  for (const charts::Series& series : chart.series) {
    for (const charts::Point& point : series.points) {
      if (point.is_default) found.push_back({&series, &point});
    }
  }
  return found;
}

std::string standing_of(const charts::Chart& chart, const charts::Point& point) {
  if (has_failed(point)) return "failed";
  const double error = std::abs(point.error);
  if (error < chart.needed_low) return "better";
  return error <= chart.needed_high ? "within" : "coarser";
}

std::string front_text(const charts::Chart& chart) {
  const std::vector<charts::Better> better = charts::better_than_default(chart);
  if (better.empty()) return "";
  const auto cheapest = std::min_element(
      better.begin(), better.end(), [](const charts::Better& a, const charts::Better& b) {
        if (a.point->operations && b.point->operations)
          return *a.point->operations < *b.point->operations;
        return a.point->time && b.point->time && a.point->time->median < b.point->time->median;
      });
  std::string text =
      fmt::format("Better than the default: {}", setting_text({cheapest->series, cheapest->point}));
  if (better.size() > 1) text += fmt::format(" and {} more", better.size() - 1);
  return chart.off_front.empty() ? text + "." : fmt::format("{}. {}", text, chart.off_front);
}

std::string setting_text(const DefaultSetting& setting) {
  if (setting.point->setting.empty()) return setting.series->method;
  return fmt::format("{}, {}", setting.series->method, setting.point->setting);
}

std::string error_text(const charts::Point& point) {
  if (has_failed(point)) return "failed";
  if (point.error == 0.0) return "0";
  return short_power(fmt::format("{:.1e}", std::abs(point.error)));
}

std::string needed_text(const charts::Chart& chart) {
  const auto text = [](double error) {
    std::string number = short_power(fmt::format("{:.1e}", error));
    const std::size_t zero = number.find(".0e");
    if (zero != std::string::npos) number.erase(zero, 2);
    return number;
  };
  return fmt::format("{} to {}", text(chart.needed_low), text(chart.needed_high));
}

std::string duration_text(double seconds) {
  constexpr int digits = 3;
  if (!(seconds > 0.0)) return "0";
  if (seconds < 0.9995e-6) return text::significant(1e9 * seconds, digits) + " ns";
  if (seconds < 0.9995e-3) return text::significant(1e6 * seconds, digits) + " us";
  if (seconds < 0.9995) return text::significant(1e3 * seconds, digits) + " ms";
  return text::significant(seconds, digits) + " s";
}

}  // namespace boxbeam
