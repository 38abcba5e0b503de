#pragma once

#include <functional>
#include <vector>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/load_history.hpp"

namespace boxbeam {

/// An instant, and from when to when a function is smooth about it: at most to its neighbours.
struct SampledInstant {
  double at = 0.0, from = 0.0, to = 0.0;  ///< [s]
};

/// Ascending instants over a time that is looked at.
struct SampledTime {
  std::vector<SampledInstant> instants;
  double begin = 0.0, period = 0.0;  ///< [s]
};

/// The instants of a load history, up to the times at which loads jump or bend.
SampledTime sampled_time_of(const LoadHistory& loads);

/// The largest value over time of a function, of which the values at the instants are known.
/// Every instant that is higher than its neighbours, and from which a parabola with eight times the
/// bend of the three values could still reach the highest, is looked around by `find_maximum`; so
/// several peaks of nearly one height are told apart. The instant itself counts, for it may be a
/// corner of the function. The time is within the span.
/// Precondition: at least one value; `f` can be evaluated wherever an instant reaches.
Extremum peak_over_time(const std::vector<double>& values, const SampledTime& span,
                        const std::function<double(double)>& f);

}  // namespace boxbeam
