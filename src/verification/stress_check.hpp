#pragma once

#include <optional>
#include <vector>

#include "channel_life.hpp"

namespace boxbeam {

/// A check of a stress but for partial factors and the factors that are asked for, on which nothing
/// in it depends: where, when, the cycles and what resists them.
struct StressCheck {
  CheckResult result;
  std::vector<LifeChannel> channels = {};  ///< in fatigue
  ChannelLife life = {};
  /// With all these factors 1; as `StationSamples` judges the place.
  double use = 0.0;
};

/// The checks of checks.hpp, so far. Nothing where the point has none.
std::optional<StressCheck> plain_yield(PointHistory& of);
std::optional<StressCheck> plain_fatigue(PointHistory& of, Criterion criterion);
std::optional<StressCheck> plain_range(PointHistory& of);
std::optional<StressCheck> plain_throat(const Project& project,
                                        const std::vector<SituationHistory>& histories,
                                        const StressPoint& point);

/// Such a check with the factors of a case.
CheckResult with_partial_factors(const Project& project, StressCheck of);

}  // namespace boxbeam
