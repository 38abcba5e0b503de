#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "charts/runs.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

/// Multipliers by the normal equations J J^T lambda = J (Q - M a), which square the condition.
class NormalEquations {
 public:
  NormalEquations(const DrivenScene& scene, const std::vector<double>& times)
      : follower_(scene, times, LinearMethod::sparse),
        solver_(scene.mechanism, LinearMethod::sparse),
        times_(times) {}

  std::string run() {
    std::string failure = follower_.run({1e-8});
    if (!failure.empty()) return failure;
    instants_ = follower_.own_instants();
    for (std::size_t i = 0; i < times_.size(); ++i) {
      InstantIn<double>& instant = instants_[i];
      solver_.equations().set_time(times_[i]);
      solver_.solve_rates(instant);
      const Eigen::MatrixXd jacobian = solver_.jacobian();
      const Eigen::LLT<Eigen::MatrixXd> factors(jacobian * jacobian.transpose());
      if (factors.info() != Eigen::Success) return "not positive definite";
      instant.lambda = factors.solve(jacobian * solver_.balance_of(times_[i], instant));
    }
    return "";
  }

  std::vector<InstantIn<long double>> instants() const {
    std::vector<InstantIn<long double>> all;
    for (const InstantIn<double>& instant : instants_) all.push_back(instant.in<long double>());
    return all;
  }
  /// n^3 of the product, n^3/3 of Cholesky, beside the sparse kinematics.
  double operations_per_instant() const {
    const auto n = static_cast<double>(instants_.front().q.size());
    return follower_.operations_per_instant() + 4.0 / 3.0 * n * n * n;
  }

 private:
  Follower<double> follower_;
  TextbookSolver<double> solver_;
  std::vector<double> times_;
  std::vector<InstantIn<double>> instants_;
};

Run normal_run(const DrivenScene& scene, const ReferenceMotion& reference) {
  const auto equations = std::make_shared<NormalEquations>(scene, reference.times);
  Run run;
  run.point.setting = "normal equations, Cholesky";
  run.point.failure = scene.mechanism.equations() > scene.mechanism.coordinates()
                          ? "more equations than coordinates"
                          : equations->run();
  if (!run.point.failure.empty()) return run;
  run.point.operations = equations->operations_per_instant();
  run.instants = equations->instants();
  run.work = [equations] { keep(equations->run()); };
  return run;
}

/// By accelerations that are differences of positions, 96 to the motion.
Run differences_run(const DrivenScene& scene, const ReferenceMotion& reference) {
  Run run;
  run.point.setting = "96 steps, order 2";
  if (!scene.motion.closed) {
    run.point.failure = "no positions before the motion's begin";
    return run;
  }
  run.instants = by_differences(scene, reference, scene.motion.period / 96.0, 2, true);
  return run;
}

/// What stays open of the balance of forces and moments, by the largest of them.
double open_balance(const DrivenScene& scene, const ReferenceMotion& reference,
                    const std::vector<InstantIn<long double>>& instants) {
  TextbookSolver<long double> solver(scene.mechanism, LinearMethod::orthogonal);
  const auto scale =
      planar::ConstraintEquations(scene.mechanism).col_scale().cast<long double>().eval();
  long double open = 0.0L;
  long double largest = 0.0L;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    InstantIn<long double> place = instants[i];
    solver.equations().set_time(reference.times[i]);
    solver.solve_rates(place);
    const auto jacobian = solver.jacobian();
    const auto balance = solver.balance_of(reference.times[i], instants[i]);
    open = std::max(open, (balance - jacobian.transpose() * instants[i].lambda)
                              .cwiseProduct(scale)
                              .lpNorm<Eigen::Infinity>());
    const auto parts = (jacobian.cwiseAbs().transpose() * instants[i].lambda.cwiseAbs()).eval();
    largest = std::max(largest, parts.cwiseProduct(scale).lpNorm<Eigen::Infinity>());
  }
  return static_cast<double>(open / largest);
}

Chart chart_of(const DrivenScene& scene, const ReferenceMotion& reference) {
  Chart chart;
  chart.scene = fmt::format("{}, {} instants", scene.name, reference.times.size());
  chart.error = "largest error of the reactions, by the largest reaction";
  chart.reference = fmt::format("{}, reactions by orthogonal decomposition", reference.name);
  chart.operations = "floating-point operations of the linear systems per instant";
  chart.unit = "one instant: positions to reactions";
  chart.floor = {2.220446e-16, "round-off of double"};
  return chart;
}

