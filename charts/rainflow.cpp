#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "charts/damage_counts.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

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

const Point& at_setting(const Series& series, double parameter) {
  return *std::find_if(series.points.begin(), series.points.end(),
                       [&](const Point& point) { return point.parameter == parameter; });
}

Chart damage_chart(const std::vector<TriedMethod>& methods, const Effort& effort) {
  Chart chart;
  chart.error = "relative error of the damage sum";
  chart.reference = "every cycle by itself, plain stack, summed in long double";
  chart.unit = "history of 131 072 samples";
  chart.series = timed(methods, effort);
  return chart;
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
  Chart chart = damage_chart(methods, effort);
  chart.name = "rainflow-classes";
  chart.title = "Rainflow: damage from cycles in classes";
  chart.scene = "wide-band noise, ranges up to 240 MPa, EN 1993-1-9 category 100";
  chart.operations = "classes";
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
  Chart chart = damage_chart(methods, effort);
  chart.name = "rainflow-histories";
  chart.title = "Rainflow: classes against kind of history and slope";
  chart.scene = "classes of range, their middle; ranges up to 240 MPa";
  chart.operations = "classes";
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
  Chart chart = damage_chart(methods, effort);
  chart.name = "rainflow-filter";
  chart.title = "Rainflow: small ranges left out before counting";
  chart.scene = "wide-band noise, ranges up to 240 MPa";
  chart.operations = "turning points left";
  chart.operations_cost = false;  // nor is what leaving them out costs
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
  Chart chart = damage_chart(methods, effort);
  chart.name = "rainflow-stream";
  chart.title = "Rainflow: a history in chunks";
  chart.scene = "wide-band noise, ranges up to 240 MPa, EN 1993-1-9 category 100";
  chart.operations = "samples per chunk";
  chart.operations_cost = false;
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
