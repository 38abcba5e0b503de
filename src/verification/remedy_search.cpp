#include "remedy_search.hpp"

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// Runs whose situations are those of a copy of their case for a while.
class LentRuns {
 public:
  LentRuns(std::deque<SituationRun>& runs, const Project& owner, const Project& copy)
      : runs_(runs) {
    for (SituationRun& run : runs) {
      owned_.push_back(run.situation);
      run.situation = &copy.situations[index_of(owner, *run.situation)];
    }
  }
  LentRuns(const LentRuns&) = delete;
  LentRuns& operator=(const LentRuns&) = delete;
  ~LentRuns() {
    for (std::size_t i = 0; i < owned_.size(); ++i) runs_[i].situation = owned_[i];
  }

 private:
  std::deque<SituationRun>& runs_;
  std::vector<const Situation*> owned_;
};

}  // namespace

std::optional<Passing> first_passing(std::size_t count,
                                     const std::function<Outcome(std::size_t)>& outcome) {
  if (count == 0) return std::nullopt;
  const Outcome strongest = outcome(count - 1);
  if (!strongest) return std::nullopt;
  Passing passing{count - 1, *strongest};
  for (std::size_t low = 0; low < passing.candidate;) {
    const std::size_t middle = low + (passing.candidate - low) / 2;
    if (const Outcome at = outcome(middle))
      passing = {middle, *at};
    else
      low = middle + 1;
  }
  return passing;
}

bool RemedySearch::is_elastic() const {
  const bool bends =
      verification.model.bends_rigid_motion && verification.model.chosen.level != ModelLevel::rigid;
  return bends || std::holds_alternative<flexible::Mechanism>(project.mechanism);
}

Outcome RemedySearch::judged(const Project& copy) const {
  const LentRuns lent(runs, project, copy);
  return utilisation_if_it_passes(copy, runs, verification.model);
}

std::optional<Project> RemedySearch::changed_by(const std::vector<std::string>& set) const {
  std::vector<std::string> overrides = project.overrides;
  overrides.insert(overrides.end(), set.begin(), set.end());
  try {
    Project changed = std::move(
        parse_beams(project.path, project.text, overrides, project.dynamics)[project.beam_index]);
    changed.model.demand = project.model.demand;
    changed.model.tolerance = project.model.tolerance;
    return changed;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Outcome RemedySearch::verified(const Project& changed) {
  try {
    return utilisation_if_it_passes(changed);
  } catch (const AnalysisError&) {
    return std::nullopt;
  }
}

}  // namespace boxbeam
