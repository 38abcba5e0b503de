#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "charts/integrators.hpp"
#include "charts/known_motions.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using planar::EquationsOfMotion, planar::FreeSolver, planar::State;

constexpr double default_tolerance = 1e-11;  ///< of FreeSolver
constexpr const char* default_setting = "tolerance 1e-11";

/// A motion up to its end, and how far from the truth a state there is.
struct Course {
  planar::Mechanism mechanism;
  double end = 0.0;
  std::function<double(const Moving&)> error;
};

struct Outcomes {
  double error = 0.0;
  int evaluations = 0;
  std::string failure;
};

/// An error that nobody can mistake for a result is a failure.
Outcomes judged(const Course& course, const Moving& end, int evaluations) {
  if (!end.failure.empty()) return {0.0, evaluations, end.failure};
  const double error = course.error(end);
  if (!(error < 1.0)) return {0.0, evaluations, "wrong by more than its size"};
  return {error, evaluations, ""};
}

Moving moving_of(const State& state) {
  return {state.time, state.q, state.v, state.a, state.lambda, {}, ""};
}

/// The program's own integration, in one go or stopping at instants on its way.
Outcomes fehlberg(const Course& course, const State& start, double tolerance, int instants) {
  FreeSolver solver(course.mechanism, tolerance);
  State state = start;
  try {
    for (int i = 1; i <= instants; ++i) state = solver.advance(course.end * i / instants, state);
  } catch (const AnalysisError&) {
    return {0.0, solver.evaluations(), "the step vanishes"};
  }
  return judged(course, moving_of(state), solver.evaluations());
}

template <class Advance>
Outcomes by(const Course& course, const Moving& start, const Advance& advance) {
  EquationsOfMotion equations(course.mechanism);
  Moving moving = start;
  advance(equations, moving);
  return judged(course, moving, equations.evaluations());
}

Trial tried(std::string setting, double parameter, const std::function<Outcomes()>& run) {
  const Outcomes found = run();
  Trial trial;
  trial.point.setting = std::move(setting);
  trial.point.parameter = parameter;
  trial.point.operations = static_cast<double>(found.evaluations);
  trial.point.error = found.error;
  trial.point.failure = found.failure;
  trial.work = [run] { keep(run()); };
  return trial;
}

TriedMethod over_tolerance(const char* method, bool yardstick, const std::vector<int>& digits,
                           const std::function<Outcomes(double)>& run) {
  TriedMethod tried_method{method, {}, yardstick};
  for (const int n : digits) {
    const double tolerance = std::pow(10.0, -n);
    tried_method.trials.push_back(
        tried(fmt::format("tolerance 1e-{}", n), tolerance, [=] { return run(tolerance); }));
  }
  return tried_method;
}

TriedMethod over_steps(const char* method, const std::vector<int>& steps,
                       const std::function<Outcomes(int)>& run) {
  TriedMethod tried_method{method, {}, true};
  for (const int n : steps) {
    tried_method.trials.push_back(tried(fmt::format("{} steps", n), n, [=] { return run(n); }));
  }
  return tried_method;
}

struct Sweep {
  std::vector<int> digits;    ///< of tolerances
  std::vector<int> instants;  ///< where the motion is looked at on its way
  std::vector<int> steps;     ///< of constant size
};

/// Powers of two.
std::vector<int> doubled(int from, int to) {
  std::vector<int> all;
  for (int n = from; n <= to; n *= 2) all.push_back(n);
  return all;
}

