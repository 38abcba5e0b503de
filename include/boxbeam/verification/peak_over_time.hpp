#pragma once

#include <functional>
#include <vector>

#include "boxbeam/numerics/extremum.hpp"

namespace boxbeam {

/// Equally spaced instants over a time that is looked at.
struct SampledTime {
  double begin = 0.0;  ///< [s]
  double step = 0.0;   ///< [s]
  bool closed = true;  ///< behind the last instant comes the first; else the last is the end
};

/// The largest value over time of a function, of which the values at the instants are known.
/// Every instant that is higher than its neighbours, and from which a parabola with eight times the
/// bend of the three values could still reach the highest, is looked around by `find_maximum`; so
/// several peaks of nearly one height are told apart. The instant itself counts, for it may be a
/// corner of the function. The time is within the span.
/// Precondition: at least one value; `f` can be evaluated within the span, and, where that is
/// closed, a step before and behind it.
Extremum peak_over_time(const std::vector<double>& values, const SampledTime& span,
                        const std::function<double(double)>& f);

}  // namespace boxbeam
