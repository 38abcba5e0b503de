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

namespace {

FOR_WIDE_REGISTERS void set_to(const Term& a, const Term& b, std::span<double> sum) {
  const double *of_a = a.values.data(), *of_b = b.values.data();
  double* to = sum.data();
  for (std::size_t k = 0; k < sum.size(); ++k) to[k] = a.factor * of_a[k] + b.factor * of_b[k];
}

FOR_WIDE_REGISTERS void add_to(const Term& a, const Term& b, std::span<double> sum) {
  const double *of_a = a.values.data(), *of_b = b.values.data();
  double* to = sum.data();
  for (std::size_t k = 0; k < sum.size(); ++k) to[k] += a.factor * of_a[k] + b.factor * of_b[k];
}

}  // namespace

void add_up(std::span<const Term> terms, std::span<double> sum) {
  if (terms.empty()) std::fill(sum.begin(), sum.end(), 0.0);
  for (std::size_t i = 0; i < terms.size(); i += 2) {
    const Term nothing{0.0, terms[i].values};
    const Term& next = i + 1 < terms.size() ? terms[i + 1] : nothing;
    if (i == 0)
      set_to(terms[i], next, sum);
    else
      add_to(terms[i], next, sum);
  }
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

namespace {

/// Whether each of the values behind the first grows over the one before it, in bytes of 0 and 1.
FOR_WIDE_REGISTERS void write_growth(const double* of, std::size_t count, std::uint8_t* grows) {
  for (std::size_t k = 0; k < count; ++k) grows[k] = of[k + 1] > of[k] ? 1 : 0;
}

}  // namespace

std::size_t keep_turns(std::span<double> values) {
  if (values.size() < 3) return values.size();
  double* const of = values.data();
  constexpr std::size_t block = 256, word = sizeof(std::uint64_t);
  std::uint8_t grows[block + word] = {};
  std::size_t kept = 1;  // never in front of what is still to be read, other than by its own value
  std::size_t k = 1;
  while (k + 1 < values.size()) {
    const std::size_t inner = std::min(block - 1, values.size() - 1 - k);
    write_growth(of + k - 1, inner + 1, grows);
    for (std::size_t i = 0; i < inner; i += word) {
      std::uint64_t before, behind;
      std::memcpy(&before, grows + i, word);
      std::memcpy(&behind, grows + i + 1, word);
      if (before == behind && i + word <= inner) continue;
      for (std::size_t j = i; j < std::min(i + word, inner); ++j) {
        if (grows[j] != grows[j + 1]) of[kept++] = of[k + j];
      }
    }
    k += inner;
  }
  of[kept++] = of[values.size() - 1];
  return kept;
}

}  // namespace oracle
