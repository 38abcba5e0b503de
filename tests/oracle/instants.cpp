#include "instants.hpp"

#include <algorithm>
#include <array>
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

FOR_WIDE_REGISTERS std::pair<double, double> extremes_of(std::span<const double> values) {
  constexpr std::size_t lanes = 16;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, lanes> low, high;
  low.fill(infinity);
  high.fill(-infinity);
  const double* of = values.data();
  std::size_t k = 0;
  for (; k + lanes <= values.size(); k += lanes) {
    for (std::size_t i = 0; i < lanes; ++i) {
      low[i] = of[k + i] < low[i] ? of[k + i] : low[i];
      high[i] = of[k + i] > high[i] ? of[k + i] : high[i];
    }
  }
  for (; k < values.size(); ++k) {
    low[0] = std::min(low[0], of[k]);
    high[0] = std::max(high[0], of[k]);
  }
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
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
