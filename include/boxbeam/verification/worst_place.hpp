#pragma once

#include <span>

#include "boxbeam/verification/wall_search.hpp"

namespace boxbeam {

/// A point on a hole's edge moved to the places where each of some criteria is worst, in their
/// order: equivalent stress, or the cycles of the whole life, at whatever angle; any other point as
/// it is.
std::vector<StressPoint> at_worst_edges(const StationSamples& samples, const StressPoint& point,
                                        std::span<const Criterion> asked);

/// The points of a station, those on edges moved to where each of `stress_criteria` is worst.
struct StationPoints {
  std::vector<StressPoint> points;  ///< of edges without their places
  /// By `stress_criteria`, of each point; empty where it lies on no edge.
  std::vector<std::vector<StressPoint>> on_edges;
  /// Of each stretch among the points, in their order, once it was asked for.
  std::vector<StretchUses> along = {};
};

StationPoints station_points_of(const StationSamples& samples, std::vector<StressPoint> points);

/// A point on a stretch of wall moved to the place where a criterion is worst. Each local maximum
/// on a grid (10 degrees of a round tube, a twelfth of a straight wall) that may be the largest is
/// found by Brent's method, so that a round tube has no favoured direction.
StressPoint at_worst_on_stretch(const StationSamples& samples, const StressPoint& point,
                                Criterion criterion);

/// The point at a part of its stretch.
StressPoint moved_along(const StressPoint& point, double part);

}  // namespace boxbeam
