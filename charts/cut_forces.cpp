#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "charts/bending.hpp"
#include "charts/moment_peak_chart.hpp"
#include "charts/quadrature.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

/// A rule on [0, 1].
using Rule = GaussRule<double>;

const Rule trapezoid{{0.0, 1.0}, {0.5, 0.5}};
const Rule simpson{{0.0, 0.5, 1.0}, {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0}};

/// A rule repeated in equal parts; a place that two parts share is evaluated once.
Rule repeated(const Rule& rule, int parts) {
  const bool shares = rule.x.front() == 0.0 && rule.x.back() == 1.0;
  Rule whole;
  for (int i = 0; i < parts; ++i) {
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
      const double weight = rule.w[k] / parts;
      if (shares && i > 0 && k == 0) {
        whole.w.back() += weight;
        continue;
      }
      whole.x.push_back((i + rule.x[k]) / parts);
      whole.w.push_back(weight);
    }
  }
  return whole;
}

/// M just before the end of every piece, each piece integrated by a rule.
std::vector<double> moments_by(const Rule& rule, const Bending& bending) {
  std::vector<double> moments;
  double V = 0.0, M = 0.0;
  for (const Bending::Piece& piece : bending.pieces) {
    V -= piece.P;
    M -= piece.C;
    double force = 0.0, moment = 0.0;
    const double shift = piece.start - piece.origin;
    for (std::size_t k = 0; k < rule.x.size(); ++k) {
      const double x = piece.length * rule.x[k];
      const double weighed = rule.w[k] * piece.q(shift + x);
      force += weighed;
      moment += (piece.length - x) * weighed + rule.w[k] * piece.m(shift + x);
    }
    M += piece.length * (V - moment);
    V -= piece.length * force;
    moments.push_back(M);
  }
  return moments;
}

/// The same as in a table: V summed up from q by trapezoids, M from V by trapezoids.
std::vector<double> moments_summed_twice(int parts, const Bending& bending) {
  std::vector<double> moments;
  double V = 0.0, M = 0.0;
  for (const Bending::Piece& piece : bending.pieces) {
    V -= piece.P;
    M -= piece.C;
    const double part = piece.length / parts;
    const double shift = piece.start - piece.origin;
    double q = piece.q(shift), m = piece.m(shift);
    for (int i = 1; i <= parts; ++i) {
      const double x = shift + part * i;
      const double next_q = piece.q(x), next_m = piece.m(x);
      const double next_V = V - 0.5 * part * (q + next_q);
      M += 0.5 * part * (V + next_V - m - next_m);
      V = next_V;
      q = next_q;
      m = next_m;
    }
    moments.push_back(M);
  }
  return moments;
}

/// As the program does it: all six cut forces by exact integrals.
std::vector<double> moments_by_polynomials(const BeamLoads& loads, cut_force::Index moment,
                                           const std::vector<double>& ends) {
  const CutForceDiagram diagram = cut_forces_of(loads);
  std::vector<double> moments;
  moments.reserve(ends.size());
  for (const double s : ends) {
    moments.push_back(value_of(diagram.at({si<Length>(s), Side::before}), moment));
  }
  return moments;
}

/// What the experiments on one instant share.
struct Instant {
  std::string scene;
  BeamLoads loads;
  cut_force::Index moment = cut_force::M_y;
  Bending bending;
  std::vector<double> ends;            ///< of the pieces
  std::vector<long double> reference;  ///< M just before them
  double largest = 0.0;                ///< |M|

  double error_of(const std::vector<double>& moments) const {
    long double worst = 0.0L;
    for (std::size_t i = 0; i < moments.size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<long double>(moments[i]) - reference[i]));
    }
    return static_cast<double>(worst) / largest;
  }
};

Instant instant_of(const Project& project, const DemandingInstant& demanding) {
  Instant instant;
  instant.loads = demanding.run->loads.loads_at(demanding.time);
  instant.moment = demanding.moment;
  instant.scene = fmt::format("{}, t = {:.4g} s", project.name, demanding.time.value());
  instant.bending = bending_of(instant.loads, demanding.moment);
  for (const Bending::Piece& piece : instant.bending.pieces) {
    instant.ends.push_back(piece.end());
    instant.reference.push_back(moment_before(instant.bending, piece.end()));
  }
  instant.largest = std::abs(demanding.M);
  return instant;
}

bool has_load_per_length(const Bending& bending) {
  return std::any_of(bending.pieces.begin(), bending.pieces.end(), [](const auto& piece) {
    const auto nonzero = [](double c) { return c != 0.0; };
    return std::any_of(piece.q.c.begin(), piece.q.c.end(), nonzero) ||
           std::any_of(piece.m.c.begin(), piece.m.c.end(), nonzero);
  });
}

