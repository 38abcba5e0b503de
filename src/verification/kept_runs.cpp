#include "boxbeam/verification/kept_runs.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "turned_runs.hpp"
#include "verify_each.hpp"

namespace boxbeam {

KeptRuns::OfBeam::OfBeam(const Project& project) : seen(as_runs_see(project)) {}

namespace {

std::string_view key_set_by(std::string_view change) { return change.substr(0, change.find('=')); }

bool is_partial_factor_of_strength(std::string_view key) {
  static constexpr std::array keys{"strength.gamma_M0", "strength.gamma_M1", "strength.gamma_M2"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Keys that give nothing but the factors that `take_factors` takes.
bool is_factor_in_fatigue(std::string_view key) {
  static constexpr std::array keys{"fatigue.gamma_Ff", "fatigue.gamma_Mf", "fatigue.required"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

void take_factors(const Project& from, StationMemory::Change change, Project& to) {
  to.fatigue.demand = from.fatigue.demand;
  to.fatigue.required = from.fatigue.required;
  if (change == StationMemory::Change::fatigue_factors) return;
  for (std::size_t i = 0; i < to.situations.size(); ++i) {
    to.situations[i].cycles = from.situations[i].cycles;
    to.situations[i].spectrum = from.situations[i].spectrum;
  }
  to.strength = from.strength;
  // Which have those of the strength where the case says no others.
  to.pins = from.pins;
  to.rods = from.rods;
}

}  // namespace

std::vector<VerifiedBeam> KeptRuns::verify(std::vector<Project> beams,
                                           const std::vector<std::string>& set) {
  using Change = StationMemory::Change;
  Set now;
  for (const std::string& change : set) {
    const std::string_view key = key_set_by(change);
    if (is_factor_in_fatigue(key)) continue;
    std::string& of = key == "fatigue.cycles"              ? now.cycles
                      : is_partial_factor_of_strength(key) ? now.of_strength
                                                           : now.places;
    of += change + '\n';
  }
  Change change = Change::any;
  if (before_ && before_->places == now.places) {
    const bool same_strength = before_->of_strength == now.of_strength;
    change = before_->cycles != now.cycles ? Change::cycles
             : same_strength               ? Change::fatigue_factors
                                           : Change::factors;
  }
  before_ = std::move(now);
  if (beams_.empty())
    for (const Project& project : beams) beams_.push_back(std::make_unique<OfBeam>(project));
  return verify_each(std::move(beams), [&](const Project& project, std::size_t i) {
    return judge_by(*beams_[i], project, change);
  });
}

Verification KeptRuns::judge_by(OfBeam& beam, const Project& project,
                                StationMemory::Change change) {
  ModelledRuns& moved = beam.moved;
  if (!beam.has_run) {
    moved = run_by_chosen_model(beam.seen, shared_);
    beam.has_run = true;
  }
  // What long records count depends on what was counted before.
  if (whole_life_of(moved.runs) != nullptr)
    return judge(project, run_situations(project, moved.model.chosen), moved.model);
  if (change == StationMemory::Change::any) {
    beam.design = std::make_unique<Project>(project);
    turn_to(*beam.design, moved.runs);
  } else {
    take_factors(project, change, *beam.design);
  }
  beam.memory.turn_to(*beam.design, change);
  return judge(*beam.design, moved.runs, moved.model, Figures::without, &beam.memory);
}

bool runs_depend_on(std::string_view change) {
  // What is asked of the strength decides under how many times the loads second order is looked at.
  const std::string_view key = key_set_by(change);
  return !key.starts_with("fatigue.") && !is_partial_factor_of_strength(key);
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
