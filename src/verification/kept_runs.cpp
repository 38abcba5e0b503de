#include "boxbeam/verification/kept_runs.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "turned_runs.hpp"
#include "verify_each.hpp"

namespace boxbeam {

KeptRuns::OfBeam::OfBeam(const Project& project) : seen(as_runs_see(project)) {}

std::vector<VerifiedBeam> KeptRuns::verify(std::vector<Project> beams) {
  if (beams_.empty())
    for (const Project& project : beams) beams_.push_back(std::make_unique<OfBeam>(project));
  return verify_each(std::move(beams), [&](const Project& project, std::size_t i) {
    return judge_by(*beams_[i], project);
  });
}

Verification KeptRuns::judge_by(OfBeam& beam, const Project& project) {
  ModelledRuns& moved = beam.moved;
  if (!beam.has_run) {
    moved = run_by_chosen_model(beam.seen, shared_);
    beam.has_run = true;
  }
  // What long records count depends on what was counted before.
  if (whole_life_of(moved.runs) != nullptr)
    return judge(project, run_situations(project, moved.model.chosen), moved.model);
  turn_to(project, moved.runs);
  beam.memory.stations.turn_to(project);
  return judge(project, moved.runs, moved.model, Figures::without, &beam.memory);
}

bool runs_depend_on(std::string_view key) {
  // What is asked of the strength decides under how many times the loads second order is looked at.
  static constexpr std::array partial_factors{"strength.gamma_M0", "strength.gamma_M1",
                                              "strength.gamma_M2"};
  const std::string_view name = key.substr(0, key.find('='));
  return !name.starts_with("fatigue.") &&
         std::find(partial_factors.begin(), partial_factors.end(), name) == partial_factors.end();
}

Project as_runs_see(const Project& project) {
  Project seen = project;
  seen.fatigue = {};
  seen.fatigue.asked = project.fatigue.asked;
  seen.strength.gamma_M0 = seen.strength.gamma_M1 = seen.strength.gamma_M2 = 1.0;
  for (Situation& of : seen.situations) of.cycles = of.cycles > 0.0 ? 1.0 : 0.0;
  return seen;
}

}  // namespace boxbeam
