#include "boxbeam/fatigue/rainflow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/fatigue/spectrum.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using Samples = std::vector<double>;

constexpr std::size_t sample_count = std::size_t{1} << 17U;
constexpr double MPa = 1e6;
constexpr double largest_range = 240.0 * MPa;  ///< of every history
constexpr const char* unit = "history of 131 072 samples";

// ---- histories ------------------------------------------------------------------------------

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

Samples wide_band() { return filtered_noise(0.9, 0.0); }

/// About a frequency of 0.05 per sample, damped by 1 % of the critical.
Samples narrow_band() {
  const double omega = 2.0 * std::numbers::pi * 0.05;
  const double decay = std::exp(-0.01 * omega);
  return filtered_noise(2.0 * decay * std::cos(omega), -decay * decay);
}

/// Three harmonics whose frequencies have no common period.
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

// ---- damage ---------------------------------------------------------------------------------

SnCurve category_100() { return en_1993_1_9_direct(100.0); }

/// range^m N = constant, without end.
SnCurve one_slope(double m) {
  SnCurve curve = category_100();
  curve.name = fmt::format("m = {:.0f}", m);
  curve.branches = {{m, std::numeric_limits<double>::infinity()}};
  curve.constant_amplitude_limit.reset();
  curve.cut_off.reset();
  return curve;
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

/// The truth: every cycle by itself, summed in long double.
double exact_damage(const Samples& samples, const SnCurve& curve) {
  const SnLine line(curve);
  long double sum = 0.0L;
  count_by_stack(samples, [&](double range, double count) {
    sum += static_cast<long double>(count) * damage_per_cycle(line, range);
  });
  return static_cast<double>(sum);
}

/// As the program does it: counted in chunks as they come, each cycle's damage by itself.
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

/// Each chunk a history of its own: what spans two of them is lost.
double separate_damage(const Samples& samples, const SnCurve& curve, std::size_t chunk) {
  SpectrumCollector collector(curve, {}, false);
  RainflowCounter counter({}, [&](const CycleBatch& batch) { collector.add(batch); });
  for (std::size_t at = 0; at < samples.size(); at += chunk) {
    counter.push(std::span(samples).subspan(at, std::min(chunk, samples.size() - at)));
    counter.finish();
  }
  return collector.damage();
}

/// What stands for the cycles of a class.
enum class Stands { middle, upper_edge, mean };

/// Cycles gathered in equal classes of range first, damage once per class.
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

/// Samples moved to the middle of their class of stress first, as a from-to matrix needs it.
double damage_from_matrix(const Samples& samples, const SnCurve& curve, int classes) {
  const double width = largest_range / classes;
  Samples moved(samples.size());
  std::transform(samples.begin(), samples.end(), moved.begin(), [&](double x) {
    const double k = std::floor((x + 0.5 * largest_range) / width);
    return (std::min(k, classes - 1.0) + 0.5) * width;
  });
  return streamed_damage(moved, curve, moved.size(), fastest_kernels());
}

// ---- charts ---------------------------------------------------------------------------------

Trial tried(std::string setting, double parameter, double operations, double exact,
            const std::function<double()>& damage) {
  Trial trial;
  trial.point.setting = std::move(setting);
  trial.point.parameter = parameter;
  trial.point.operations = operations;
  trial.point.error = std::abs(damage() / exact - 1.0);
  trial.work = [damage] { keep(damage()); };
  return trial;
}

std::vector<int> class_counts(const Effort& effort) {
  return effort.quick ? std::vector{16, 32, 64, 128, 256}
                      : std::vector{8, 16, 32, 64, 128, 256, 512, 1024};
}

TriedMethod over_classes(std::string method, const Effort& effort, double exact,
                         const std::function<double(int)>& damage) {
  TriedMethod tried_method{std::move(method), {}, true};
  for (const int n : class_counts(effort)) {
    tried_method.trials.push_back(
        tried(fmt::format("{} classes", n), n, n, exact, [=] { return damage(n); }));
  }
  return tried_method;
}

double cycles_of(const Samples& samples) {
  double cycles = 0.0;
  count_by_stack(samples, [&](double, double) { cycles += 1.0; });
  return cycles;
}

const Point& at_setting(const Series& series, double parameter) {
  return *std::find_if(series.points.begin(), series.points.end(),
                       [&](const Point& point) { return point.parameter == parameter; });
}

Chart classes_chart(const Effort& effort) {
  const Samples samples = wide_band();
  const SnCurve curve = category_100();
  const double exact = exact_damage(samples, curve);
  std::vector<TriedMethod> methods;
  methods.push_back({"every cycle by itself, streamed", {}, false});
  methods[0].trials.push_back(
      tried("no classes", 0.0, cycles_of(samples), exact, [&samples, curve] {
        return streamed_damage(samples, curve, samples.size(), fastest_kernels());
      }));
  methods[0].trials[0].point.is_default = true;
  const auto in_classes = [&](const char* name, Stands stands) {
    methods.push_back(over_classes(name, effort, exact, [&samples, curve, stands](int n) {
      return damage_in_classes(samples, curve, n, stands);
    }));
  };
  in_classes("classes of range, their middle", Stands::middle);
  in_classes("classes of range, their upper edge", Stands::upper_edge);
  in_classes("classes of range, the mean of their cycles", Stands::mean);
  methods.push_back(over_classes("from-to matrix", effort, exact, [&samples, curve](int n) {
    return damage_from_matrix(samples, curve, n);
  }));
  Chart chart;
  chart.name = "rainflow-classes";
  chart.title = "Rainflow: damage from cycles in classes";
  chart.scene = "wide-band noise, ranges up to 240 MPa, EN 1993-1-9 category 100";
  chart.error = "relative error of the damage sum";
  chart.reference = "every cycle by itself, plain stack, summed in long double";
  chart.operations = "classes";
  chart.unit = unit;
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 1}, {1.0, 2}};
  chart.floor = ErrorLevel{1e-14, "round-off of the sum"};
  chart.lesson = fmt::format(
      "With the usual 64 classes the damage is off by {:.1e} by the middle of a class, {:.1e} by "
      "its "
      "upper edge, {:.1e} from a from-to matrix. Each cycle by itself is exact and needs no "
      "choice; "
      "classes are for showing a spectrum only.",
      at_setting(chart.series[1], 64.0).error, at_setting(chart.series[2], 64.0).error,
      at_setting(chart.series[4], 64.0).error);
  return chart;
}

