#include "boxbeam/verification/model_choice.hpp"

#include <memory>

#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "choice_in_plane.hpp"
#include "choice_in_space.hpp"
#include "choice_of_frame.hpp"
#include "frame_vibration.hpp"
#include "second_order_growth.hpp"
#include "tried_models.hpp"
#include "unvibrated_choice.hpp"

namespace boxbeam {
namespace {

/// Rigid bodies for loads that were measured; else what the estimate says, and where it says that
/// the beam vibrates under loads from a table, that they may have been measured.
ModelChoice choose_for_rigid(const Project& project, const std::deque<SituationRun>& rigid,
                             const std::string& obstacle, TriedModels& tried) {
  if (project.model.measured_loads && project.model.demand != ModelDemand::flexible) {
    DesignedSecondOrder second = estimate_designed_second_order(project, rigid);
    ModelChoice choice = begun_choice(project, std::move(second.estimate));
    choose_unvibrated(project, "the loads are measured, they contain the vibration", choice, "");
    if (choice.counts_second_order) choice.second_order.growth = std::move(second.beyond_once);
    return choice;
  }
  DesignedSecondOrder second = estimate_designed_second_order(project, rigid);
  if (std::holds_alternative<spatial::Mechanism>(project.mechanism)) {
    ModelChoice choice =
        choose_in_space(project, rigid, obstacle, tried, std::move(second.estimate));
    if (choice.counts_second_order) choice.second_order.growth = std::move(second.beyond_once);
    return choice;
  }
  return choose_in_plane(project, rigid, obstacle, tried, std::move(second));
}

}  // namespace

const char* to_text(ModelLevel level) {
  switch (level) {
    case ModelLevel::rigid: return "rigid";
    case ModelLevel::quasi_static: return "quasi-static";
    case ModelLevel::modal: return "modal";
    case ModelLevel::flexible: return "flexible";
  }
  return "";
}

bool knows_second_order(const ModelChoice& model) {
  const SecondOrderEstimate& of = model.second_order;
  return model.counts_second_order || (of.whole && of.change && *of.change <= model.tolerance);
}

ModelledRuns run_by_chosen_model(const Project& project, const SharedMotions& shared) {
  const std::unique_ptr<const FrontEnd> front_end = front_end_of(project);
  TriedModels tried(project, shared);
  if (std::optional<ModelChoice> own = front_end->own_model()) {
    std::deque<SituationRun> runs = run_situations(project, own->chosen, shared);
    own->second_order = estimate_second_order(project, runs);
    own->reason += "; " + second_order_text(own->second_order);
    if (has_loads_over_time(project)) choose_for_frame(project, tried, *own, runs);
    return {std::move(*own), std::move(runs)};
  }
  std::deque<SituationRun> rigid = run_situations(project, {}, shared);
  const std::string obstacle = front_end->obstacle_to_vibration(rigid);
  ModelChoice model = choose_for_rigid(project, rigid, obstacle, tried);
  if (model.chosen.level == ModelLevel::rigid) return {std::move(model), std::move(rigid)};
  std::deque<SituationRun> runs = tried.take_runs(model.chosen);
  const bool in_plane = std::holds_alternative<planar::Mechanism>(project.mechanism);
  if (obstacle.empty() && in_plane) weigh_balance(project, rigid, runs, model);
  return {std::move(model), std::move(runs)};
}

ModelChoice choose_model(const Project& project) { return run_by_chosen_model(project, {}).model; }

}  // namespace boxbeam