/// Whether the load per length, or its slope, jumps between two pieces.
bool has_jump(const Bending& bending) {
  double largest = 0.0;
  for (const Bending::Piece& piece : bending.pieces) {
    for (const double x : {piece.start, piece.end()}) {
      largest = std::max(largest, std::abs(piece.q(x - piece.origin)));
    }
  }
  const double nothing = 1e-6 * largest;
  for (std::size_t i = 0; i + 1 < bending.pieces.size(); ++i) {
    const Bending::Piece &one = bending.pieces[i], &next = bending.pieces[i + 1];
    const double x = one.end() - one.origin, y = next.start - next.origin;
    const double step = next.q(y) - one.q(x);
    const double bend = bending.length() * (derivative_of(next.q)(y) - derivative_of(one.q)(x));
    if (std::max(std::abs(step), std::abs(bend)) > nothing) return true;
  }
  return false;
}

std::vector<int> parts_for(const Effort& effort, int from, int to) {
  std::vector<int> parts;
  for (int n = from; n <= to; n *= effort.quick ? 4 : 2) parts.push_back(n);
  return parts;
}

ErrorLevel round_off() { return {std::numeric_limits<double>::epsilon(), "round-off of double"}; }

/// The moment at the ends of all pieces, by rules that know where the pieces end.
Chart moment_chart(const Instant& instant, const Effort& effort) {
  const auto pieces = static_cast<double>(instant.bending.pieces.size());
  Chart chart;
  chart.name = "cut-forces-moment";
  chart.title = "Bending moment: how the load is summed";
  chart.scene = instant.scene;
  chart.error = "largest error of M where something jumps, relative to the largest M";
  chart.reference =
      "moment of all forces before the place, Gauss' rule of 8 points in "
      "long double";
  chart.operations = "values of the load per length";
  chart.unit = "beam at one instant";
  std::vector<TriedMethod> methods;
  methods.push_back({"exact polynomials, all six cut forces", {}, false});
  {
    Point point;
    point.setting = "as the program does it";
    point.parameter = 1.0;
    point.operations = 4.0 * pieces;  // a cubic has four coefficients
    point.error =
        instant.error_of(moments_by_polynomials(instant.loads, instant.moment, instant.ends));
    point.is_default = true;
    methods.back().trials.push_back({point, [&instant] { keep(cut_forces_of(instant.loads)); }});
  }
  const auto add = [&](const std::string& setting, double parameter, double evaluations,
                       const std::function<std::vector<double>()>& moments) {
    Point point;
    point.setting = setting;
    point.parameter = parameter;
    point.operations = evaluations * pieces;
    point.error = instant.error_of(moments());
    methods.back().trials.push_back({point, [moments] { keep(moments()); }});
  };
  const auto add_parts = [&](const Rule& rule, int parts) {
    const Rule whole = repeated(rule, parts);
    add(fmt::format("{} parts", parts), parts, static_cast<double>(whole.x.size()),
        [&instant, whole] { return moments_by(whole, instant.bending); });
  };
  methods.push_back({"Gauss' rule, once per piece", {}, true});
  for (std::size_t n = 1; n <= 5; ++n) {
    const Rule rule = gauss_rule<double>(n);
    add(fmt::format("{} points", n), static_cast<double>(n), static_cast<double>(n),
        [&instant, rule] { return moments_by(rule, instant.bending); });
  }
  methods.push_back({"Simpson's rule", {}, true});
  for (const int n : parts_for(effort, 1, 256)) add_parts(simpson, n);
  methods.push_back({"masses in the middles of parts", {}, true});
  for (const int n : parts_for(effort, 1, 1024)) add_parts(gauss_rule<double>(1), n);
  methods.push_back({"trapezoids, V and M in turn", {}, true});
  for (const int n : parts_for(effort, 1, 1024)) {
    add(fmt::format("{} parts", n), n, n + 1.0,
        [&instant, n] { return moments_summed_twice(n, instant.bending); });
  }
  chart.series = timed(methods, effort);
  chart.floor = round_off();
  chart.guides = {{4.0, 2}, {2.0, 4}};
  const std::vector<Point>& summed = chart.series[4].points;
  const auto enough = std::find_if(summed.begin(), summed.end(), [&](const Point& point) {
    return point.error <= chart.needed_low;
  });
  chart.lesson = fmt::format(
      "The load per length is a polynomial, so that its exact integral ends at round-off ({:.1e}), "
      "as Gauss' rule of three points does; trapezoids are {}. Choose the exact integral: it has "
      "no setting.",
      default_point(chart)->error,
      enough == summed.end()
          ? fmt::format("{:.1e} off with {} to a piece", summed.back().error, summed.back().setting)
          : fmt::format("good enough from {} to a piece on and {:.1e} off with {}", enough->setting,
                        summed.back().error, summed.back().setting));
  chart.off_front =
      "The rules are told of which degree the load is, and of one moment; the exact integral gives "
      "all six cut forces of any load, everywhere between its ends.";
  return chart;
}