Chart slopes_chart(const Effort& effort) {
  struct Case {
    const char* name;
    Samples samples;
    SnCurve curve;
  };
  const Samples wide = wide_band();
  const std::vector<Case> cases{{"wide band, m = 3", wide, one_slope(3.0)},
                                {"wide band, m = 5", wide, one_slope(5.0)},
                                {"wide band, EN category 100", wide, category_100()},
                                {"narrow band, EN category 100", narrow_band(), category_100()},
                                {"three harmonics, EN category 100", harmonics(), category_100()}};
  std::vector<TriedMethod> methods;
  for (const Case& of : cases) {
    methods.push_back(over_classes(
        of.name, effort, exact_damage(of.samples, of.curve),
        [&of](int n) { return damage_in_classes(of.samples, of.curve, n, Stands::middle); }));
  }
  Chart chart;
  chart.name = "rainflow-histories";
  chart.title = "Rainflow: classes against kind of history and slope";
  chart.scene = "classes of range, their middle; ranges up to 240 MPa";
  chart.error = "relative error of the damage sum";
  chart.reference = "every cycle by itself, plain stack, summed in long double";
  chart.operations = "classes";
  chart.unit = unit;
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 3}};
  const auto off_by = [&](std::size_t series) {
    return at_setting(chart.series[series], 64.0).error;
  };
  chart.lesson = fmt::format(
      "At 64 classes the damage is off by {:.0e} (m = 3), {:.0e} (m = 5) and {:.0e} (with the "
      "cut-off, below which nothing counts) on one history, by {:.0e} and {:.0e} on others: what "
      "classes cost depends on the history, and nobody sees it in the result.",
      off_by(0), off_by(1), off_by(2), off_by(3), off_by(4));
  return chart;
}

/// Reversals below a threshold left out; its neighbours join.
Samples without_small(const Samples& samples, double threshold) {
  Samples kept{samples.front()};
  double extreme = samples.front();
  bool up = true, begun = false;
  for (const double x : samples) {
    if (!begun) {
      if (std::abs(x - kept.front()) < threshold) continue;
      begun = true;
      up = x > kept.front();
      extreme = x;
    } else if (up ? x >= extreme : x <= extreme) {
      extreme = x;
    } else if (std::abs(x - extreme) >= threshold) {
      kept.push_back(extreme);
      up = !up;
      extreme = x;
    }
  }
  if (begun) kept.push_back(extreme);
  return kept;
}

