#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "boxbeam/verification/life_cycles.hpp"
#include "boxbeam/verification/station_samples.hpp"
#include "boxbeam/verification/turning_samples.hpp"

/// The extremes between instants of what is known at these: of the parabola through each extreme
/// instant and its neighbours.
namespace boxbeam {

/// Steps on from an instant within the piece of the history it belongs to, between whose instants
/// nothing jumps or bends.
class InstantsBeside {
 public:
  InstantsBeside(const SampledInstants& of, std::size_t instant) : of_(&of), instant_(instant) {}

  struct Place {
    std::size_t instant = 0;
    double time = 0.0;  ///< beyond the end of a history that repeats its time goes on
  };

  /// The next instant in a direction (1 or -1) that lies apart from the one before it by more than
  /// a part of `step`: two that almost coincide tell nothing of a slope.
  std::optional<Place> next(Place from, long direction, double step) const {
    constexpr double apart = 0.05;
    const auto n = static_cast<long>(of_->times.size());
    Place place = from;
    double turned = from.time - of_->times[from.instant];
    for (;;) {
      const long to = static_cast<long>(place.instant) + direction;
      const auto at = static_cast<std::size_t>(to < 0 ? to + n : to >= n ? to - n : to);
      if (at == instant_ || of_->begins[direction > 0 ? at : place.instant]) return std::nullopt;
      if (to < 0) turned -= of_->period;
      if (to >= n) turned += of_->period;
      place = {at, of_->times[at] + turned};
      if (std::abs(place.time - from.time) > apart * step) return place;
    }
  }

 private:
  const SampledInstants* of_;
  std::size_t instant_;
};

/// The largest value near an instant that is as high as its neighbours: of the parabola through
/// it and one on each side, or, where the history jumps or bends beside it, two on the other side.
/// Without it the largest sample would change from place to place, and what varies smoothly along
/// the beam or a wall would have many small maxima.
template <class ValueAt>
double peak_near(const ValueAt& value_at, std::size_t i, double sign, const SampledInstants& of) {
  const double at = sign * value_at(i);
  const double step = of.period / static_cast<double>(of.times.size());
  const InstantsBeside neighbours(of, i);
  const InstantsBeside::Place own{i, of.times[i]};
  const std::optional<InstantsBeside::Place> before = neighbours.next(own, -1, step);
  const std::optional<InstantsBeside::Place> behind = neighbours.next(own, 1, step);
  std::optional<InstantsBeside::Place> further;
  if (before && behind) {
    further = behind;
  } else if (before) {
    further = neighbours.next(*before, -1, step);
  } else if (behind) {
    further = neighbours.next(*behind, 1, step);
  }
  if (!further) return at;
  const InstantsBeside::Place& near = before ? *before : *behind;
  const auto rise_to = [&](const InstantsBeside::Place& place) {
    return sign * value_at(place.instant) - at;
  };
  const double h = near.time - own.time, k = further->time - own.time;
  const double bend = (rise_to(near) / h - rise_to(*further) / k) / (h - k);
  const double slope = rise_to(near) / h - bend * h;
  if (!(bend < 0.0)) return at;
  const double top = -0.5 * slope / bend;
  const double first = std::min({h, k, 0.0}), last = std::max({h, k, 0.0});
  if (!(top > first && top < last)) return at;
  return std::max(at, at + top * (slope + bend * top));
}

/// The largest of what grows with `values` and is no less than zero.
template <class ValueAt>
double largest_of(const std::vector<double>& values, const ValueAt& value_at,
                  const SampledInstants& instants) {
  double largest = 0.0;
  const std::size_t n = values.size();
  // None is above its neighbours that is not a peak.
  const auto look_at = [&](std::size_t before, std::size_t i, std::size_t behind) {
    if (values[i] >= values[before] && values[i] >= values[behind])
      largest = std::max(largest, peak_near(value_at, i, 1.0, instants));
  };
  look_at(n - 1, 0, n > 1 ? 1 : 0);
  for (std::size_t i = 1; i + 1 < n; ++i) look_at(i - 1, i, i + 1);
  if (n > 1) look_at(n - 2, n - 1, 0);
  return largest;
}

inline double largest_of(const std::vector<double>& values, const SampledInstants& instants) {
  return largest_of(
      values, [&](std::size_t i) { return values[i]; }, instants);
}

/// The turning points of a stress in order of time, without their instants.
inline void find_turns(const std::vector<double>& values, const SampledInstants& instants,
                       TurningSamples& found, SituationTurns& of) {
  of.begin = values.front();
  of.end = instants.closed ? values.front() : values.back();
  of.turns.clear();
  find_turning_samples(values, found);
  if (found.turns.empty()) of.turns.push_back({Time{}, values[found.highest], true});
  for (const auto& [i, maximum] : found.turns) {
    const double sign = maximum ? 1.0 : -1.0;
    const auto value_at = [&](std::size_t k) { return values[k]; };
    of.turns.push_back({Time{}, sign * peak_near(value_at, i, sign, instants), maximum});
  }
}

}  // namespace boxbeam
