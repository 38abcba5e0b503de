#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/numerics/extremum.hpp"
#include "charts/bending.hpp"
#include "charts/connecting_rod.hpp"
#include "charts/peak_problem.hpp"
#include "charts/peak_search_charts.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int phases = 8;

/// The moment where and when the beam of a case is bent most. Its true peak: Brent's method on
/// exact solves about every highest of many instants.
PeakProblem bending_peak_of(const Project& project, const DemandingInstant& demanding) {
  const LoadHistory& loads = demanding.run->loads;
  const double sign = demanding.M > 0.0 ? 1.0 : -1.0;
  PeakProblem problem;
  problem.name = project.name;
  problem.span = loads.span();
  const std::size_t steps = problem.span.instants;
  problem.loads = [&loads](Time time) { return loads.loads_at(time); };
  problem.station = demanding.station;
  problem.quantity = [sign, moment = demanding.moment](const CutForces& cut) {
    return sign * value_of(cut, moment);
  };
  const std::size_t many = 4 * steps;
  const double step = problem.period() / static_cast<double>(many);
  const double begin = loads.begin().value();
  std::vector<double> values(many + 1);
  for (std::size_t i = 0; i <= many; ++i) {
    values[i] = problem.at(begin + step * static_cast<double>(i));
    if (i > 0 && values[i] <= problem.peak) continue;
    problem.peak = values[i];
    problem.peak_time = begin + step * static_cast<double>(i);
  }
  for (std::size_t i = 1; i < many; ++i) {
    if (values[i] < std::max(values[i - 1], values[i + 1])) continue;
    const double time = begin + step * static_cast<double>(i);
    const Extremum found =
        find_maximum([&](double t) { return problem.at(t); }, time - step, time + step, 26);
    if (found.value <= problem.peak) continue;
    problem.peak = found.value;
    problem.peak_time = found.at;
  }
  return problem;
}

/// A series of a search over numbers of instants.
void add_search(std::vector<TriedMethod>& methods, const PeakProblem& problem,
                const std::string& method, const PeakSearch& search,
                const std::vector<std::size_t>& instants, bool yardstick) {
  methods.push_back({method, {}, yardstick});
  for (const std::size_t n : instants) {
    const FoundPeak found = worst_of_phases(problem, search, n, phases);
    Point point;
    const bool as_solved = n == problem.span.instants;
    point.setting = fmt::format("{} instants{}", n, as_solved ? ", as solved" : "");
    point.parameter = static_cast<double>(n);
    point.operations = found.solves;
    point.error = error_of(problem, found);
    const double phase = problem.span.closed ? 0.375 : 0.0;
    methods.back().trials.push_back(
        {point, [&problem, search, n, phase] { keep(search(problem, n, phase)); }});
  }
}

void mark_default(Chart& chart, std::size_t series, std::size_t instants) {
  for (Point& point : chart.series[series].points) {
    point.is_default = point.parameter == static_cast<double>(instants);
  }
}

Chart peak_chart(const PeakProblem& problem, const Effort& effort) {
  std::vector<std::size_t> instants;
  const std::size_t solved = problem.span.instants;
  for (std::size_t part = 16; part > 0; part /= effort.quick ? 4 : 2) {
    if (solved / part >= 6) instants.push_back(solved / part);
  }
  if (solved <= 1000) {
    if (!effort.quick) instants.push_back(2 * solved);
    instants.push_back(4 * solved);
  }
  Chart chart;
  chart.name = "critical-instants-peak";
  chart.title = "Peak over time: bending moment";
  chart.scene = fmt::format("{}, M at s = {:.4g} m, {:.4g} s", problem.name,
                            problem.station.s.value(), problem.period());
  chart.error = problem.span.closed
                    ? "error of the largest M, relative, worst of 8 places between the instants"
                    : "error of the largest M, relative";
  chart.reference = "Brent's method on exact solves about every peak of four times the instants";
  chart.operations = "instants solved";
  chart.unit = "period at one station";
  std::vector<TriedMethod> methods;
  add_search(methods, problem, "interpolated through 9 solves, then searched", peak_by_history,
             instants, false);
  add_search(methods, problem, "Brent's method, every value a solve", peak_by_solves, instants,
             true);
  add_search(methods, problem, "instants and a parabola", peak_by_parabola, instants, true);
  add_search(methods, problem, "instants alone", peak_of_samples, instants, true);
  chart.series = timed(methods, effort);
  mark_default(chart, 0, solved);
  chart.floor = {{std::numeric_limits<double>::epsilon(), "round-off of double"}};
  chart.guides = {{4.0, 2}, {2.0, 3}};
  const Point& ours = *default_point(chart);
  const std::vector<Point>& alone = chart.series[3].points;
  const auto same = std::find_if(alone.begin(), alone.end(), [&](const Point& point) {
    return point.parameter == ours.parameter;
  });
  chart.lesson = fmt::format(
      "{} instants alone are up to {:.1e} off; {} more solves about the peak make that {:.1e}, and "
      "they serve every station and every stress. More instants are the dear way.",
      ours.parameter, same->error, *ours.operations - ours.parameter, ours.error);
  chart.off_front =
      "Fewer instants are enough for the one peak of this curve; only as many as are solved see "
      "every wave of every cut force, and they are there for all of them.";
  return chart;
}

