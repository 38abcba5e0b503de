#include "instants.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FOR_WIDE_REGISTERS \
  __attribute__((target_clones("avx512f", "avx2", "default"), optimize("O3")))
#else
#define FOR_WIDE_REGISTERS
#endif

namespace oracle {

FOR_WIDE_REGISTERS void add_times(double factor, std::span<const double> values,
                                  std::span<double> sum) {
  const double* from = values.data();
  double* to = sum.data();
  for (std::size_t k = 0; k < sum.size(); ++k) to[k] += factor * from[k];
}

/// Several neighbours at once; the compiler divides it for narrower registers.
using Lanes = double __attribute__((vector_size(64)));
constexpr std::size_t lanes = sizeof(Lanes) / sizeof(double);

FOR_WIDE_REGISTERS std::pair<double, double> extremes_of(std::span<const double> values) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Lanes low = Lanes{} + infinity, high = Lanes{} - infinity;
  Lanes other_low = low, other_high = high;  // two chains: one waits less for the other
  const double* of = values.data();
  std::size_t k = 0;
  for (; k + 2 * lanes <= values.size(); k += 2 * lanes) {
    Lanes here, next;
    std::memcpy(&here, of + k, sizeof here);
    std::memcpy(&next, of + k + lanes, sizeof next);
    low = here < low ? here : low;
    high = here > high ? here : high;
    other_low = next < other_low ? next : other_low;
    other_high = next > other_high ? next : other_high;
  }
  double lowest = infinity, highest = -infinity;
  for (; k < values.size(); ++k) {
    lowest = std::min(lowest, of[k]);
    highest = std::max(highest, of[k]);
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    lowest = std::min({lowest, low[i], other_low[i]});
    highest = std::max({highest, high[i], other_high[i]});
  }
  return {lowest, highest};
}

FOR_WIDE_REGISTERS std::int64_t changes_of(std::span<const double> values) {
  const double* of = values.data();
  std::int64_t changes = 0;
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    const std::int64_t grew = of[k] > of[k - 1] ? 1 : 0, grows = of[k + 1] > of[k] ? 1 : 0;
    changes += grew ^ grows;
  }
  return changes;
}

}  // namespace oracle