std::vector<int> digits_for(const Effort& effort) {
  return effort.quick ? std::vector{3, 5, 7, 9, 11}
                      : std::vector{3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
}

Sweep sweep_for(const Effort& effort) {
  return {digits_for(effort), effort.quick ? std::vector{25, 100, 400} : doubled(25, 1600),
          effort.quick ? std::vector{128, 512, 1024} : doubled(128, 16384)};
}

State start_state_of(const planar::Mechanism& mechanism) {
  return FreeSolver(mechanism).start(0.0, planar::sketch_of(mechanism),
                                     planar::start_velocity_of(mechanism));
}

/// All methods on one motion.
std::vector<Series> all_methods(const Course& course, const Sweep& sweep, const Effort& effort) {
  const State start = start_state_of(course.mechanism);
  const Moving moving = moving_of(start);
  const auto steps_by = [=, &course](const auto& advance) {
    return [=, &course](int steps) {
      return by(course, moving,
                [&](EquationsOfMotion& equations, Moving& now) { advance(equations, now, steps); });
    };
  };
  std::vector<TriedMethod> methods;
  methods.push_back(over_tolerance(
      "Fehlberg 7(8) with projection", false, sweep.digits,
      [=, &course](double tolerance) { return fehlberg(course, start, tolerance, 1); }));
  for (Trial& trial : methods.back().trials) {
    trial.point.is_default = trial.point.setting == default_setting;
  }
  TriedMethod looked_at{"the same at 1e-11 with looks on its way", {}, false};
  for (const int n : sweep.instants) {
    looked_at.trials.push_back(tried(fmt::format("{} instants", n), n, [=, &course] {
      return fehlberg(course, start, default_tolerance, n);
    }));
  }
  methods.push_back(looked_at);
  methods.push_back(over_tolerance(
      "Dormand-Prince 5(4) with projection", true, sweep.digits, [=, &course](double tolerance) {
        return by(course, moving, [&](EquationsOfMotion& equations, Moving& now) {
          dormand_prince(equations, now, course.end, tolerance, Constraints::projected);
        });
      }));
  methods.push_back(
      over_steps("Runge-Kutta 4 with projection", sweep.steps,
                 steps_by([&course](EquationsOfMotion& equations, Moving& now, int steps) {
                   runge_kutta_4(equations, now, course.end, steps, Constraints::projected);
                 })));
  methods.push_back(over_steps(
      "generalised alpha (radius 0.8)", sweep.steps,
      steps_by([&course](EquationsOfMotion& equations, Moving& now, int steps) {
        generalised_alpha(equations, course.mechanism, now, course.end, steps, damped_by(0.8));
      })));
  methods.push_back(over_steps(
      "Newmark (average acceleration)", sweep.steps,
      steps_by([&course](EquationsOfMotion& equations, Moving& now, int steps) {
        generalised_alpha(equations, course.mechanism, now, course.end, steps, newmark());
      })));
  methods.push_back(
      over_steps("central differences", sweep.steps,
                 steps_by([&course](EquationsOfMotion& equations, Moving& now, int steps) {
                   central_differences(equations, course.mechanism, now, course.end, steps);
                 })));
  return timed(methods, effort);
}

/// The cheapest point of a series that is accurate enough; nullptr where none is.
const Point* cheapest(const Series& series, double error) {
  const Point* best = nullptr;
  for (const Point& point : series.points) {
    if (!point.failure.empty() || point.error > error) continue;
    if (best == nullptr || *point.operations < *best->operations) best = &point;
  }
  return best;
}

/// What the methods need for an error: "700 evaluations by ..., 1025 by ...".
std::string evaluations_for(const Chart& chart, double error) {
  std::string text, without;
  for (const Series& series : chart.series) {
    const Point* const point = cheapest(series, error);
    if (point == nullptr) {
      without += fmt::format("{}{}", without.empty() ? "" : ", ", series.method);
    } else {
      text += fmt::format("{}{:.0f}{} by {}", text.empty() ? "" : ", ", *point->operations,
                          text.empty() ? " evaluations" : "", series.method);
    }
  }
  return without.empty() ? text : fmt::format("{}; more than was tried by {}", text, without);
}

Chart pendulum_chart(const Effort& effort) {
  constexpr double end = 10.0;
  const Course course{simple_pendulum(), end, [](const Moving& moving) {
                        return (moving.q.head<2>() - simple_pendulum_at(end)).norm();
                      }};
  Chart chart;
  chart.name = "integration-pendulum";
  chart.title = "Integration: where a pendulum is after four swings";
  chart.scene = "simple pendulum from the horizontal, 10 s (IFToMM benchmark A01)";
  chart.error = "distance from its place, by its length";
  chart.reference = "Jacobi's elliptic functions, long double";
  chart.operations = "evaluations of the equations of motion";
  chart.unit = "motion of 10 s";
  chart.series = all_methods(course, sweep_for(effort), effort);
  chart.guides = {{8.0, 0}, {5.0, 2}, {4.0, 3}, {2.0, 4}};
  chart.floor = ErrorLevel{1e-14, "round-off of a swing's steps"};
  chart.lesson = fmt::format(
      "An error of 1e-4 costs {}. Tolerance 1e-11 reaches {:.0e} with {:.0f}, no more than it "
      "costs "
      "to look at a swing fifty times; so it is kept. Newmark's method without damping fails: "
      "constraints make it unstable.",
      evaluations_for(chart, 1e-4), default_point(chart)->error, *default_point(chart)->operations);
  return chart;
}

Chart singular_chart(const Effort& effort) {
  constexpr double end = 10.0;
  constexpr int loops = 2;
  const Course course{
      n_four_bar(loops), end, [](const Moving& moving) {
        const planar::Attachment tip{0, {0.5, 0.0}};
        return (planar::position_of(tip, moving.q) - n_four_bar_tip_at(loops, end)).norm();
      }};
  Chart chart;
  chart.name = "integration-singular";
  chart.title = "Integration: through singular positions";
  chart.scene = "N-four-bar of two loops, 10 s, ten times flat (IFToMM benchmark A02)";
  chart.error = "distance of the crank's tip from its place, by its length";
  chart.reference = "Jacobi's elliptic functions, long double";
  chart.operations = "evaluations of the equations of motion";
  chart.unit = "motion of 10 s";
  chart.series = all_methods(course, sweep_for(effort), effort);
  std::size_t failed = 0, tried = 0;
  for (const Series& series : chart.series) {
    if (!series.yardstick) continue;
    tried += series.points.size();
    failed += static_cast<std::size_t>(
        std::count_if(series.points.begin(), series.points.end(),
                      [](const Point& point) { return !point.failure.empty(); }));
  }
  chart.lesson = fmt::format(
      "Where all links lie flat another motion begins, and {} of {} settings of the other methods "
      "fail. The program passes over such a position in one step and ends none close to it: {:.0e} "
      "at its default.",
      failed, tried, default_point(chart)->error);
  return chart;
}

Chart andrews_chart(const Effort& effort) {
  constexpr double end = 0.03;
  const Course course{andrews(), end, [](const Moving& moving) {
                        const auto truth = andrews_forces_at_end();
                        double worst = 0.0;
                        for (std::size_t i = 0; i < truth.size(); ++i) {
                          const double force = moving.lambda[static_cast<Eigen::Index>(i)];
                          worst = std::max(worst, std::abs(force / truth[i] - 1.0));
                        }
                        return worst;
                      }};
  Chart chart;
  chart.name = "integration-reactions";
  chart.title = "Integration: reactions of a fast mechanism";
  chart.scene = "Andrews' squeezing mechanism, 0.03 s (IVP Test Set)";
  chart.error = "largest relative error of the six loop forces at the end";
  chart.reference = "extrapolation of order 16, long double (about 1e-13)";
  chart.operations = "evaluations of the equations of motion";
  chart.unit = "motion of 0.03 s";
  chart.series = all_methods(course, sweep_for(effort), effort);
  chart.guides = {{8.0, 0}, {5.0, 2}, {4.0, 3}, {2.0, 6}};
  chart.floor = ErrorLevel{1e-13, "digits of the reference"};
  chart.lesson = fmt::format(
      "An error of 1e-4 in a reaction costs {}. Methods of order 2, made for vibrations of "
      "structures, are the dearest here; tolerance 1e-11 reaches {:.0e}.",
      evaluations_for(chart, 1e-4), default_point(chart)->error);
  return chart;
}

// ---- over many swings -----------------------------------------------------------------------

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

std::vector<int> swings_for(const Effort& effort) {
  return effort.quick ? std::vector{1, 3, 10, 30} : std::vector{1, 3, 10, 30, 100, 300, 1000};
}

/// The program's own solver, with or without projection.
Runner fehlberg_runner(const planar::Mechanism& mechanism, double tolerance, bool project) {
  Runner runner;
  runner.method = fmt::format("Fehlberg 7(8) at {:.0e}, {}", tolerance,
                              project ? "projected" : "not projected");
  runner.is_default = project && tolerance == default_tolerance;
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

Chart drift_chart(const Effort& effort) {
  const planar::Mechanism mechanism = simple_pendulum();
  const auto open = [](const Moving& moving) {
    return planar::position_of({0, {1.0, 0.0}}, moving.q).norm();
  };
  std::vector<Runner> runners = {
      fehlberg_runner(mechanism, default_tolerance, true),
      fehlberg_runner(mechanism, default_tolerance, false), fehlberg_runner(mechanism, 1e-8, false),
      stepping_runner(mechanism, "Runge-Kutta 4, 200 steps a swing, not projected",
                      [](EquationsOfMotion& equations, Moving& moving, double until, int steps) {
                        runge_kutta_4(equations, moving, until, steps, Constraints::left);
                      })};
  Chart chart;
  chart.name = "integration-drift";
  chart.title = "Integration: constraints drift unless they are projected";
  chart.scene = "simple pendulum from the horizontal (IFToMM benchmark A01)";
  chart.error = "largest distance of the pin's two halves, by the length";
  chart.reference = "the closed pin: zero";
  chart.operations = "swings";
  chart.operations_cost = false;
  chart.unit = "";
  const Moving start = moving_of(start_state_of(mechanism));
  for (const Runner& runner : runners) {
    chart.series.push_back(over_swings(runner, start, swings_for(effort), open));
  }
  chart.guides = {{-2.0, 1}};
  chart.floor = ErrorLevel{2e-16, "round-off of a coordinate"};
  const Point& closed = chart.series[0].points.back();
  const Point& open_pin = chart.series[1].points.back();
  chart.lesson = fmt::format(
      "Without projection the pin opens with the power {:.1f} of the number of swings, to {:.0e} "
      "of "
      "the length after {:.0f} at a tolerance of 1e-11; projected after every step it stays closed "
      "to {:.0e}.",
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
  std::vector<Runner> runners = {
      fehlberg_runner(mechanism, default_tolerance, true), fehlberg_runner(mechanism, 1e-8, true),
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
  Chart chart;
  chart.name = "integration-energy";
  chart.title = "Integration: energy over many swings";
  chart.scene = "simple pendulum from the horizontal (IFToMM benchmark A01)";
  chart.error = "largest change of the energy, by what falling exchanges";
  chart.reference = "conservation of energy";
  chart.operations = "swings";
  chart.operations_cost = false;
  chart.unit = "";
  const Moving start = moving_of(start_state_of(mechanism));
  for (const Runner& runner : runners) {
    chart.series.push_back(over_swings(runner, start, swings_for(effort), lost));
  }
  chart.guides = {{-1.0, 0}};
  chart.floor = ErrorLevel{2e-16, "round-off of a coordinate"};
  const Point& last = chart.series[0].points.back();
  chart.lesson = fmt::format(
      "At a tolerance of 1e-11 the energy changes by {:.0e} in {:.0f} swings, with the power "
      "{:.1f} "
      "of their number. Central differences keep theirs within {:.0e} for ever, but that far off; "
      "numerical damping loses {:.0e}.",
      last.error, last.parameter, growth_of(chart.series[0]), chart.series[4].points.back().error,
      chart.series[3].points.back().error);
  return chart;
}

}  // namespace

TopicResult integration(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  if (!scenes.missing.empty()) {
    result.not_applicable = "its experiments are on mechanisms with known motions, not on the case";
    return result;
  }
  result.charts = {pendulum_chart(effort), singular_chart(effort), andrews_chart(effort)};
  result.charts.push_back(drift_chart(effort));
  result.charts.push_back(energy_chart(effort));
  return result;
}

}  // namespace boxbeam::charts