/// The slide of a crank whose rod is hardly longer than the crank: its acceleration is a spike.
PeakProblem slide_peak_of(double ratio) {
  const auto r = static_cast<long double>(ratio);
  const auto size = [r](long double phi) { return std::abs(slide_acceleration(r, phi)); };
  constexpr int grid = 20000;
  const long double step = 2.0L * std::numbers::pi_v<long double> / grid;
  int best = 0;
  for (int i = 0; i < grid; ++i) {
    if (size(i * step) > size(best * step)) best = i;
  }
  long double low = (best - 1) * step, high = (best + 1) * step;
  for (int i = 0; i < 100; ++i) {
    const long double a = low + (high - low) / 3.0L, b = high - (high - low) / 3.0L;
    (size(a) > size(b) ? high : low) = size(a) > size(b) ? b : a;
  }
  const long double at = 0.5L * (low + high);
  const Project project = connecting_rod(ratio);
  const std::size_t solved = planar::solve_motion(planar_of(project)).states.size();
  return pulled_bar(
      fmt::format("r/l = {}", ratio), 2.0 * pi, solved,
      [r](double phi) {
        return static_cast<double>(slide_acceleration(r, static_cast<long double>(phi)));
      },
      static_cast<double>(size(at)), static_cast<double>(at));
}

Chart sharp_chart(const std::vector<PeakProblem>& problems, const Effort& effort) {
  Chart chart;
  chart.name = "critical-instants-sharp";
  chart.title = "Peak over time: the sharper, the more instants";
  chart.scene = "acceleration of the slide of a slider-crank, one turn";
  chart.error =
      "error of the largest acceleration, relative, worst of 8 places between the instants";
  chart.reference = "closed form in long double";
  chart.operations = "instants solved";
  chart.unit = "turn";
  std::vector<TriedMethod> methods;
  for (const PeakProblem& problem : problems) {
    std::vector<std::size_t> instants{problem.span.instants};
    for (std::size_t n = 12; n <= 768; n *= effort.quick ? 4 : 2) instants.push_back(n);
    std::sort(instants.begin(), instants.end());
    instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
    add_search(methods, problem, fmt::format("{}, interpolated and searched", problem.name),
               peak_by_history, instants, false);
  }
  for (const PeakProblem& problem : problems) {
    add_search(methods, problem, fmt::format("{}, instants alone", problem.name), peak_of_samples,
               effort.quick ? std::vector<std::size_t>{36, 72, 360}
                            : std::vector<std::size_t>{18, 36, 72, 144, 360, 720, 1440},
               true);
  }
  const std::string& sharpest = problems.back().name;
  for (TriedMethod& method : methods)
    method.other_scene = !method.method.starts_with(sharpest + ",");
  chart.series = timed(methods, effort);
  mark_default(chart, problems.size() - 1, problems.back().span.instants);
  chart.floor = {{std::numeric_limits<double>::epsilon(), "round-off of double"}};
  chart.guides = {{2.0, problems.size()}, {2.0, 2 * problems.size() - 1}};
  const auto at = [](const Series& series, double n) {
    for (const Point& point : series.points) {
      if (point.parameter == n) return point.error;
    }
    return 0.0;
  };
  std::string found;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const auto solved = static_cast<double>(problems[i].span.instants);
    found += fmt::format("{}{} with {}: {:.1e}", i == 0 ? "" : ", ", solved, problems[i].name,
                         at(chart.series[i], solved));
  }
  chart.lesson = fmt::format(
      "36 instants alone lose {:.2g} % to {:.2g} % of the peak. The program doubles its instants "
      "until reactions and accelerations are smooth between them ({}) and interpolates.",
      100.0 * at(chart.series[problems.size()], 36), 100.0 * at(chart.series.back(), 36), found);
  return chart;
}

}  // namespace

TopicResult critical_instants(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  const Project& project = *scenes.beam;
  const std::deque<SituationRun> runs = bending_runs_of(project);
  const auto demanding = demanding_instant_of(runs);
  if (!demanding) {
    result.not_applicable = "nothing bends the beam of " + project.name;
    return result;
  }
  result.charts.push_back(peak_chart(bending_peak_of(project, *demanding), effort));
  std::vector<PeakProblem> slides;
  for (const double ratio : {0.5, 0.95, 0.99}) slides.push_back(slide_peak_of(ratio));
  result.charts.push_back(sharp_chart(slides, effort));
  result.charts.push_back(instants_per_wave_chart(effort));
  result.charts.push_back(nodes_chart(slides, effort));
  result.charts.push_back(bits_chart(effort));
  return result;
}

}  // namespace boxbeam::charts
