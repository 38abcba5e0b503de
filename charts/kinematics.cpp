#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "charts/runs.hpp"
#include "charts/toggle.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

constexpr double round_off = 2.220446e-16;

Run dyads_run(const DrivenScene& scene, const ReferenceMotion& reference) {
  Run run;
  run.point.setting = "closed form";
  run.point.failure = scene.dyads.failure;
  if (!run.point.failure.empty()) return run;
  const auto equations = std::make_shared<planar::ConstraintEquations>(scene.mechanism);
  const auto instants = std::make_shared<std::vector<InstantIn<double>>>(reference.times.size());
  const auto near = std::make_shared<std::vector<Eigen::VectorXd>>();
  for (const auto& instant : reference.instants) near->push_back(instant.q.cast<double>());
  run.work = [&scene, &reference, equations, instants, near] {
    for (std::size_t i = 0; i < instants->size(); ++i) {
      equations->set_time(reference.times[i]);
      solve_dyads(scene.dyads, equations->driver_states(), (*near)[i], (*instants)[i]);
    }
  };
  run.work();
  for (const auto& instant : *instants) run.instants.push_back(instant.in<long double>());
  return run;
}

// ---- methods and tolerances -----------------------------------------------------------------

std::string lesson_of(const Chart& chart, Quantity quantity) {
  const Series& sparse = chart.series[1];
  const Series& plain = chart.series[2];
  const Point& program = chart.series[4].points.front();
  if (!sparse.points.front().failure.empty()) {
    return fmt::format("Textbook methods have no place for {}: {}; boxbeam reaches {:.0e}.",
                       to_text(quantity), sparse.points.front().failure, program.error);
  }
  return fmt::format(
      "Every iteration squares the error: a tolerance of 1e-2 leaves {:.0e} from the last instant "
      "and {:.0e} from a Taylor series of order 2, 1e-8 the round-off. boxbeam has no tolerance to "
      "choose and leaves {:.0e}. The sparse order needs {:.0f} times fewer operations than dense "
      "elimination, with the same digits.",
      plain.points.front().error, sparse.points.front().error, program.error,
      chart.series[0].points.front().operations.value_or(0.0) /
          sparse.points.front().operations.value_or(1.0));
}

Chart methods_chart(const DrivenScene& scene, const ReferenceMotion& reference,
                    const std::vector<Run>& runs, Quantity quantity) {
  const ErrorOf error_of(scene.mechanism, reference);
  Chart chart;
  chart.name = fmt::format("kinematics-{}", to_text(quantity));
  chart.title = fmt::format("Kinematics: {} from the loop equations", to_text(quantity));
  chart.scene = fmt::format("{}, {} instants", scene.name, reference.times.size());
  chart.error = fmt::format("largest error of {}, relative", to_text(quantity));
  chart.reference = reference.name;
  chart.operations = "floating-point operations of the linear systems per instant";
  chart.unit = "one instant: positions, velocities, accelerations";
  chart.off_front =
      "Closed forms exist for loops of two links; the program solves any, reactions included, and "
      "checks its branch.";
  chart.series = {{"Newton, dense LU", {}, true},
                  {"Newton, static sparse order", {}, true},
                  {"the same from the last instant, no predictor", {}, true},
                  {"closed-form dyads", {}, true},
                  {"boxbeam, with reactions and checks of the branch", {}, false}};
  for (const Run& run : runs) {
    chart.series[run.series].points.push_back(point_of(run, error_of, quantity));
  }
  chart.floor = {round_off, "round-off of double"};
  chart.lesson = lesson_of(chart, quantity);
  return chart;
}

// ---- predictors -----------------------------------------------------------------------------

/// Largest error of positions predicted from the instant before.
double prediction_error(const DrivenScene& scene, const std::vector<double>& times, int order,
                        const std::vector<InstantIn<long double>>& instants) {
  ReferenceMotion converged{"", times, instants};
  std::vector<InstantIn<long double>> predicted = instants;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const long double h = static_cast<long double>(times[i]) - times[i - 1];
    predicted[i].q = instants[i - 1].q;
    if (order > 0) predicted[i].q += h * instants[i - 1].v;
    if (order > 1) predicted[i].q += (h * h / 2.0L) * instants[i - 1].a;
  }
  return ErrorOf(scene.mechanism, converged)(Quantity::position, predicted);
}

