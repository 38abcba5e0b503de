#include "charts/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam::charts {

TopicResult on_driven_scene(const Scenes& scenes,
                            const std::function<TopicResult(const DrivenScene&)>& topic) {
  TopicResult result;
  const std::optional<DrivenScene> scene = driven_scene_of(scenes, result.not_applicable);
  if (!scene) return result;
  try {
    return topic(*scene);
  } catch (const AnalysisError& error) {
    result.not_applicable = fmt::format("{}: {}", scenes.planar->name, error.failure().what);
    return result;
  }
}

std::vector<double> tolerances_of(const Effort& effort) {
  std::vector<double> all;
  for (int k = 2; k <= 15; ++k) {
    const bool in_quick = k == 2 || k == 4 || k == 6 || k == 8 || k == 11 || k == 15;
    if (in_quick || !effort.quick) all.push_back(std::pow(10.0, -k));
  }
  return all;
}

std::vector<Run> newton_runs(const DrivenScene& scene, const ReferenceMotion& reference,
                             const NewtonSetting& setting, const std::vector<double>& tolerances) {
  const auto follower = std::make_shared<Follower<double>>(scene, reference.times, setting.method);
  std::vector<Run> runs;
  for (const double tolerance : tolerances) {
    Run run;
    run.point.parameter = tolerance;
    run.point.setting = fmt::format("tolerance {:.0e}", tolerance);
    run.point.failure = follower->run({tolerance, setting.order, setting.reactions});
    if (run.point.failure.empty()) {
      run.point.operations = follower->operations_per_instant(setting.reactions);
      run.instants = follower->instants();
      run.work = [follower, tolerance, setting] {
        keep(follower->run({tolerance, setting.order, setting.reactions}));
      };
    } else if (scene.mechanism.equations() > scene.mechanism.coordinates()) {
      run.point.failure = "more equations than coordinates";
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

Run program_run(const DrivenScene& scene, const ReferenceMotion& reference) {
  const auto follower = std::make_shared<ProgramFollower>(scene, reference.times);
  Run run;
  run.point.setting = "as it is";
  run.point.is_default = true;
  follower->run();
  run.instants = follower->instants();
  run.work = [follower] { follower->run(); };
  return run;
}

void time_runs(std::vector<Run>& runs, std::size_t instants, const Effort& effort) {
  std::vector<std::function<void()>> work;
  for (const Run& run : runs) {
    if (run.work) work.push_back(run.work);
  }
  const std::vector<Timing> timings = times_of(work, effort);
  std::size_t next = 0;
  for (Run& run : runs) {
    if (run.work) run.point.time = per_instant(timings[next++], instants);
  }
}

std::vector<InstantIn<long double>> by_differences(const DrivenScene& scene,
                                                   const ReferenceMotion& reference, double step,
                                                   int order, bool reactions) {
  TextbookSolver<double> solver(scene.mechanism, LinearMethod::orthogonal);
  const int reach = order / 2;
  std::vector<InstantIn<long double>> instants;
  for (std::size_t i = 0; i < reference.times.size(); ++i) {
    const InstantIn<double> known = reference.instants[i].in<double>();
    std::vector<Eigen::VectorXd> at;
    for (int k = -reach; k <= reach; ++k) {
      const double h = k * step;
      solver.equations().set_time(reference.times[i] + h);
      at.push_back(known.q + h * known.v + 0.5 * h * h * known.a);
      solver.solve_position(at.back(), 0.0);
    }
    InstantIn<double> found;
    if (order == 2) {
      found.v = (at[2] - at[0]) / (2.0 * step);
      found.a = ((at[2] - at[1]) - (at[1] - at[0])) / (step * step);
    } else {
      found.v = (8.0 * (at[3] - at[1]) - (at[4] - at[0])) / (12.0 * step);
      found.a = (16.0 * ((at[3] - at[2]) - (at[2] - at[1])) - ((at[4] - at[2]) - (at[2] - at[0]))) /
                (12.0 * step * step);
    }
    found.q = at[static_cast<std::size_t>(reach)];
    if (reactions) {
      InstantIn<double> place = found;
      solver.equations().set_time(reference.times[i]);
      solver.solve_rates(place);
      place.a = found.a;
      place.v = found.v;
      solver.solve_multipliers(reference.times[i], place);
      found.lambda = place.lambda;
    }
    instants.push_back(found.in<long double>());
  }
  return instants;
}

Point point_of(const Run& run, const ErrorOf& error_of, Quantity quantity) {
  Point point = run.point;
  if (!point.failure.empty()) return point;
  point.error = error_of(quantity, run.instants);
  if (!std::isfinite(point.error)) {
    point.error = 0.0;
    point.failure = "no finite result";
  }
  return point;
}

Chart differences_chart(const DrivenScene& scene, const ReferenceMotion& reference,
                        Quantity quantity, const Effort& effort) {
  // Every few of the reference's instants are enough: the differences have neighbours of their own.
  ReferenceMotion some;
  const std::size_t stride = std::max<std::size_t>(1, reference.times.size() / 24);
  for (std::size_t i = 0; i < reference.times.size(); i += stride) {
    // A motion that does not close has no positions before its begin.
    if (i == 0 && !scene.motion.closed) continue;
    some.times.push_back(reference.times[i]);
    some.instants.push_back(reference.instants[i]);
  }
  const ErrorOf error_of(scene.mechanism, some);
  const bool reactions = quantity == Quantity::reaction;
  Chart chart;
  chart.title = fmt::format("{} by differences of positions", to_text(quantity));
  chart.title.front() = static_cast<char>(std::toupper(chart.title.front()));
  chart.scene = scene.name;
  chart.error = fmt::format("largest error of {}, relative", to_text(quantity));
  chart.reference = reference.name;
  chart.operations = "instants per motion";
  chart.operations_cost = false;
  for (const int order : {2, 4}) {
    Series series{fmt::format("differences of order {}", order), {}, true};
    for (int k = 0; k <= 12; ++k) {
      if (effort.quick && k % 2 != 0) continue;
      const double instants = 24.0 * std::pow(2.0, k);
      const double step = scene.motion.period / instants;
      Point point;
      point.setting = fmt::format("{:.0f} instants", instants);
      point.parameter = instants;
      point.operations = instants;
      point.error = error_of(quantity, by_differences(scene, some, step, order, reactions));
      series.points.push_back(std::move(point));
    }
    chart.series.push_back(std::move(series));
  }
  Series own{"boxbeam, from the equations of motion", {}, false};
  for (const std::size_t every : {std::size_t{4}, std::size_t{1}}) {
    const std::size_t count = scene.motion.states.size() / every;
    Point point;
    point.is_default = every == 1;
    point.setting = fmt::format("{} instants", count);
    point.parameter = static_cast<double>(count);
    point.operations = point.parameter;
    planar::InstantSolver solver(scene.mechanism);
    std::vector<InstantIn<long double>> found;
    planar::State state = scene.motion.states.front();
    for (const double time : some.times) {
      // Solved anew from the motion's instant before, as the program does it.
      const double place = (time - scene.motion.begin) / scene.motion.period;
      const auto before =
          static_cast<std::size_t>(place * static_cast<double>(count) * 0.999) * every;
      state = solver.solve_near(time, scene.motion.states[before]);
      found.push_back(instant_of(state));
    }
    point.error = error_of(quantity, found);
    own.points.push_back(std::move(point));
  }
  chart.series.push_back(std::move(own));
  chart.guides = {{2.0, 0}, {4.0, 1}};
  const auto best = [&](std::size_t series) {
    double least = 1e300;
    for (const Point& point : chart.series[series].points) least = std::min(least, point.error);
    return least;
  };
  chart.floor = {chart.series[2].points.back().error, "round-off, derivatives from the equations"};
  chart.lesson = fmt::format(
      "Differences never come below {:.0e} (order 2) and {:.0e} (order 4): finer steps then divide "
      "round-off by the square of the step. The equations give derivatives at every single instant "
      "to {:.0e}, whatever the step; use them.",
      best(0), best(1), chart.series[2].points.back().error);
  return chart;
}

}  // namespace boxbeam::charts
