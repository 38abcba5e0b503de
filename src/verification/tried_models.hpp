#pragma once

#include <deque>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/shared_motions.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Runs a case by elastic models, and keeps those of the last one that was asked how good it is:
/// mostly it is the one chosen.
class TriedModels {
 public:
  TriedModels(const Project& project, const SharedMotions& shared)
      : project_(&project), shared_(&shared) {}

  /// Largest difference of the stresses of a model, as `difference_between`, from a better one: a
  /// modal model with another mode and twice the parts.
  double error_found(const ElasticModel& model);

  /// The same of the last model tried from one with as many modes and twice the parts, which then
  /// is the last one tried.
  double error_of_parts();

  /// All situations by a model, run anew where it was not the last one tried.
  std::deque<SituationRun> take_runs(const ElasticModel& model);

 private:
  double error_against(const std::deque<SituationRun>& better) const;

  const Project* project_;
  const SharedMotions* shared_;
  ElasticModel tried_;
  std::deque<SituationRun> runs_;
};

}  // namespace boxbeam