Chart predictor_chart(const DrivenScene& scene, const Effort& effort) {
  Chart chart;
  chart.name = "kinematics-predictor";
  chart.title = "Kinematics: where Newton's method starts";
  chart.scene = scene.name;
  chart.error = "largest error of the predicted positions, relative";
  chart.reference = "the converged positions";
  chart.operations = "instants per motion";
  chart.operations_cost = false;
  chart.unit = "one instant, to round-off";
  // From here two iterations reach round-off: they square the error.
  chart.needed_low = 1e-5;
  chart.needed_high = 1e-4;
  constexpr double converged = 1e-13;
  std::vector<Run> runs;
  std::vector<std::size_t> counts;
  std::vector<double> iterations;
  for (int order = 0; order <= 2; ++order) {
    chart.series.push_back({fmt::format("Taylor series of order {}", order), {}, order < 2});
    for (int k = 0; k <= 6; ++k) {
      if (effort.quick && k % 2 != 0) continue;
      const std::size_t count = std::size_t{24} << k;
      const std::vector<double> times = scene.times(count);
      const auto follower = std::make_shared<Follower<double>>(scene, times, LinearMethod::sparse);
      Run run;
      run.series = static_cast<std::size_t>(order);
      run.point.failure = follower->run({converged, order});
      run.point.parameter = static_cast<double>(count);
      run.point.operations = run.point.parameter;
      if (run.point.failure.empty()) {
        run.point.setting = fmt::format("{} instants, {:.2f} iterations each", count,
                                        follower->iterations_per_instant());
        run.point.error = prediction_error(scene, times, order, follower->instants());
        run.work = [follower, order] { keep(follower->run({converged, order})); };
      } else {
        run.point.setting = fmt::format("{} instants", count);
      }
      iterations.push_back(follower->iterations_per_instant());
      counts.push_back(count);
      runs.push_back(std::move(run));
    }
  }
  const std::size_t own = instants_of(scene);
  const std::vector<double> times = scene.times(own);
  Run program = program_run(scene, {"", times, {}});
  program.series = 3;
  program.point.setting = fmt::format("{} instants", own);
  program.point.parameter = static_cast<double>(own);
  program.point.operations = program.point.parameter;
  program.point.error = prediction_error(scene, times, 2, program.instants);
  counts.push_back(own);
  runs.push_back(std::move(program));
  std::vector<std::function<void()>> work;
  for (const Run& run : runs) {
    if (run.work) work.push_back(run.work);
  }
  const std::vector<Timing> timings = times_of(work, effort);
  chart.series.push_back({"boxbeam, order 2", {}, false});
  std::size_t next = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].work) runs[i].point.time = per_instant(timings[next++], counts[i]);
    chart.series[runs[i].series].points.push_back(runs[i].point);
  }
  const std::size_t per_order = iterations.size() / 3;
  // With 96 instants, what every setting of both efforts has.
  const std::size_t at_96 = effort.quick ? 1 : 2;
  chart.guides = {{1.0, 0}, {2.0, 1}, {3.0, 2}};
  if (scene.mechanism.equations() == scene.mechanism.coordinates()) {
    chart.lesson = fmt::format(
        "With 96 instants order 0 needs {:.2f} iterations per instant, order 1 {:.2f} and order 2 "
        "{:.2f}; velocities and accelerations are wanted anyway, so order 2 costs nothing more.",
        iterations[at_96], iterations[per_order + at_96], iterations[2 * per_order + at_96]);
  } else {
    chart.lesson = "The textbook solver has no place for more equations than coordinates.";
  }
  return chart;
}

// ---- towards a toggle -----------------------------------------------------------------------

