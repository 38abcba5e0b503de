#include "boxbeam/mechanism/common/time_span.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam {

TimeSpan time_span_of(const std::vector<DriverUse>& uses, const Duration& duration) {
  TimeSpan span;
  std::vector<double> omegas;
  double end = 0.0;
  bool endless = false;
  for (const DriverUse& use : uses) {
    const DriverTiming timing = timing_of(*use.driver, use.turning);
    omegas.insert(omegas.end(), timing.omegas.begin(), timing.omegas.end());
    span.closed = span.closed && timing.repeats;
    span.highest_omega = std::max(span.highest_omega, timing.highest_omega);
    end = std::max(end, timing.end);
    endless = endless || (!timing.repeats && timing.end <= 0.0);
  }
  span.begin = duration.settle;
  const std::optional<double> period = common_period_of(omegas);
  if (duration.length > 0.0) {
    span.length = duration.length;
    // A duration that holds whole periods, on drivers that repeat, is a closed motion.
    const double periods = period ? span.length / *period : 0.5;
    span.closed = span.closed && std::abs(periods - std::round(periods)) < 1e-9 * periods;
  } else if (span.closed && period) {
    span.length = *period;
  } else if (!span.closed && end > 0.0 && omegas.empty() && !endless) {
    span.length = end - span.begin;
  }
  if (!(span.length > 0.0)) {
    throw AnalysisError(
        {"it is not known how long the motion lasts: drivers and forces have no common period "
         "(within 1000 cycles of the fastest), or some repeat and others end; give [motion] "
         "duration",
         "mechanism",
         {},
         {},
         {}});
  }
  return span;
}

}  // namespace boxbeam
