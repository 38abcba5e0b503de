#include "charts/chart_axes.hpp"

#include <algorithm>
#include <cmath>

#include "charts/chart_text.hpp"

namespace boxbeam::plot {

using charts::Chart;
using charts::Point;
using charts::Series;

bool any_point(const Chart& chart, const std::function<bool(const Point&)>& holds) {
  return std::any_of(chart.series.begin(), chart.series.end(), [&](const Series& series) {
    return std::any_of(series.points.begin(), series.points.end(), holds);
  });
}

std::vector<Abscissa> abscissas_of(const Chart& chart) {
  std::vector<Abscissa> all;
  if (any_point(chart, [](const Point& point) { return point.operations.has_value(); })) {
    all.push_back({[](const Point& point) { return point.operations; },
                   chart.operations.empty() ? "operations" : chart.operations, TicStyle::number,
                   false, true});
  }
  if (any_point(chart, [](const Point& point) { return point.time.has_value(); })) {
    all.push_back({[](const Point& point) {
                     return point.time ? std::optional(point.time->median) : std::nullopt;
                   },
                   chart.unit.empty() ? "time" : "time per " + chart.unit, TicStyle::time, true,
                   false});
  }
  if (all.empty()) {
    all.push_back({[](const Point& point) { return std::optional(point.parameter); }, "setting",
                   TicStyle::number, false, false});
  }
  return all;
}

std::optional<double> place_of(const Series& series, std::size_t i, const Abscissa& abscissa) {
  for (std::size_t apart = 0; apart < series.points.size(); ++apart) {
    if (apart <= i) {
      if (const auto x = abscissa.of(series.points[i - apart])) return x;
    }
    if (i + apart < series.points.size()) {
      if (const auto x = abscissa.of(series.points[i + apart])) return x;
    }
  }
  return std::nullopt;
}

ErrorAxis error_axis(const Chart& chart, double length) {
  constexpr double far_below = 1e-4;
  // The band of what is needed never fills the panel.
  LogContent content{{0.1 * chart.needed_low, 10.0 * chart.needed_high}, false, false};
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      content.beyond = content.beyond || has_failed(point);
      if (has_failed(point)) continue;
      content.numbers.push_back(std::abs(point.error));
      content.zero = content.zero || point.error == 0.0;
    }
  }
  double lowest = most_error;
  for (const double error : content.numbers) {
    if (error > 0.0) lowest = std::min(lowest, error);
  }
  const bool shows_floor = chart.floor && chart.floor->error >= far_below * lowest;
  // So that it is seen above the end of the axis.
  if (shows_floor) content.numbers.push_back(0.5 * chart.floor->error);
  return {log_axis(content, length, least_error, most_error, true), shows_floor};
}

LogAxis cost_axis(const Chart& chart, const Abscissa& abscissa, double length) {
  LogContent content;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      const std::optional<double> x = abscissa.of(point);
      if (!x) continue;
      content.numbers.push_back(*x);
      content.zero = content.zero || *x <= 0.0;
      if (!abscissa.time || !point.time) continue;
      content.numbers.push_back(point.time->low);
      content.numbers.push_back(point.time->high);
    }
  }
  return log_axis(content, length, 1e-12, 1e18, false);
}

}  // namespace boxbeam::plot
