#include "charts/peak_search_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/numerics/extremum.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int phases = 16;

ErrorLevel round_off() { return {std::numeric_limits<double>::epsilon(), "round-off of double"}; }

/// A wave of twelve crests, one of them higher than its neighbours by little: 2 + cos 12 t + e cos
/// t, whose largest value is 3 + e.
PeakProblem crests(double excess) {
  return pulled_bar(
      "crests", 2.0 * pi, 96,
      [excess](double t) { return 2.0 + std::cos(12.0 * t) + excess * std::cos(t); }, 3.0 + excess,
      0.0);
}

/// Value of the polynomial through Chebyshev points of the second kind.
double interpolate(const std::vector<double>& places, const std::vector<double>& values, double u) {
  double sum = 0.0, weights = 0.0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double distance = u - places[k];
    if (distance == 0.0) return values[k];
    double weight = (k % 2 == 0 ? 1.0 : -1.0) / distance;
    if (k == 0 || k + 1 == places.size()) weight *= 0.5;
    sum += weight * values[k];
    weights += weight;
  }
  return sum / weights;
}

/// The peak through `nodes` values over two steps; their middle lies off the true peak by a part of
/// a step.
double peak_through(const PeakProblem& problem, std::size_t nodes, double offset) {
  const double step = problem.period() / static_cast<double>(problem.span.instants);
  std::vector<double> places(nodes), values(nodes);
  for (std::size_t k = 0; k < nodes; ++k) {
    places[k] = -std::cos(pi * static_cast<double>(k) / static_cast<double>(nodes - 1));
    values[k] = problem.at(problem.peak_time + (offset + places[k]) * step);
  }
  return find_maximum([&](double u) { return interpolate(places, values, u); }, -1.0, 1.0).value;
}

}  // namespace

Chart instants_per_wave_chart(const Effort& effort) {
  std::vector<PeakProblem> problems;
  for (const double excess : {0.001, 0.003, 0.01, 0.03, 0.1}) problems.push_back(crests(excess));
  Chart chart;
  chart.name = "critical-instants-per-wave";
  chart.title = "Peak over time: instants to the shortest wave";
  chart.scene = "twelve crests, one higher than the others by 0.1 % to 10 % of the wave";
  chart.error = "error of the highest crest, relative, worst of 16 places between the instants";
  chart.reference = "closed form";
  chart.operations = "instants to a wave";
  chart.unit = "period of twelve waves";
  std::vector<TriedMethod> methods;
  const auto add = [&](const std::string& method, const PeakSearch& search, bool yardstick) {
    methods.push_back({method, {}, yardstick});
    for (const std::size_t per_wave : {3U, 4U, 5U, 6U, 7U, 8U, 10U, 12U, 16U}) {
      // One more, so that the crests are met at different places.
      const std::size_t n = 12 * per_wave + 1;
      Point point;
      point.setting = fmt::format("{} to a wave", per_wave);
      point.parameter = static_cast<double>(per_wave);
      point.operations = point.parameter;
      point.is_default = !yardstick && per_wave == 8;
      for (const PeakProblem& problem : problems) {
        const FoundPeak found = worst_of_phases(problem, search, n, phases);
        point.error = std::max(point.error, error_of(problem, found));
      }
      methods.back().trials.push_back(
          {point, [&problems, search, n] { keep(search(problems.front(), n, 0.375)); }});
    }
  };
  add("interpolated through 9 solves, then searched", peak_by_history, false);
  add("instants and a parabola", peak_by_parabola, true);
  add("instants alone", peak_of_samples, true);
  chart.series = timed(methods, effort);
  chart.floor = round_off();
  chart.guides = {{2.0, 2}};
  const std::vector<Point>& ours = chart.series[0].points;
  const auto first = std::find_if(ours.begin(), ours.end(), [&](const Point& point) {
    return point.error <= chart.needed_low;
  });
  chart.lesson = fmt::format(
      "Below {} instants to the shortest wave the highest crest can be mistaken for another or be "
      "interpolated badly; from there on the error is {:.1e}, while {} instants alone lose {:.1e}. "
      "The program takes eight.",
      first == ours.end() ? 0.0 : first->parameter, default_point(chart)->error, 8,
      chart.series[2].points[5].error);
  return chart;
}