Chart filter_chart(const Effort& effort) {
  const Samples samples = wide_band();
  const std::vector<double> parts =
      effort.quick ? std::vector{0.4, 0.2, 0.1, 0.05, 0.025}
                   : std::vector{0.5, 0.4, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.035, 0.025, 0.01};
  const double whole = static_cast<double>(without_small(samples, 1e-9).size());
  std::vector<TriedMethod> methods;
  for (const SnCurve& curve : {one_slope(3.0), one_slope(5.0), category_100()}) {
    const double exact = exact_damage(samples, curve);
    TriedMethod method{curve.name == "100" ? "EN category 100" : curve.name, {}, true};
    for (const double part : parts) {
      const double kept = static_cast<double>(without_small(samples, part * largest_range).size());
      method.trials.push_back(
          tried(fmt::format("below {:g} % left out", 100.0 * part), part, kept, exact,
                [&samples, curve, part] {
                  const Samples left = without_small(samples, part * largest_range);
                  return streamed_damage(left, curve, left.size(), fastest_kernels());
                }));
    }
    methods.push_back(method);
  }
  const double exact = exact_damage(samples, category_100());
  TriedMethod all{"nothing left out, EN category 100", {}, false};
  all.trials.push_back(tried("all reversals", 0.0, whole, exact, [&samples] {
    return streamed_damage(samples, category_100(), samples.size(), fastest_kernels());
  }));
  all.trials[0].point.is_default = true;
  methods.insert(methods.begin(), all);
  Chart chart;
  chart.name = "rainflow-filter";
  chart.title = "Rainflow: small ranges left out before counting";
  chart.scene = "wide-band noise, ranges up to 240 MPa";
  chart.error = "relative error of the damage sum";
  chart.reference = "every cycle by itself, plain stack, summed in long double";
  chart.operations = "turning points left";
  chart.operations_cost = false;  // nor is what leaving them out costs
  chart.unit = unit;
  chart.series = timed(methods, effort);
  chart.floor = ErrorLevel{1e-14, "round-off of the sum"};
  chart.lesson = fmt::format(
      "Leaving out ranges below 5 % of the largest costs {:.0e} of the damage at m = 3, {:.0e} at "
      "m = 5 and {:.0e} with the cut-off of the standard, which lies above them here. "
      "Counting keeps nothing but its residue, so that nothing need be left out.",
      at_setting(chart.series[1], 0.05).error, at_setting(chart.series[2], 0.05).error,
      at_setting(chart.series[3], 0.05).error);
  return chart;
}

Chart chunks_chart(const Effort& effort) {
  constexpr std::size_t read_at_once = 16384;  // by the reader of tables
  const Samples samples = wide_band();
  const SnCurve curve = category_100();
  const double exact = exact_damage(samples, curve);
  std::vector<TriedMethod> methods{{"streamed, residue kept", {}, false},
                                   {"streamed, kernels for every machine", {}, false},
                                   {"each chunk by itself", {}, true}};
  const std::vector<std::size_t> chunks =
      effort.quick ? std::vector<std::size_t>{64, 1024, 16384}
                   : std::vector<std::size_t>{1, 8, 64, 256, 1024, 4096, 16384, 65536};
  for (const std::size_t chunk : chunks) {
    const auto n = static_cast<double>(chunk);
    const std::string setting = fmt::format("{} samples at once", chunk);
    methods[0].trials.push_back(tried(setting, n, n, exact, [&samples, curve, chunk] {
      return streamed_damage(samples, curve, chunk, fastest_kernels());
    }));
    methods[0].trials.back().point.is_default = chunk == read_at_once;
    methods[1].trials.push_back(tried(setting, n, n, exact, [&samples, curve, chunk] {
      return streamed_damage(samples, curve, chunk, plain_kernels);
    }));
    methods[2].trials.push_back(tried(setting, n, n, exact, [&samples, curve, chunk] {
      return separate_damage(samples, curve, chunk);
    }));
  }
  const auto whole = static_cast<double>(sample_count);
  methods.push_back({"all in memory", {}, false});
  methods.back().trials.push_back(
      tried("the whole history", whole, whole, exact,
            [&samples, curve] { return damage_in_memory(samples, curve); }));
  methods.push_back({"plain stack", {}, true});
  methods.back().trials.push_back(
      tried("the whole history", whole, whole, exact,
            [&samples, curve] { return stack_damage(samples, curve); }));
  Chart chart;
  chart.name = "rainflow-stream";
  chart.title = "Rainflow: a history in chunks";
  chart.scene = "wide-band noise, ranges up to 240 MPa, EN 1993-1-9 category 100";
  chart.error = "relative error of the damage sum";
  chart.reference = "every cycle by itself, plain stack, summed in long double";
  chart.operations = "samples per chunk";
  chart.operations_cost = false;
  chart.unit = unit;
  chart.series = timed(methods, effort);
  chart.guides = {{1.0, 2}};
  chart.floor = ErrorLevel{1e-14, "round-off of the sum"};
  chart.lesson = fmt::format(
      "Counted in chunks whose residue is kept, a history gives the same cycles as in memory, "
      "however it is cut. Chunks of {} samples that are counted each by itself lose {:.1e} of the "
      "damage: the largest cycles span them.",
      read_at_once, at_setting(chart.series[2], static_cast<double>(read_at_once)).error);
  return chart;
}

}  // namespace

TopicResult rainflow(const Scenes&, const Effort& effort) {
  TopicResult result;
  result.charts = {classes_chart(effort), slopes_chart(effort), filter_chart(effort),
                   chunks_chart(effort)};
  return result;
}

}  // namespace boxbeam::charts
