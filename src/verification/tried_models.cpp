#include "tried_models.hpp"

#include <algorithm>

#include "boxbeam/verification/vibrating_stress.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

/// Stresses of two histories at the even instants of the better one. A motion that ends at rest has
/// stresses behind its end by every model.
struct StressesOfBoth {
  Eigen::MatrixXd model, better;
};

StressesOfBoth stresses_of_both(const Project& project, const LoadHistory& model,
                                const LoadHistory& better) {
  const LoadSpan& span = better.span();
  const bool alike = model.span().instants == span.instants && model.period() == better.period();
  if (project.in_space)
    return {alike ? stress_history_in_space(model, project.beam)
                  : stress_history_in_space(model, project.beam, span),
            stress_history_in_space(better, project.beam)};
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  Eigen::MatrixXd of_better = stress_history(better, places);
  if (alike) return {stress_history(model, places), std::move(of_better)};
  Eigen::MatrixXd of_model(of_better.rows(), of_better.cols());
  for (Eigen::Index i = 0; i < of_model.rows(); ++i) {
    const Time time =
        span.begin + span.period * static_cast<double>(i) / static_cast<double>(span.instants);
    of_model.row(i) = fibre_stresses(model.diagram_at(time), places).transpose();
  }
  return {std::move(of_model), std::move(of_better)};
}

/// How far two histories of stresses are apart, as `difference_between`.
double difference_between(const Eigen::MatrixXd& model, const Eigen::MatrixXd& of_better) {
  const Eigen::MatrixXd difference = model - of_better;
  const double range = largest_range(of_better);
  const double apart = difference.cwiseAbs().maxCoeff() / of_better.cwiseAbs().maxCoeff();
  return range > 0.0 ? std::max(apart, largest_range(difference) / range) : apart;
}

/// A modal model with another mode and twice the parts; of rigid bodies one with one mode.
ElasticModel better_than(const ElasticModel& model) {
  constexpr int parts = 8;
  return {ModelLevel::modal, model.modes + 1, std::max(parts, 2 * model.parts), {}, false,
          model.bends_twice};
}

bool are_same(const ElasticModel& some, const ElasticModel& other) {
  const auto& [level, modes, parts, element, axial, bends_twice] = some;
  return level == other.level && modes == other.modes && parts == other.parts &&
         element == other.element && axial == other.axial && bends_twice == other.bends_twice;
}

}  // namespace

double TriedModels::error_against(const std::deque<SituationRun>& better) const {
  double found = 0.0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const StressesOfBoth of = stresses_of_both(*project_, runs_[i].loads, better[i].loads);
    found = std::max(found, difference_between(of.model, of.better));
  }
  return found;
}

double TriedModels::error_found(const ElasticModel& model) {
  if (runs_.empty() || !are_same(model, tried_)) {
    runs_.clear();
    tried_ = model;
    runs_ = run_situations(*project_, model, *shared_);
  }
  return error_against(run_situations(*project_, better_than(model), *shared_));
}

double TriedModels::error_of_parts() {
  ElasticModel finer = tried_;
  finer.parts *= 2;
  std::deque<SituationRun> by_finer = run_situations(*project_, finer, *shared_);
  const double found = error_against(by_finer);
  tried_ = finer;
  runs_ = std::move(by_finer);
  return found;
}

std::deque<SituationRun> TriedModels::take_runs(const ElasticModel& model) {
  if (!runs_.empty() && are_same(model, tried_)) return std::move(runs_);
  return run_situations(*project_, model, *shared_);
}

}  // namespace boxbeam
