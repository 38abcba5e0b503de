#include "boxbeam/verification/model_choice.hpp"

#include <fmt/format.h>

#include <deque>
#include <memory>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "frame_vibration.hpp"
#include "model_choices.hpp"
#include "second_order_growth.hpp"
#include "tried_models.hpp"

namespace boxbeam {
namespace {

/// Whether a frame at rest vibrates under loads over time by more than is tolerated, and if so the
/// first modes that are known to hold what does; loads act slowly where none are.
void choose_for_frame(const Project& project, TriedModels& tried, ModelChoice& choice,
                      std::deque<SituationRun>& runs) {
  FrameVibration worst;
  for (const SituationRun& run : runs) {
    FrameVibration of = estimate_vibration_of_frame(project, run);
    if (!of.obstacle.empty()) {
      choice.reason += "; loads act slowly: what vibration adds is not estimated: " + of.obstacle;
      return;
    }
    if (of.estimate.frequencies.empty()) continue;
    if (worst.estimate.frequencies.empty() ||
        of.estimate.without_modes.front() > worst.estimate.without_modes.front())
      worst = std::move(of);
  }
  const VibrationEstimate& estimate = worst.estimate;
  if (estimate.frequencies.empty()) return;
  const double missed = estimate.without_modes.front();
  choice.frequencies = estimate.frequencies;
  choice.harmonics = estimate.harmonics;
  choice.weighed.push_back(
      {choice.chosen,
       fmt::format("response over time of the frame's modes {}", percent_text(missed)),
       missed,
       {}});
  const ModelDemand demand = project.model.demand;
  choice.reason += fmt::format(
      "; the lowest natural frequency of the frame is {:.4g} Hz ({}), vibration is estimated to "
      "change the governing stress by {}, tolerance {}",
      estimate.frequencies.front(), worst.shape, percent_text(missed),
      percent_text(choice.tolerance));
  if (project.model.measured_loads || demand == ModelDemand::rigid ||
      (demand == ModelDemand::automatic && missed <= choice.tolerance)) {
    choice.reason += ": loads act slowly";
    return;
  }
  std::string why = fmt::format("{} modes are not known to be within {} either",
                                estimate.frequencies.size(), percent_text(choice.tolerance));
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k) {
    const ElasticModel model{ModelLevel::modal, static_cast<int>(k), 8, {}, false};
    if (estimate.without_modes[k] > choice.tolerance) continue;
    why = too_fast(runs, estimate.frequencies, k + 1);
    if (!why.empty()) break;
    try {
      const double found = tried.error_found(model);
      if (found > choice.tolerance) continue;
      choice.weighed.push_back({model, "modes left out", estimate.without_modes[k], found});
      choice.chosen = model;
      choice.reason += fmt::format(
          "; loads over time by {}, found {} against one mode more and "
          "twice the parts; reactions of supports are those of statics",
          describe(model), percent_text(found));
      runs = tried.take_runs(model);
      return;
    } catch (const AnalysisError& error) {
      why = error.failure().what;
    }
  }
  choice.reason += "; loads act slowly, no modes are used: " + why;
}

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
