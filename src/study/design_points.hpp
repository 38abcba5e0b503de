#pragma once

#include <string>
#include <vector>

#include "boxbeam/study/reliability.hpp"

namespace boxbeam {

/// What a search for design points found.
struct DesignPoints {
  std::vector<DesignPoint> points;  ///< the nearest first, those that count
  /// The median design fails: the points are those of the designs that do not, as if these failed.
  bool mean_fails = false;
  std::string reason;  ///< why none can be told; "" where there are points
};

/// Searches a limit state for the points at which failure is next to the origin, from the mean and
/// from other starts: iHL-RF with line search, differences in place of derivatives. A point counts
/// where it is nearest among its neighbours, by the curvatures of the limit state there. Where the
/// mean fails the same is done of the designs that do not.
/// Sources: Hasofer, Lind (1974); Rackwitz, Fiessler (1978); Zhang, Der Kiureghian, Two improved
/// algorithms for reliability analysis (1995).
DesignPoints design_points_of(LimitState& limit_state, const ReliabilityDemand& demand,
                              std::uint64_t seed);

}  // namespace boxbeam
