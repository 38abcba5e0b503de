#include "boxbeam/fatigue/rainflow_kernels.hpp"

#include <algorithm>

#if defined(__x86_64__) && defined(__GNUC__)
#define BOXBEAM_AVX512 1
#include <immintrin.h>
#endif

namespace boxbeam {
namespace {

// Which ranges both neighbours enclose. For peaks p, p' and valleys v, v' in the order v- p v p'
// v':
//
//     p-v   closes where  v- < v   and  p <= p'
//     v-p'  closes where  p  > p'  and  v >= v'
//
// One comparison of each point with the next of its kind, "it rises", decides all. Of two equal
// ranges side by side at most one closes, never the one that holds the start of the history, as by
// three points (ASTM E1049-85, 5.4.4). Closing inner cycles first changes no cycle.

bool step(Course& course, double sample) {
  const bool up = (sample > course.last) | ((sample >= course.last) & course.up);
  const bool turned = up != course.up;
  course = {sample, up};
  return turned;
}

std::size_t write_turns_plain(std::span<const double> samples, Course& course, double* turns) {
  Course now = course;
  std::size_t count = 0;
  for (const double sample : samples) {
    turns[count] = now.last;
    count += step(now, sample) ? 1 : 0;
  }
  course = now;
  return count;
}

/// From the first peak on.
std::size_t close_enclosed_from_peak(double* turns, std::size_t count, CycleArrays& cycles) {
  std::size_t closed = cycles.count;
  std::size_t kept = 0;
  std::size_t i = 0;
  bool valley_rose = false;  // nothing stands before the first peak
  bool before_closed = false;
  double peak = turns[0];
  double valley = turns[1];
  for (; i + 3 < count; i += 2) {
    const double next_peak = turns[i + 2];
    const double next_valley = turns[i + 3];
    const bool peak_rises = next_peak >= peak;
    const bool valley_rises = next_valley > valley;
    const bool falling_closes = valley_rose & peak_rises;
    const bool rising_closes = !(peak_rises | valley_rises);
    const double top = std::min(peak, next_peak);
    cycles.range[closed] = top - valley;
    cycles.mean[closed] = 0.5 * (top + valley);
    closed += (falling_closes | rising_closes) ? 1 : 0;
    turns[kept] = peak;
    kept += (falling_closes | before_closed) ? 0 : 1;
    turns[kept] = valley;
    kept += (falling_closes | rising_closes) ? 0 : 1;
    before_closed = rising_closes;
    valley_rose = valley_rises;
    peak = next_peak;
    valley = next_valley;
  }
  turns[kept] = peak;
  kept += before_closed ? 0 : 1;
  for (++i; i < count; ++i) turns[kept++] = turns[i];
  cycles.count = closed;
  return kept;
}

std::size_t close_enclosed_plain(double* turns, std::size_t count, bool peak_first,
                                 CycleArrays& cycles) {
  const std::size_t skipped = peak_first ? 0 : 1;
  return skipped + close_enclosed_from_peak(turns + skipped, count - skipped, cycles);
}

#ifdef BOXBEAM_AVX512

// The same, eight at a time: a comparison gives eight bits, and "compress" moves the marked ones
// of eight numbers together.

constexpr std::size_t lanes = 8;

__attribute__((target("avx512f,popcnt"))) std::size_t append(double* to, unsigned marked,
                                                             __m512d values) {
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(marked), values));
  return static_cast<std::size_t>(__builtin_popcount(marked));
}

__attribute__((target("avx512f,popcnt"))) std::size_t write_turns_avx512(
    std::span<const double> samples, Course& course, double* turns) {
  if (samples.empty()) return 0;
  turns[0] = course.last;
  std::size_t count = step(course, samples.front()) ? 1 : 0;
  unsigned up = course.up ? 1 : 0;
  std::size_t i = 1;
  for (; i + lanes <= samples.size(); i += lanes) {
    const __m512d before = _mm512_loadu_pd(&samples[i - 1]);
    const __m512d sample = _mm512_loadu_pd(&samples[i]);
    const unsigned above = _mm512_cmp_pd_mask(sample, before, _CMP_GT_OQ);
    const unsigned not_below = _mm512_cmp_pd_mask(sample, before, _CMP_GE_OQ);
    // The way is up after a rise, and on a plateau where it was: so runs the carry of an addition.
    // Bit k: whether the way to the sample before number k is up.
    const unsigned ups = above ^ not_below ^ (above + not_below + up);
    count += append(turns + count, (ups ^ (ups >> 1U)) & 0xFFU, before);
    up = ups >> lanes;
  }
  course = {samples[i - 1], up != 0};
  return count + write_turns_plain(samples.subspan(i), course, turns + count);
}

__attribute__((target("avx512f,popcnt"))) std::size_t close_enclosed_avx512(double* turns,
                                                                            std::size_t count,
                                                                            bool peak_first,
                                                                            CycleArrays& cycles) {
  constexpr unsigned peaks = 0x55;
  constexpr unsigned valleys = 0xAA;
  const std::size_t skipped = peak_first ? 0 : 1;
  double* const t = turns + skipped;
  const std::size_t n = count - skipped;
  // Of the last two or three points, a neighbour is missing; the last store may reach over them.
  const std::size_t decided = (n - 2) / 2 * 2;
  const double rest[] = {t[decided], t[decided + 1], t[n - 1]};

  double* range = cycles.range + cycles.count;
  double* mean = cycles.mean + cycles.count;
  std::size_t kept = 0;
  unsigned rose = 0;           // nothing stands before the first peak
  unsigned before_closed = 0;  // the range before the first of the eight
  for (std::size_t i = 0; i < decided; i += lanes) {
    const std::size_t here = std::min(lanes, decided - i);
    const unsigned valid = (1U << here) - 1U;
    const __m512d point = _mm512_loadu_pd(t + i);
    const __m512d neighbour = _mm512_loadu_pd(t + i + 1);
    const __m512d next = _mm512_loadu_pd(t + i + 2);
    const unsigned rises = (_mm512_cmp_pd_mask(next, point, _CMP_GE_OQ) & peaks) |
                           (_mm512_cmp_pd_mask(next, point, _CMP_GT_OQ) & valleys);
    const unsigned before_rises = (rises << 1U) | rose;
    const unsigned closes =
        ((rises & before_rises & peaks) | (~(rises | before_rises) & valleys)) & valid;
    const unsigned stays = ~(closes | (closes << 1U) | before_closed) & valid;
    range += append(range, closes, _mm512_abs_pd(_mm512_sub_pd(point, neighbour)));
    mean +=
        append(mean, closes, _mm512_mul_pd(_mm512_set1_pd(0.5), _mm512_add_pd(point, neighbour)));
    kept += append(t + kept, stays, point);
    rose = rises >> (lanes - 1);
    before_closed = closes >> (here - 1);
  }
  const std::size_t last_stay = n - decided - before_closed;
  std::copy_n(rest + before_closed, last_stay, t + kept);
  cycles.count = static_cast<std::size_t>(range - cycles.range);
  return kept + last_stay + skipped;
}

constexpr RainflowKernels avx512_kernels{write_turns_avx512, close_enclosed_avx512};

#endif

}  // namespace

const RainflowKernels plain_kernels{write_turns_plain, close_enclosed_plain};

const RainflowKernels& fastest_kernels() {
#ifdef BOXBEAM_AVX512
  static const bool has_avx512 = __builtin_cpu_supports("avx512f") > 0;
  if (has_avx512) return avx512_kernels;
#endif
  return plain_kernels;
}

}  // namespace boxbeam
