#include "boxbeam/verification/peak_over_time.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace boxbeam {

Extremum peak_over_time(const std::vector<double>& values, const SampledTime& span,
                        const std::function<double(double)>& f) {
  assert(!values.empty());
  const std::size_t n = values.size();
  const auto time_of = [&](std::size_t i) {
    return span.begin + span.step * static_cast<double>(i);
  };
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  Extremum peak{time_of(static_cast<std::size_t>(highest - values.begin())), *highest};
  // Waves of round-off have no peaks.
  const double nothing = 1e-9 * std::max(std::abs(*lowest), std::abs(*highest));
  if (n < 3 || *highest - *lowest <= nothing) return peak;
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0 && !span.closed, last = i + 1 == n && !span.closed;
    const double before = first ? values[i] : values[(i + n - 1) % n];
    const double behind = last ? values[i] : values[(i + 1) % n];
    if (values[i] < before || values[i] < behind) continue;
    const double bend = 2.0 * values[i] - before - behind;
    if (bend <= nothing || values[i] + bend < peak.value) continue;
    const double low = time_of(i) - (first ? 0.0 : span.step);
    const double high = time_of(i) + (last ? 0.0 : span.step);
    const Extremum found = find_maximum(f, low, high);
    if (found.value > peak.value) peak = found;
  }
  const double period = span.step * static_cast<double>(n);
  if (span.closed && peak.at < span.begin) peak.at += period;
  if (span.closed && peak.at >= span.begin + period) peak.at -= period;
  return peak;
}

}  // namespace boxbeam
