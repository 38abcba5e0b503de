#pragma once

#include <vector>

#include "boxbeam/verification/stress_points.hpp"

namespace boxbeam {

/// A point on a hole's edge moved to the place with the largest stress (yield), or where the cycles
/// of all situations and changes leave the smallest factor (fatigue), at the instants of all
/// motions; any other point as it is.
StressPoint at_worst_edge(const Project& project, const StressPoint& point,
                          const std::vector<SituationHistory>& histories, Criterion criterion);

/// A point on a stretch of wall moved to the place where a criterion is worst: equivalent stress,
/// direct, shear or combined fatigue, range over its limit, at the instants of all motions. Each
/// local maximum on a grid (10 degrees of a round tube, a twelfth of a straight wall) that may be
/// the largest is found by Brent's method, so that a round tube has no favoured direction.
/// Fatigue counts one cycle per situation and change, from its smallest to its largest stress: with
/// cycles inside that do more damage elsewhere on the wall, the place is only near the worst one.
StressPoint at_worst_on_stretch(const Project& project, const StressPoint& point,
                                const std::vector<SituationHistory>& histories,
                                Criterion criterion);

}  // namespace boxbeam