Chart nodes_chart(const std::vector<PeakProblem>& slides, const Effort& effort) {
  const PeakProblem wave = pulled_bar(
      "a wave of 8 instants", 1.0, 8, [](double t) { return std::cos(2.0 * pi * t); }, 1.0, 0.0);
  std::vector<PeakProblem> problems{wave};
  problems.insert(problems.end(), slides.begin(), slides.end());
  Chart chart;
  chart.name = "critical-instants-nodes";
  chart.title = "Peak over time: solves that it is interpolated through";
  chart.scene = "a wave of 8 instants, and slides of slider-cranks at the instants of the program";
  chart.error = "error of the peak, relative, worst of 16 places between the instants";
  chart.reference = "closed form";
  chart.operations = "solves per peak";
  chart.unit = "peak";
  std::vector<TriedMethod> methods;
  for (const PeakProblem& problem : problems) {
    methods.push_back({problem.name, {}, true, &problem != &problems.front()});
    for (std::size_t nodes = 3; nodes <= 13; nodes += 2) {
      Point point;
      point.setting = fmt::format("{} solves", nodes);
      point.parameter = static_cast<double>(nodes);
      point.operations = static_cast<double>(nodes);
      for (int k = 0; k <= phases; ++k) {
        const double offset = static_cast<double>(k) / phases - 0.5;
        const double found = peak_through(problem, nodes, offset);
        point.error = std::max(point.error, error_of(problem, {found, 0.0}));
      }
      methods.back().trials.push_back(
          {point, [&problem, nodes] { keep(peak_through(problem, nodes, 0.375)); }});
    }
  }
  methods.push_back({"the program, a wave of 8 instants", {}, false});
  {
    const FoundPeak found = worst_of_phases(wave, peak_by_history, 8, phases);
    Point point;
    point.setting = fmt::format("{} solves, as the program does it", LoadHistory::nodes);
    point.parameter = static_cast<double>(LoadHistory::nodes);
    point.operations = static_cast<double>(LoadHistory::nodes);
    point.error = error_of(wave, found);
    point.is_default = true;
    methods.back().trials.push_back({point, [&wave] { keep(peak_by_history(wave, 8, 0.375)); }});
  }
  chart.series = timed(methods, effort);
  chart.floor = round_off();
  const auto& points = chart.series[0].points;
  chart.lesson = fmt::format(
      "The hardest wave that is let pass, eight instants long, is {:.1e} off with {} solves about "
      "its crest, {:.1e} with {} and {:.1e} with {}; the program takes nine, so that waves of 1e-9 "
      "of the whole, which it leaves out as noise, are not made by it.",
      points[1].error, points[1].parameter, points[2].error, points[2].parameter, points[3].error,
      points[3].parameter);
  chart.off_front =
      "The time of the program holds that of the eight instants and of the search; the others have "
      "only that of the interpolation.";
  return chart;
}

Chart bits_chart(const Effort& effort) {
  const PeakProblem wave = pulled_bar(
      "a wave of 8 instants", 1.0, 8, [](double t) { return std::cos(2.0 * pi * t); }, 1.0, 0.0);
  Chart chart;
  chart.name = "critical-instants-bits";
  chart.title = "Peak over time: how far it is searched";
  chart.scene = "a crest between two of its eight instants";
  chart.error = "error of the peak, relative, worst of 15 places";
  chart.reference = "closed form";
  chart.operations = "values of the interpolation";
  chart.unit = "peak";
  std::vector<TriedMethod> methods;
  // The crest itself, whose value is known: what the interpolation adds is another question.
  const auto search = [](double place, int bits, double& evaluations) {
    return find_maximum(
               [&](double u) {
                 evaluations += 1.0;
                 return std::cos(0.25 * pi * (u - place));
               },
               -1.0, 1.0, bits)
        .value;
  };
  constexpr double least = 0.5 * std::numeric_limits<double>::epsilon();
  methods.push_back({"Brent's method", {}, false});
  for (int bits = 4; bits <= 26; bits += 2) {
    Point point;
    point.setting = fmt::format("2^-{} of two steps", bits);
    point.parameter = bits;
    point.is_default = bits == 22;
    double evaluations = 0.0;
    constexpr int places = 15;
    for (int k = 0; k < places; ++k) {
      const double place = (k + 0.5) / places - 0.5;
      const double off = std::abs(search(place, bits, evaluations) - 1.0);
      point.error = std::max({point.error, off, least});
    }
    point.operations = evaluations / places;
    methods.back().trials.push_back({point, [search, bits] {
                                       double count = 0.0;
                                       keep(search(0.3, bits, count));
                                     }});
  }
  chart.series = timed(methods, effort);
  chart.floor = round_off();
  const std::vector<Point>& points = chart.series[0].points;
  const auto at = [&](double bits) {
    return *std::find_if(points.begin(), points.end(),
                         [bits](const Point& point) { return point.parameter == bits; });
  };
  chart.lesson = fmt::format(
      "The value is good to the square of the place: {:.1e} at 2^-10 after {:.1f} values, {:.1e} "
      "at "
      "2^-22 after {:.1f}. The program takes 22, since the time of the peak is reported too.",
      at(10).error, *at(10).operations, at(22).error, *at(22).operations);
  return chart;
}

}  // namespace boxbeam::charts
