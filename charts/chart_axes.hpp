#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "charts/chart.hpp"
#include "charts/log_axis.hpp"

/// The axes of a work-precision diagram: what they show of a chart.
namespace boxbeam::plot {

/// Errors beyond these are drawn at the ends of the axis.
inline constexpr double least_error = 1e-22, most_error = 1e6;

/// What a panel's abscissa is.
struct Abscissa {
  std::function<std::optional<double>(const charts::Point&)> of;
  std::string title;
  TicStyle tics = TicStyle::number;
  bool time = false;        ///< points have a spread
  bool operations = false;  ///< by which orders are defined
};

/// Whether any point of a chart is so.
bool any_point(const charts::Chart& chart, const std::function<bool(const charts::Point&)>& holds);

/// Work, time, or both; where there is neither, the settings themselves.
std::vector<Abscissa> abscissas_of(const charts::Chart& chart);

/// Where a point stands on an abscissa: one without a cost of its own at that of the nearest
/// setting of its series, if any has one.
std::optional<double> place_of(const charts::Series& series, std::size_t i,
                               const Abscissa& abscissa);

/// What is seen of a chart's errors.
struct ErrorAxis {
  LogAxis axis;
  bool shows_floor = false;
};

/// An axis of a length [px]. A floor far below all errors is not shown: it would take the room of
/// what is.
ErrorAxis error_axis(const charts::Chart& chart, double length);

LogAxis cost_axis(const charts::Chart& chart, const Abscissa& abscissa, double length);

}  // namespace boxbeam::plot
