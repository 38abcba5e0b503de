#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/free_motion.hpp"
#include "charts/integrators.hpp"
#include "charts/known_motions.hpp"
#include "charts/many_swings.hpp"
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

}  // namespace

TopicResult integration(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  if (!scenes.missing.empty()) {
    result.not_applicable = "its experiments are on mechanisms with known motions, not on the case";
    return result;
  }
  result.charts = {pendulum_chart(effort), singular_chart(effort), andrews_chart(effort),
                   drift_chart(effort), energy_chart(effort)};
  return result;
}

}  // namespace boxbeam::charts
