#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "drawing.hpp"

namespace boxbeam::plot {

/// Values over every pair of a value of x and one of y.
struct GridOfValues {
  std::vector<double> x, y;    ///< increasing
  std::vector<double> values;  ///< those of x first; not a number where there is none

  /// Between its places, which count from 0, in proportion.
  double at(double column, double row) const;
  Eigen::Vector2d place(double column, double row) const;
};

/// Values by their places; nothing where these are not every pair of at least three of each, once.
std::optional<GridOfValues> grid_of(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& values);

/// Where a grid of values, in proportion between its places, passes a level: lines from edge to
/// edge of its fields, the higher side always on the same hand. Fields without a value have none.
/// Source: marching squares, by the mean of the corners where two ways are open.
std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> level_lines(const GridOfValues& of,
                                                                     double level);

}  // namespace boxbeam::plot
