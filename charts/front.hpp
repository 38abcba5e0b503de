#pragma once

#include <vector>

#include "charts/chart.hpp"

namespace boxbeam::charts {

/// By what methods are weighed.
enum class CostBy {
  operations,  ///< the same on every machine
  time,
};

/// A setting and its method.
struct Better {
  const Series* series;
  const Point* point;
};

/// Settings that are better than the default of a chart: at no larger error for less than two
/// thirds of its cost, or at no larger cost with less than two thirds of its error. Errors below
/// the floor of the chart, and below 1e-15, are alike. Where
/// operations are a circumstance, only settings in the same are weighed. Nothing where the chart
/// has no default, or cost is not known.
std::vector<Better> better_than_default(const Chart& chart, CostBy by);

/// Likewise by operations where these are counted, else by time.
std::vector<Better> better_than_default(const Chart& chart);

}  // namespace boxbeam::charts
