#include "charts/damage_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <utility>

#include "boxbeam/fatigue/spectrum.hpp"

namespace boxbeam::charts {
namespace {

/// Turned so that the whole goes from -120 to 120 MPa.
Samples spread(Samples samples) {
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  const double middle = 0.5 * (*low + *high), scale = largest_range / (*high - *low);
  for (double& x : samples) x = scale * (x - middle);
  return samples;
}

/// x_i = a x_(i-1) + b x_(i-2) + noise: random, but the same on every machine.
Samples filtered_noise(double a, double b) {
  std::mt19937_64 random(1049);
  Samples samples;
  samples.reserve(sample_count);
  double before = 0.0, last = 0.0;
  for (std::size_t i = 0; i < sample_count; ++i) {
    // Sum of four uniform numbers, close to normal.
    double noise = -2.0;
    for (int k = 0; k < 4; ++k) noise += std::ldexp(static_cast<double>(random() >> 11U), -53);
    const double x = a * last + b * before + noise;
    before = std::exchange(last, x);
    samples.push_back(x);
  }
  return spread(std::move(samples));
}

/// Damage of one cycle.
double damage_per_cycle(const SnLine& line, double range) {
  return 1.0 / line.cycles_to_failure(range, Loading::spectrum);
}

/// Counting as the texts have it: a stack of turning points, three at a time. Source: ASTM
/// E1049-85, 5.4.4.
template <class Take>
void count_by_stack(const Samples& samples, const Take& take) {
  Samples points;
  const auto close = [&](bool last) {
    while (points.size() >= (last ? 2U : 3U)) {
      const std::size_t n = points.size();
      if (last) {
        take(std::abs(points[n - 1] - points[n - 2]), 0.5);
        points.pop_back();
        continue;
      }
      const double X = std::abs(points[n - 1] - points[n - 2]);
      const double Y = std::abs(points[n - 2] - points[n - 3]);
      if (X < Y) return;
      take(Y, n == 3 ? 0.5 : 1.0);
      if (n == 3) {
        points.erase(points.begin());
      } else {
        points.erase(points.end() - 3, points.end() - 1);
      }
    }
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double x = samples[i];
    const bool turns = i == 0 || i + 1 == samples.size() ||
                       (samples[i - 1] < x && samples[i + 1] < x) ||
                       (samples[i - 1] > x && samples[i + 1] > x);
    if (!turns) continue;
    points.push_back(x);
    close(false);
  }
  close(true);
}

}  // namespace

Samples wide_band() { return filtered_noise(0.9, 0.0); }

Samples narrow_band() {
  const double omega = 2.0 * std::numbers::pi * 0.05;
  const double decay = std::exp(-0.01 * omega);
  return filtered_noise(2.0 * decay * std::cos(omega), -decay * decay);
}

Samples harmonics() {
  Samples samples;
  samples.reserve(sample_count);
  for (std::size_t i = 0; i < sample_count; ++i) {
    const auto t = static_cast<double>(i);
    samples.push_back(std::sin(0.02 * t) + 0.5 * std::sin(0.02 * std::numbers::sqrt2 * t) +
                      0.3 * std::sin(0.02 * std::numbers::phi * 2.0 * t));
  }
  return spread(std::move(samples));
}

SnCurve category_100() { return en_1993_1_9_direct(100.0); }

SnCurve one_slope(double m) {
  SnCurve curve = category_100();
  curve.name = fmt::format("m = {:.0f}", m);
  curve.branches = {{m, std::numeric_limits<double>::infinity()}};
  curve.constant_amplitude_limit.reset();
  curve.cut_off.reset();
  return curve;
}

double exact_damage(const Samples& samples, const SnCurve& curve) {
  const SnLine line(curve);
  long double sum = 0.0L;
  count_by_stack(samples, [&](double range, double count) {
    sum += static_cast<long double>(count) * damage_per_cycle(line, range);
  });
  return static_cast<double>(sum);
}

double streamed_damage(const Samples& samples, const SnCurve& curve, std::size_t chunk,
                       const RainflowKernels& kernels) {
  SpectrumCollector collector(curve, {}, false);
  RainflowCounter counter(
      {}, [&](const CycleBatch& batch) { collector.add(batch); }, kernels);
  for (std::size_t at = 0; at < samples.size(); at += chunk) {
    counter.push(std::span(samples).subspan(at, std::min(chunk, samples.size() - at)));
  }
  counter.finish();
  return collector.damage();
}

double damage_in_memory(const Samples& samples, const SnCurve& curve) {
  return damage_of(count_cycles(samples), curve, {});
}

double stack_damage(const Samples& samples, const SnCurve& curve) {
  const SnLine line(curve);
  double sum = 0.0;
  count_by_stack(samples,
                 [&](double range, double count) { sum += count * damage_per_cycle(line, range); });
  return sum;
}

double separate_damage(const Samples& samples, const SnCurve& curve, std::size_t chunk) {
  SpectrumCollector collector(curve, {}, false);
  RainflowCounter counter({}, [&](const CycleBatch& batch) { collector.add(batch); });
  for (std::size_t at = 0; at < samples.size(); at += chunk) {
    counter.push(std::span(samples).subspan(at, std::min(chunk, samples.size() - at)));
    counter.finish();
  }
  return collector.damage();
}

double damage_in_classes(const Samples& samples, const SnCurve& curve, int classes, Stands stands) {
  const SnLine line(curve);
  const double width = largest_range / classes;
  Samples counts(static_cast<std::size_t>(classes), 0.0), sums(counts);
  RainflowCounter counter({}, [&](const CycleBatch& batch) {
    for (const double range : batch.range) {
      const auto k = std::min(static_cast<std::size_t>(range / width), counts.size() - 1);
      counts[k] += batch.count;
      sums[k] += batch.count * range;
    }
  });
  counter.push(samples);
  counter.finish();
  double damage = 0.0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] == 0.0) continue;
    const double place = stands == Stands::middle ? 0.5 : 1.0;
    const double range =
        stands == Stands::mean ? sums[k] / counts[k] : width * (static_cast<double>(k) + place);
    damage += counts[k] * damage_per_cycle(line, range);
  }
  return damage;
}

double damage_from_matrix(const Samples& samples, const SnCurve& curve, int classes) {
  const double width = largest_range / classes;
  Samples moved(samples.size());
  std::transform(samples.begin(), samples.end(), moved.begin(), [&](double x) {
    const double k = std::floor((x + 0.5 * largest_range) / width);
    return (std::min(k, classes - 1.0) + 0.5) * width;
  });
  return streamed_damage(moved, curve, moved.size(), fastest_kernels());
}

double cycles_of(const Samples& samples) {
  double cycles = 0.0;
  count_by_stack(samples, [&](double, double) { cycles += 1.0; });
  return cycles;
}

}  // namespace boxbeam::charts
