#include "mixed_stress.hpp"

#include <algorithm>
#include <array>

// The widest instructions of the machine; a product is rounded before it is added (no contraction
// in this build), so that all give the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define BOXBEAM_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define BOXBEAM_WIDE
#endif

namespace boxbeam {
namespace {

BOXBEAM_WIDE void add_six(const double* factors, const double* values, std::size_t stride,
                          double* stresses, std::size_t count) {
  const double a = factors[0], b = factors[1], c = factors[2], d = factors[3], e = factors[4],
               f = factors[5];
  const double* __restrict x0 = values;
  const double* __restrict x1 = values + stride;
  const double* __restrict x2 = values + 2 * stride;
  const double* __restrict x3 = values + 3 * stride;
  const double* __restrict x4 = values + 4 * stride;
  const double* __restrict x5 = values + 5 * stride;
  double* __restrict to = stresses;
  for (std::size_t i = 0; i < count; ++i)
    to[i] = to[i] + a * x0[i] + b * x1[i] + c * x2[i] + d * x3[i] + e * x4[i] + f * x5[i];
}

BOXBEAM_WIDE void add_one(double factor, const double* values, double* stresses,
                          std::size_t count) {
  const double* __restrict x = values;
  double* __restrict to = stresses;
  for (std::size_t i = 0; i < count; ++i) to[i] += factor * x[i];
}

constexpr std::size_t lanes = 16;

BOXBEAM_WIDE void widen_ends(const double* values, std::size_t groups, double* low, double* high) {
  for (std::size_t i = 0; i < groups; ++i) {
    for (std::size_t j = 0; j < lanes; ++j) {
      const double value = values[i * lanes + j];
      low[j] = value < low[j] ? value : low[j];
      high[j] = value > high[j] ? value : high[j];
    }
  }
}

}  // namespace

Ends ends_of(std::span<const double> values) {
  std::array<double, lanes> low{}, high{};
  low.fill(values.front());
  high.fill(values.front());
  const std::size_t groups = values.size() / lanes;
  widen_ends(values.data(), groups, low.data(), high.data());
  Ends ends{*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
  for (const double value : values.subspan(groups * lanes)) {
    ends.lowest = std::min(ends.lowest, value);
    ends.highest = std::max(ends.highest, value);
  }
  return ends;
}

void mix_stress(std::span<const double> factors, const double* values, std::size_t stride,
                std::span<double> stresses) {
  std::fill(stresses.begin(), stresses.end(), factors[0]);
  constexpr std::size_t together = 6;
  std::size_t k = 1;
  for (; k + together <= factors.size(); k += together) {
    add_six(factors.data() + k, values + (k - 1) * stride, stride, stresses.data(),
            stresses.size());
  }
  for (; k < factors.size(); ++k)
    add_one(factors[k], values + (k - 1) * stride, stresses.data(), stresses.size());
}

}  // namespace boxbeam
