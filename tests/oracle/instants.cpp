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

/// As many neighbours as AVX2 compares at once: of wider ones GCC 12 compares every number alone
/// and passes it through memory.
using Lanes = double __attribute__((vector_size(32)));
constexpr std::size_t lanes = sizeof(Lanes) / sizeof(double);
constexpr std::size_t chains = 4;  // one waits less for the other

FOR_WIDE_REGISTERS std::pair<double, double> extremes_of(std::span<const double> values) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Lanes low[chains], high[chains];
  for (std::size_t c = 0; c < chains; ++c) {
    low[c] = Lanes{} + infinity;
    high[c] = Lanes{} - infinity;
  }
  const double* of = values.data();
  std::size_t k = 0;
  for (; k + chains * lanes <= values.size(); k += chains * lanes) {
    for (std::size_t c = 0; c < chains; ++c) {
      Lanes here;
      std::memcpy(&here, of + k + c * lanes, sizeof here);
      low[c] = here < low[c] ? here : low[c];
      high[c] = here > high[c] ? here : high[c];
    }
  }
  double lowest = infinity, highest = -infinity;
  for (; k < values.size(); ++k) {
    lowest = std::min(lowest, of[k]);
    highest = std::max(highest, of[k]);
  }
  for (std::size_t c = 0; c < chains; ++c) {
    for (std::size_t i = 0; i < lanes; ++i) {
      lowest = std::min(lowest, low[c][i]);
      highest = std::max(highest, high[c][i]);
    }
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