/// Which method is how exact, and what a balance of forces shows of that.
std::vector<Chart> methods_charts(const DrivenScene& scene, const ReferenceMotion& reference,
                                  std::span<const Run> runs, const ErrorOf& error_of) {
  Chart methods = chart_of(scene, reference);
  methods.name = "reactions-methods";
  methods.title = "Reactions: how the balance is solved";
  methods.series = {{"dense LU", {}, true},
                    {"static sparse order", {}, true},
                    {"orthogonal decomposition", {}, true},
                    {"normal equations", {}, true},
                    {"accelerations by differences", {}, true},
                    {"boxbeam", {}, false}};
  Chart balance = methods;
  balance.name = "reactions-balance";
  balance.title = "Reactions: what a balance of forces shows";
  balance.error = "largest open force or moment of a body, by the largest that act";
  balance.reference = "forces in balance, evaluated in long double";
  for (const Run& run : runs) {
    Point point = point_of(run, error_of, Quantity::reaction);
    methods.series[run.series].points.push_back(point);
    if (point.failure.empty()) point.error = open_balance(scene, reference, run.instants);
    balance.series[run.series].points.push_back(point);
  }
  const Point& program = methods.series[5].points.front();
  const Point& normal = methods.series[3].points.front();
  const Point& differences = methods.series[4].points.front();
  if (normal.failure.empty() && differences.failure.empty()) {
    methods.lesson = fmt::format(
        "All factorisations of the Jacobian itself keep the digits ({:.0e} with boxbeam's); "
        "normal "
        "equations square its condition and leave {:.0e}; accelerations by differences of 96 "
        "instants leave {:.0e}. The factors of the last Newton step serve the reactions as well.",
        program.error, normal.error, differences.error);
    balance.lesson = fmt::format(
        "The balance is a check of the elimination alone: reactions from accelerations by "
        "differences are in balance to {:.0e} and wrong by {:.0e}. A closed balance does not "
        "prove "
        "a motion.",
        balance.series[4].points.front().error, differences.error);
  } else {
    methods.lesson = fmt::format(
        "boxbeam leaves {:.0e}; where a method has no place for the "
        "mechanism the chart says why.",
        program.error);
    balance.lesson = fmt::format("boxbeam's reactions are in balance to {:.0e}.",
                                 balance.series[5].points.front().error);
  }
  return {std::move(methods), std::move(balance)};
}

/// `program`: boxbeam's own point.
Chart tolerance_chart(const DrivenScene& scene, const ReferenceMotion& reference,
                      std::span<const Run> runs, const ErrorOf& error_of, const Point& program) {
  Chart tolerance = chart_of(scene, reference);
  tolerance.name = "reactions-tolerance";
  tolerance.title = "Reactions: what a tolerance of positions costs";
  tolerance.series = {{"Newton, static sparse order, from the last instant", {}, true},
                      {"boxbeam", {}, false}};
  for (const Run& run : runs) {
    tolerance.series[0].points.push_back(point_of(run, error_of, Quantity::reaction));
  }
  tolerance.series[1].points.push_back(program);
  if (tolerance.series[0].points.front().failure.empty()) {
    double largest = 0.0;
    for (const auto& instant : reference.instants) {
      largest = std::max(largest, static_cast<double>(instant.lambda.lpNorm<Eigen::Infinity>()));
    }
    const Point& coarse = tolerance.series[0].points.front();
    tolerance.lesson = fmt::format(
        "A tolerance of 1e-2 leaves reactions wrong by {:.0e} of the largest, {:.2g} of {:.3g} "
        "N; "
        "the error falls as its square, and a further iteration is cheap. boxbeam has no such "
        "tolerance: it goes to round-off, {:.0e}.",
        coarse.error, coarse.error * largest, largest, tolerance.series[1].points.front().error);
  } else {
    tolerance.lesson = tolerance.series[0].points.front().failure;
  }
  return tolerance;
}

}  // namespace

TopicResult reactions(const Scenes& scenes, const Effort& effort) {
  return on_driven_scene(scenes, [&](const DrivenScene& scene) {
    TopicResult result;
    const ReferenceMotion reference = reference_of(scene, instants_of(scene));
    const ErrorOf error_of(scene.mechanism, reference);

    // Which method, at positions to round-off.
    std::vector<Run> runs;
    const auto add = [&runs](Run run, std::size_t series, const std::string& setting) {
      run.series = series;
      if (!setting.empty()) run.point.setting = setting;
      runs.push_back(std::move(run));
    };
    std::size_t series = 0;
    for (const LinearMethod method :
         {LinearMethod::dense, LinearMethod::sparse, LinearMethod::orthogonal}) {
      add(newton_runs(scene, reference, {method, 2, true}, {1e-8}).front(), series,
          to_text(method));
      ++series;
    }
    add(normal_run(scene, reference), 3, "");
    add(differences_run(scene, reference), 4, "");
    add(program_run(scene, reference), 5, "");
    const std::size_t tolerances_from = runs.size();
    for (Run& run :
         newton_runs(scene, reference, {LinearMethod::sparse, 0, true}, tolerances_of(effort))) {
      runs.push_back(std::move(run));
    }
    time_runs(runs, reference.times.size(), effort);

    result.charts = methods_charts(scene, reference, {runs.data(), tolerances_from}, error_of);
    result.charts.push_back(tolerance_chart(scene, reference,
                                            std::span(runs).subspan(tolerances_from), error_of,
                                            result.charts.front().series[5].points.front()));
    result.charts.push_back(differences_chart(scene, reference, Quantity::reaction, effort));
    result.charts.back().name = "reactions-differences";
    return result;
  });
}

}  // namespace boxbeam::charts
