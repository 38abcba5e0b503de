#include "choice_of_frame.hpp"

#include <fmt/format.h>

#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "frame_vibration.hpp"
#include "mode_climb.hpp"

namespace boxbeam {

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

}  // namespace boxbeam
