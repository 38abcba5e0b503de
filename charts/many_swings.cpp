#include "charts/many_swings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "charts/integrators.hpp"
#include "charts/known_motions.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using planar::EquationsOfMotion, planar::FreeSolver, planar::State;

constexpr double usual_tolerance = 1e-11;  ///< of FreeSolver

/// A method that goes on from a state to a time.
struct Runner {
  std::string method;
  bool yardstick = false;
  bool is_default = false;
  std::function<Moving(const Moving&, double)> advance;
};

/// One point per number of swings: the largest of what was seen at the end of each until then.
Series over_swings(const Runner& runner, const Moving& start, const std::vector<int>& swings,
                   const std::function<double(const Moving&)>& error) {
  Series series{runner.method, {}, runner.yardstick};
  Moving now = start;
  double worst = 0.0;
  int done = 0;
  for (const int n : swings) {
    // An eighth of a swing further each time, so that no place is looked at alone.
    for (; done < n && now.failure.empty(); ++done) {
      for (int part = 1; part <= 8 && now.failure.empty(); ++part) {
        now = runner.advance(now, (done + part / 8.0) * simple_pendulum_period());
        if (now.failure.empty()) worst = std::max(worst, error(now));
      }
    }
    Point point;
    point.setting = fmt::format("{} swings", n);
    point.parameter = n;
    point.operations = n;
    point.error = worst;
    point.failure = now.failure;
    series.points.push_back(point);
  }
  series.points.back().is_default = runner.is_default;
  return series;
}

/// The program's own solver, with or without projection.
Runner fehlberg_runner(const planar::Mechanism& mechanism, double tolerance, bool project) {
  Runner runner;
  runner.method = fmt::format("Fehlberg 7(8) at {:.0e}, {}", tolerance,
                              project ? "projected" : "not projected");
  runner.is_default = project && tolerance == usual_tolerance;
  runner.yardstick = !project;
  const auto solver = std::make_shared<FreeSolver>(mechanism, tolerance, project);
  runner.advance = [solver](const Moving& from, double until) {
    State state;
    state.time = from.time;
    state.q = from.q;
    state.v = from.v;
    return moving_of(solver->advance(until, state));
  };
  return runner;
}

/// A method of equal steps, 25 per eighth of a swing.
template <class Advance>
Runner stepping_runner(const planar::Mechanism& mechanism, std::string method,
                       const Advance& advance) {
  constexpr int steps = 25;
  const auto equations = std::make_shared<EquationsOfMotion>(mechanism);
  return {std::move(method), true, false, [=](const Moving& from, double until) {
            Moving moving = from;
            advance(*equations, moving, until, steps);
            return moving;
          }};
}

/// The power of the number of swings with which a series grows.
double growth_of(const Series& series) {
  return -order_over_work(series.points.front(), series.points.back());
}

/// Of all methods, on the pendulum from rest.
Chart swings_chart(const std::vector<Runner>& runners, const planar::Mechanism& mechanism,
                   const Effort& effort, const std::function<double(const Moving&)>& error) {
  const std::vector<int> swings =
      effort.quick ? std::vector{1, 3, 10, 30} : std::vector{1, 3, 10, 30, 100, 300, 1000};
  Chart chart;
  chart.scene = "simple pendulum from the horizontal (IFToMM benchmark A01)";
  chart.operations = "swings";
  chart.operations_cost = false;
  chart.unit = "";
  const Moving start = start_of(mechanism);
  for (const Runner& runner : runners)
    chart.series.push_back(over_swings(runner, start, swings, error));
  chart.floor = ErrorLevel{2e-16, "round-off of a coordinate"};
  return chart;
}

}  // namespace

Chart drift_chart(const Effort& effort) {
  const planar::Mechanism mechanism = simple_pendulum();
  const auto open = [](const Moving& moving) {
    return planar::position_of({0, {1.0, 0.0}}, moving.q).norm();
  };
  const std::vector<Runner> runners = {
      fehlberg_runner(mechanism, usual_tolerance, true),
      fehlberg_runner(mechanism, usual_tolerance, false), fehlberg_runner(mechanism, 1e-8, false),
      stepping_runner(mechanism, "Runge-Kutta 4, 200 steps a swing, not projected",
                      [](EquationsOfMotion& equations, Moving& moving, double until, int steps) {
                        runge_kutta_4(equations, moving, until, steps, Constraints::left);
                      })};
  Chart chart = swings_chart(runners, mechanism, effort, open);
  chart.name = "integration-drift";
  chart.title = "Integration: constraints drift unless they are projected";
  chart.error = "largest distance of the pin's two halves, by the length";
  chart.reference = "the closed pin: zero";
  chart.guides = {{-2.0, 1}};
  const Point& closed = chart.series[0].points.back();
  const Point& open_pin = chart.series[1].points.back();
  chart.lesson = fmt::format(
      "Without projection the pin opens with the power {:.1f} of the number of swings, to {:.0e} "
      "of the length after {:.0f} at a tolerance of 1e-11; projected after every step it stays "
      "closed to {:.0e}.",
      growth_of(chart.series[1]), open_pin.error, open_pin.parameter, closed.error);
  return chart;
}

Chart energy_chart(const Effort& effort) {
  const planar::Mechanism mechanism = simple_pendulum();
  // Released from the horizontal, the energy is zero; m g l of it changes place.
  const double exchanged = mechanism.bodies[0].mass * mechanism.gravity.norm();
  const auto lost = [&](const Moving& moving) {
    return std::abs(energy_of(mechanism, moving.q, moving.v)) / exchanged;
  };
  const std::vector<Runner> runners = {
      fehlberg_runner(mechanism, usual_tolerance, true), fehlberg_runner(mechanism, 1e-8, true),
      stepping_runner(mechanism, "Runge-Kutta 4, 200 steps a swing, projected",
                      [](EquationsOfMotion& equations, Moving& moving, double until, int steps) {
                        runge_kutta_4(equations, moving, until, steps, Constraints::projected);
                      }),
      stepping_runner(mechanism, "generalised alpha, radius 0.8, 200 steps a swing",
                      [&](EquationsOfMotion& equations, Moving& moving, double until, int steps) {
                        generalised_alpha(equations, mechanism, moving, until, steps,
                                          damped_by(0.8));
                      }),
      stepping_runner(mechanism, "central differences, 200 steps a swing",
                      [&](EquationsOfMotion& equations, Moving& moving, double until, int steps) {
                        central_differences(equations, mechanism, moving, until, steps);
                      })};
  Chart chart = swings_chart(runners, mechanism, effort, lost);
  chart.name = "integration-energy";
  chart.title = "Integration: energy over many swings";
  chart.error = "largest change of the energy, by what falling exchanges";
  chart.reference = "conservation of energy";
  chart.guides = {{-1.0, 0}};
  const Point& last = chart.series[0].points.back();
  chart.lesson = fmt::format(
      "At a tolerance of 1e-11 the energy changes by {:.0e} in {:.0f} swings, with the power "
      "{:.1f} of their number. Central differences keep theirs within {:.0e} for ever, but that "
      "far off; numerical damping loses {:.0e}.",
      last.error, last.parameter, growth_of(chart.series[0]), chart.series[4].points.back().error,
      chart.series[3].points.back().error);
  return chart;
}

}  // namespace boxbeam::charts
