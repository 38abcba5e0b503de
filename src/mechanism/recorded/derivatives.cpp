#include "boxbeam/mechanism/recorded/derivatives.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace boxbeam::recorded {
namespace {

struct Derivatives {
  double first = 0.0, second = 0.0;
};

/// Of the polynomial through some points at a place: Newton's divided differences, by Horner.
Derivatives derivatives_at(double place, const double* times, const double* values,
                           std::size_t count) {
  std::array<double, 5> c{};
  std::copy_n(values, count, c.begin());
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t k = count - 1; k >= order; --k)
      c[k] = (c[k] - c[k - 1]) / (times[k] - times[k - order]);
  }
  double value = c[count - 1];
  Derivatives of;
  for (std::size_t k = count - 1; k-- > 0;) {
    const double x = place - times[k];
    of.second = of.second * x + 2.0 * of.first;
    of.first = of.first * x + value;
    value = value * x + c[k];
  }
  return of;
}

/// Whether the steps between five points are so even that one polynomial through them is no guess.
bool is_even(const double* times) {
  double least = times[1] - times[0], most = least;
  for (std::size_t k = 1; k < 4; ++k) {
    least = std::min(least, times[k + 1] - times[k]);
    most = std::max(most, times[k + 1] - times[k]);
  }
  return most <= 2.0 * least;
}

}  // namespace

std::pair<std::vector<double>, std::vector<double>> derivatives_of(
    const std::vector<double>& times, const std::vector<double>& values) {
  const std::size_t n = times.size();
  assert(n >= 2 && values.size() == n);
  std::vector<double> first(n), second(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool inner = n >= 5 && i > 0 && i + 1 < n;
    const std::size_t five = inner ? std::clamp<std::size_t>(i, 2, n - 3) - 2 : 0;
    const bool by_five = inner && is_even(times.data() + five);
    const std::size_t count = by_five ? 5 : std::min<std::size_t>(n, 3);
    const std::size_t from =
        by_five ? five : (n < 3 ? 0 : std::clamp<std::size_t>(i, 1, n - 2) - 1);
    const Derivatives of =
        derivatives_at(times[i], times.data() + from, values.data() + from, count);
    first[i] = of.first;
    second[i] = of.second;
  }
  return {std::move(first), std::move(second)};
}

ShortestWave shortest_wave_of(const std::vector<double>& times, const std::vector<double>& values) {
  ShortestWave shortest;
  if (values.empty()) return shortest;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double least = 0.3 * (*high - *low);
  if (!(least > 0.0)) return shortest;
  // Turning points between which the series changes by that much: the last one moves on as long as
  // the series goes on in its direction.
  std::vector<std::size_t> turns{0};
  double direction = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = values[i] - values[turns.back()];
    if (direction == 0.0 ? std::abs(change) >= least : change * direction <= -least) {
      turns.push_back(i);
      direction = change;
    } else if (change * direction > 0.0) {
      turns.back() = i;
    }
  }
  // The first and the last one are ends of the series, no turning points.
  if (turns.size() == 4) return {2 * (turns[2] - turns[1]), times[turns[1]]};
  for (std::size_t k = 1; k + 3 < turns.size(); ++k) {
    const std::size_t instants = turns[k + 2] - turns[k];
    if (shortest.instants != 0 && instants >= shortest.instants) continue;
    shortest = {instants, times[turns[k + 1]]};
  }
  return shortest;
}

}  // namespace boxbeam::recorded
