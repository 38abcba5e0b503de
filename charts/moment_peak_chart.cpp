#include "charts/moment_peak_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/verified_stations.hpp"
#include "charts/bending.hpp"
#include "charts/connecting_rod.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

struct Peak {
  double s = 0.0, M = 0.0;
};

/// The largest |M_y| along the beam at one instant: at the ends of the pieces and where V is zero,
/// halved down to from 64 steps.
Peak peak_along(const CutForceDiagram& diagram) {
  Peak peak;
  for (const CutForcePiece& piece : diagram.pieces) {
    const double length = piece.length.value();
    const auto look = [&](double x) {
      if (std::abs(piece.M_y(x)) <= std::abs(peak.M)) return;
      peak = {piece.start.value() + x, piece.M_y(x)};
    };
    look(0.0);
    look(length);
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
      double low = length * i / steps, high = length * (i + 1) / steps;
      if (piece.V_z(low) * piece.V_z(high) > 0.0) continue;
      const bool falls = piece.V_z(low) > 0.0;
      for (int halving = 0; halving < 60; ++halving) {
        const double half = 0.5 * (low + high);
        ((piece.V_z(half) > 0.0) == falls ? low : high) = half;
      }
      look(0.5 * (low + high));
    }
  }
  return peak;
}

/// The largest over the period as well: every instant that is higher than its neighbours, and
/// between them by Brent's method on diagrams solved anew.
Peak peak_of(const LoadHistory& loads) {
  const auto at = [&](double time) { return peak_along(loads.diagram_at(si<Time>(time))); };
  const std::size_t n = loads.instants();
  std::vector<double> M(n);
  for (std::size_t i = 0; i < n; ++i) M[i] = std::abs(peak_along(loads.diagram(i)).M);
  Peak best;
  for (std::size_t i = 0; i < n; ++i) {
    if (M[i] < M[(i + 1) % n] || M[i] < M[(i + n - 1) % n]) continue;
    const LoadHistory::Reach reach = loads.reach_of(i);
    const Extremum found = find_maximum([&](double t) { return std::abs(at(t).M); },
                                        reach.from.value(), reach.to.value());
    if (found.value > std::abs(best.M)) best = at(found.at);
  }
  return best;
}

/// The largest |M_y| of a station over the period, as the verification finds it.
double largest_at(const LoadHistory& loads, double s) {
  const StationHistory history(loads, {si<Length>(s)});
  const auto largest = [&](double sign) {
    return history.largest([sign](const CutForces& cut) { return sign * cut.M_y.value(); }).value;
  };
  return std::max(largest(1.0), largest(-1.0));
}

/// Stations h apart that have the true place midway between two of them.
std::vector<double> stations_beside(double place, double length, int parts) {
  const double h = length / parts;
  const double first = std::fmod(place + 0.5 * h, h);
  std::vector<double> stations;
  for (int i = 0; i <= parts; ++i) {
    const double s = first + h * i;
    if (s <= length) stations.push_back(s);
  }
  return stations;
}

std::vector<double> moments_at(const LoadHistory& loads, const std::vector<double>& stations) {
  std::vector<double> moments;
  for (const double s : stations) moments.push_back(largest_at(loads, s));
  return moments;
}

/// Of the stations, or of the parabola through the highest and its neighbours.
double largest_of(const std::vector<double>& moments, bool parabola) {
  const auto highest = std::max_element(moments.begin(), moments.end());
  const bool inside = highest != moments.begin() && highest + 1 != moments.end();
  if (!parabola || !inside) return *highest;
  const double slope = 0.5 * (highest[1] - highest[-1]);
  const double bend = highest[1] - 2.0 * highest[0] + highest[-1];
  return bend < 0.0 ? *highest - 0.5 * slope * slope / bend : *highest;
}

/// Between the finest two settings.
double order_of(const Series& series) {
  return order_over_work(series.points[series.points.size() - 2], series.points.back());
}

}  // namespace

Chart moment_peak_chart(const Effort& effort) {
  const Project project = connecting_rod(0.3, 0.1);
  const std::deque<SituationRun> runs = run_situations(project);
  const LoadHistory& loads = runs.front().loads;
  const double length = project.beam.length().value();
  const Peak truth = peak_of(loads);
  const double largest = std::abs(truth.M);
  const auto error_of = [largest](double M) { return std::abs(M - largest) / largest; };

  Chart chart;
  chart.name = "cut-forces-peak";
  chart.title = "Bending moment: a peak between stations";
  chart.scene = "connecting rod of a crank at 300 rpm, r/l = 0.3, tapered in width and height";
  chart.error = "error of the largest M over the rod and the period, relative";
  chart.reference = "roots of V by halving, over the period by Brent's method on exact solves";
  chart.operations = "stations verified";
  chart.unit = "beam over one period";
  std::vector<TriedMethod> methods;
  methods.push_back({"maxima along the beam, searched for", {}, false});
  {
    const auto stations = [&project, &runs] {
      return search_stations(project, runs, bending_zones_of(project, runs)).stations;
    };
    const auto searched = [stations, &loads] {
      double best = 0.0;
      for (const Station& station : stations()) {
        best = std::max(best, largest_at(loads, station.s.value()));
      }
      return best;
    };
    Point point;
    point.setting = "as the program does it";
    point.parameter = 1.0;
    point.operations = static_cast<double>(stations().size());
    point.error = error_of(searched());
    point.is_default = true;
    methods.back().trials.push_back({point, [searched] { keep(searched()); }});
  }
  for (const bool parabola : {true, false}) {
    methods.push_back({parabola ? "equal stations and a parabola" : "equal stations", {}, true});
    for (int n = 4; n <= (effort.quick ? 64 : 512); n *= 2) {
      const std::vector<double> stations = stations_beside(truth.s, length, n);
      const auto found = [&loads, stations, parabola] {
        return largest_of(moments_at(loads, stations), parabola);
      };
      Point point;
      point.setting = fmt::format("{} parts, peak midway", n);
      point.parameter = n;
      point.operations = static_cast<double>(stations.size());
      point.error = error_of(found());
      methods.back().trials.push_back({point, [found] { keep(found()); }});
    }
  }
  chart.series = timed(methods, effort);
  chart.floor = {{std::numeric_limits<double>::epsilon(), "round-off"}};
  chart.guides = {{3.0, 1}, {2.0, 2}};
  const Series& plain = chart.series[2];
  chart.lesson = fmt::format(
      "Stations alone miss the peak by {:.1e} with {} parts (order {:.2f}; a parabola {:.2f}, for "
      "the peak is not symmetric). The program searches between stations: {:.1e} with {} of them, "
      "since it takes the place from the instants that it has solved.",
      plain.points.front().error, plain.points.front().parameter, order_of(plain),
      order_of(chart.series[1]), default_point(chart)->error, *default_point(chart)->operations);
  return chart;
}

}  // namespace boxbeam::charts