Chart toggle_chart(const Scenes& scenes, const Effort& effort) {
  const ToggleScene scene = toggle_scene_of(scenes);
  Chart chart;
  chart.name = "kinematics-toggle";
  chart.title = "Kinematics: digits lost towards a toggle";
  chart.scene =
      fmt::format("{}, toggle at {:.9g}", scene.name, static_cast<double>(scene.toggle.value));
  chart.error = "largest error, relative to the largest value";
  chart.reference = "the same position in long double";
  chart.operations = "distance of the driver to the toggle, m or rad";
  chart.operations_cost = false;
  chart.series = {{"boxbeam: positions", {}, false},
                  {"boxbeam: velocities", {}, false},
                  {"boxbeam: accelerations", {}, false},
                  {"Newton, dense LU: velocities", {}, true},
                  {"closed-form dyads: velocities", {}, true}};
  constexpr std::array quantities{Quantity::position, Quantity::velocity, Quantity::acceleration};
  for (int k = 2; k <= 24; ++k) {
    if (effort.quick && k % 4 != 0) continue;
    const std::optional<ToggleScene::Place> place = scene.place(std::pow(10.0, -0.5 * k));
    if (!place) continue;
    Point point;
    point.parameter = place->distance;
    point.operations = place->distance;
    point.setting = fmt::format("{:.3g} before the toggle", place->distance);
    std::array<Point, 5> points{point, point, point, point, point};
    const ReferenceMotion exact{"", {0.0}, {place->exact}};
    const ErrorOf error_of(place->mechanism, exact);
    Eigen::VectorXd near = place->exact.q.cast<double>();
    try {
      planar::InstantSolver solver(place->mechanism);
      const planar::State state = solver.solve_from_sketch(0.0, sketch_of(place->mechanism));
      for (std::size_t i = 0; i < quantities.size(); ++i) {
        points[i].error = error_of.at(quantities[i], 0, instant_of(state));
      }
    } catch (const AnalysisError& error) {
      for (std::size_t i = 0; i < quantities.size(); ++i) points[i].failure = error.failure().what;
    }
    TextbookSolver<double> newton(place->mechanism, LinearMethod::dense);
    newton.equations().set_time(0.0);
    InstantIn<double> instant;
    instant.q = near;
    if (newton.solve_position(instant.q, 0.0) > 0 && newton.solve_rates(instant)) {
      points[3].error = error_of.at(Quantity::velocity, 0, instant.in<long double>());
    } else {
      points[3].failure = "no convergence";
    }
    const DyadPlan plan = plan_dyads(place->mechanism, near);
    points[4].failure = plan.failure;
    if (plan.failure.empty()) {
      solve_dyads(plan, newton.equations().driver_states(), near, instant);
      points[4].error = error_of.at(Quantity::velocity, 0, instant.in<long double>());
      if (!std::isfinite(points[4].error)) {
        points[4].error = 0.0;
        points[4].failure = "round-off beyond the toggle";
      }
    }
    for (std::size_t i = 0; i < points.size(); ++i) chart.series[i].points.push_back(points[i]);
  }
  chart.guides = {{0.5, 0}, {1.0, 1}};
  chart.floor = {round_off, "round-off of double"};
  const auto worst_times_distance = [&](std::size_t series) {
    double worst = 0.0;
    for (const Point& point : chart.series[series].points) {
      if (point.failure.empty()) worst = std::max(worst, point.error * point.parameter);
    }
    return worst;
  };
  chart.lesson = fmt::format(
      "No method escapes: the relative error of velocities grows to {:.0e} over the distance, that "
      "of positions only with its root. A check that needs 1e-4 holds until {:.0e} before the "
      "toggle; boxbeam prints the digits that are left.",
      worst_times_distance(1), worst_times_distance(1) / 1e-4);
  return chart;
}

}  // namespace

TopicResult kinematics(const Scenes& scenes, const Effort& effort) {
  return on_driven_scene(scenes, [&](const DrivenScene& scene) {
    TopicResult result;
    const ReferenceMotion reference = reference_of(scene, instants_of(scene));
    std::vector<Run> runs;
    std::size_t series = 0;
    for (const NewtonSetting& setting :
         {NewtonSetting{LinearMethod::dense}, NewtonSetting{LinearMethod::sparse},
          NewtonSetting{LinearMethod::sparse, 0}}) {
      for (Run& run : newton_runs(scene, reference, setting, tolerances_of(effort))) {
        run.series = series;
        runs.push_back(std::move(run));
      }
      ++series;
    }
    runs.push_back(dyads_run(scene, reference));
    runs.back().series = 3;
    runs.push_back(program_run(scene, reference));
    runs.back().series = 4;
    time_runs(runs, reference.times.size(), effort);
    for (const Quantity quantity :
         {Quantity::position, Quantity::velocity, Quantity::acceleration}) {
      result.charts.push_back(methods_chart(scene, reference, runs, quantity));
    }
    result.charts.push_back(differences_chart(scene, reference, Quantity::acceleration, effort));
    result.charts.back().name = "kinematics-differences";
    result.charts.push_back(predictor_chart(scene, effort));
    result.charts.push_back(toggle_chart(scenes, effort));
    return result;
  });
}

}  // namespace boxbeam::charts