/// M at the end of the beam, by a rule over all of it.
double moment_at_end(const Rule& rule, const Bending& bending) {
  const double length = bending.length();
  double M = 0.0;
  for (const Bending::Piece& piece : bending.pieces) {
    M -= piece.C + piece.P * (length - piece.start);
  }
  std::size_t at = 0;
  for (std::size_t k = 0; k < rule.x.size(); ++k) {
    const double s = length * rule.x[k];
    while (at + 1 < bending.pieces.size() && s >= bending.pieces[at + 1].start) ++at;
    const double x = s - bending.pieces[at].origin;
    M -= length * rule.w[k] * ((length - s) * bending.pieces[at].q(x) + bending.pieces[at].m(x));
  }
  return M;
}

/// The moment that is left over at the end of the beam, by rules that do not know where the load
/// jumps: parts of equal length over the whole beam.
Chart jumps_chart(const Instant& instant, const Effort& effort) {
  Chart chart;
  chart.name = "cut-forces-jumps";
  chart.title = "Bending moment: stations that miss the jumps of the section";
  chart.scene = instant.scene;
  chart.error = "error of M at the end of the beam, relative to the largest M";
  chart.reference =
      "moment of all forces, Gauss' rule of 8 points per segment in long "
      "double";
  chart.operations = "values of the load per length";
  chart.unit = "beam at one instant";
  std::vector<TriedMethod> methods;
  const auto off_by = [&](double M) {
    return static_cast<double>(std::abs(static_cast<long double>(M) - instant.reference.back())) /
           instant.largest;
  };
  methods.push_back({"exact polynomials, segment by segment", {}, false});
  {
    const auto exact = [&instant] {
      return moments_by_polynomials(instant.loads, instant.moment, {instant.ends.back()}).front();
    };
    Point point;
    point.setting = "as the program does it";
    point.parameter = 1.0;
    point.operations = 4.0 * static_cast<double>(instant.bending.pieces.size());
    point.error = off_by(exact());
    point.is_default = true;
    methods.back().trials.push_back({point, [&instant] { keep(cut_forces_of(instant.loads)); }});
  }
  const auto add = [&](const Rule& rule, int parts) {
    const Rule whole = repeated(rule, parts);
    const auto moment = [&instant, whole] { return moment_at_end(whole, instant.bending); };
    Point point;
    point.setting = fmt::format("{} parts", parts);
    point.parameter = parts;
    point.operations = static_cast<double>(whole.x.size());
    point.error = off_by(moment());
    methods.back().trials.push_back({point, [moment] { keep(moment()); }});
  };
  const int most = effort.quick ? 1024 : 4096;
  methods.push_back({"Gauss' rule of 3 points", {}, true});
  for (const int n : parts_for(effort, 4, most)) add(gauss_rule<double>(3), n);
  methods.push_back({"Simpson's rule", {}, true});
  for (const int n : parts_for(effort, 4, most)) add(simpson, n);
  methods.push_back({"masses at stations (trapezoids)", {}, true});
  for (const int n : parts_for(effort, 4, most)) add(trapezoid, n);
  chart.series = timed(methods, effort);
  chart.floor = round_off();
  chart.guides = {{1.0, 3}};
  const Point& last = chart.series[2].points.back();
  chart.lesson = fmt::format(
      "Where plates change, high orders are lost: with {} over the beam Simpson's rule is {:.1e} "
      "off (order {:.1f} instead of 4), the exact integral from segment to segment {:.1e}. "
      "End a part wherever the section changes.",
      last.setting, last.error, order_over_work(chart.series[2].points.front(), last),
      default_point(chart)->error);
  return chart;
}

}  // namespace

TopicResult cut_forces(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  const Project& project = *scenes.beam;
  const std::deque<SituationRun> runs = bending_runs_of(project);
  const auto demanding = demanding_instant_of(runs);
  if (!demanding) {
    result.not_applicable = "nothing bends the beam of " + project.name;
    return result;
  }
  const Instant instant = instant_of(project, *demanding);
  if (!has_load_per_length(instant.bending)) {
    result.not_applicable =
        "no load per length acts on the beam of " + project.name + ": there is nothing to sum";
    return result;
  }
  result.charts.push_back(moment_chart(instant, effort));
  if (has_jump(instant.bending)) result.charts.push_back(jumps_chart(instant, effort));
  result.charts.push_back(moment_peak_chart(effort));
  return result;
}

}  // namespace boxbeam::charts
