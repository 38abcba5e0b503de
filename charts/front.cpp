#include "charts/front.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace boxbeam::charts {
namespace {

constexpr double much = 1.5;  ///< a factor of cost or error that counts

std::optional<double> cost_of(const Chart& chart, const Point& point, CostBy by) {
  if (by == CostBy::operations) return chart.operations_cost ? point.operations : std::nullopt;
  return point.time ? std::optional(point.time->median) : std::nullopt;
}

}  // namespace

std::vector<Better> better_than_default(const Chart& chart, CostBy by) {
  const Point* const own = default_point(chart);
  if (own == nullptr || !own->failure.empty()) return {};
  const std::optional<double> cost = cost_of(chart, *own, by);
  if (!cost) return {};
  const double floor = std::max(1e-15, chart.floor ? chart.floor->error : 0.0);
  const auto error_of = [&](const Point& point) { return std::max(floor, std::abs(point.error)); };
  std::vector<Better> better;
  for (const Series& series : chart.series) {
    if (series.other_scene) continue;
    for (const Point& point : series.points) {
      const std::optional<double> other = cost_of(chart, point, by);
      if (!point.failure.empty() || !std::isfinite(point.error) || !other) continue;
      if (!chart.operations_cost && point.operations != own->operations) continue;
      const bool cheaper = much * *other < *cost && error_of(point) <= error_of(*own);
      const bool closer = *other <= *cost && much * error_of(point) < error_of(*own);
      if (cheaper || closer) better.push_back({&series, &point});
    }
  }
  return better;
}

std::vector<Better> better_than_default(const Chart& chart) {
  const Point* const own = default_point(chart);
  const bool counted = own != nullptr && cost_of(chart, *own, CostBy::operations).has_value();
  return better_than_default(chart, counted ? CostBy::operations : CostBy::time);
}

}  // namespace boxbeam::charts
