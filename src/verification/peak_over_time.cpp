#include "boxbeam/verification/peak_over_time.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace boxbeam {

SampledTime sampled_time_of(const LoadHistory& loads) {
  SampledTime span{{}, loads.begin().value(), loads.period().value()};
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    const LoadHistory::Reach reach = loads.reach_of(i);
    span.instants.push_back({loads.time_of(i).value(), reach.from.value(), reach.to.value()});
  }
  return span;
}

Extremum peak_over_time(const std::vector<double>& values, const SampledTime& span,
                        const std::function<double(double)>& f) {
  assert(!values.empty() && values.size() == span.instants.size());
  const std::size_t n = values.size();
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  Extremum peak{span.instants[static_cast<std::size_t>(highest - values.begin())].at, *highest};
  // Waves of round-off have no peaks.
  const double nothing = 1e-9 * std::max(std::abs(*lowest), std::abs(*highest));
  if (n < 3 || *highest - *lowest <= nothing) return peak;
  for (std::size_t i = 0; i < n; ++i) {
    const SampledInstant& at = span.instants[i];
    const double before = at.from < at.at ? values[(i + n - 1) % n] : values[i];
    const double behind = at.to > at.at ? values[(i + 1) % n] : values[i];
    if (values[i] < before || values[i] < behind) continue;
    const double bend = 2.0 * values[i] - before - behind;
    if (bend <= nothing || values[i] + bend < peak.value) continue;
    const Extremum found = find_maximum(f, at.from, at.to);
    if (found.value > peak.value) peak = found;
  }
  if (peak.at < span.begin) peak.at += span.period;
  if (peak.at > span.begin + span.period) peak.at -= span.period;
  return peak;
}

}  // namespace boxbeam
