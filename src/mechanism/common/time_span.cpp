#include "boxbeam/mechanism/common/time_span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// Whether loads are looked at at the points of a table, between which they are straight.
bool followed_by_points(const DriverUse& use, const DriverTiming& timing) {
  return use.on != DriverUse::On::joint && timing.mean_omega.has_value();
}

}  // namespace

double waves_of(const TimeSpan& span, int most) {
  const double waves = span.length * span.highest_omega / full_turn;
  if (8.0 * waves <= most) return waves;
  throw AnalysisError(
      {fmt::format("the time looked at, {:.6g} s, holds {:.6g} waves of the fastest driver or "
                   "force; up to {} can be resolved: give a shorter [motion] duration",
                   span.length, waves, most / 8),
       "mechanism"});
}

namespace {

/// Of forces from tables whose points are as far apart as their smallest distance, all waves; of
/// others those of the mean distance, and at least so many in the time looked at.
void count_edges(const std::vector<DriverUse>& uses, TimeSpan& span) {
  constexpr double waves = 256.0;
  const double fewest = waves * full_turn / span.length;
  for (const DriverUse& use : uses) {
    const DriverTiming timing = timing_of(*use.driver, use.turning);
    if (!followed_by_points(use, timing)) continue;
    const double counted =
        std::min(timing.highest_omega, std::max(fewest, 2.0 * *timing.mean_omega));
    span.steeper = span.steeper || counted < timing.highest_omega;
    span.highest_omega = std::max(span.highest_omega, counted);
  }
}

}  // namespace

TimeSpan time_span_of(const std::vector<DriverUse>& uses, const Duration& duration) {
  TimeSpan span;
  std::vector<double> omegas;
  double end = 0.0;
  bool endless = false;
  for (const DriverUse& use : uses) {
    const DriverTiming timing = timing_of(*use.driver, use.turning);
    omegas.insert(omegas.end(), timing.omegas.begin(), timing.omegas.end());
    span.closed = span.closed && timing.repeats;
    if (!followed_by_points(use, timing))
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
         "mechanism"});
  }
  count_edges(uses, span);
  return span;
}

std::vector<Break> breaks_of(const std::vector<DriverUse>& uses, double from, double until) {
  std::vector<Break> all;
  for (const DriverUse& use : uses) {
    const std::vector<Break> own = breaks_of(*use.driver, from, until);
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end(), [](const Break& a, const Break& b) {
    return a.at < b.at || (a.at == b.at && a.order < b.order);
  });
  // Points of two tables that are meant to be the same time may differ by rounding.
  const double same = 1e-12 * std::max({std::abs(from), std::abs(until), until - from});
  std::vector<Break> breaks;
  for (const Break& each : all) {
    if (!breaks.empty() && each.at - breaks.back().at <= same)
      breaks.back().order = std::min(breaks.back().order, each.order);
    else
      breaks.push_back(each);
  }
  return breaks;
}

}  // namespace boxbeam
