#include "program/design_trial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/error.hpp"

namespace boxbeam::program {

std::vector<VerifiedBeam> DesignTrials::verify(const std::vector<std::string>& set) const {
  std::string looked_at;
  bool all = true;
  for (const std::string& change : set) {
    const bool counts = model_depends_on(change);
    if (counts) looked_at += change + '\n';
    all = all && counts;
  }
  std::call_once(opened_, [&] { source_.emplace(options_.file); });
  std::vector<Project> beams = read_beams_of(options_, *source_, set);
  if (beams.size() == 1) beams.front().beam_name.clear();
  if (all) return verify_beams(std::move(beams));
  const auto is_known = [&](const auto& of) { return of.first == looked_at; };
  std::vector<ModelChoice> models;
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(models_.begin(), models_.end(), is_known);
    if (known != models_.end()) models = known->second;
  }
  const bool known = !models.empty();
  std::vector<VerifiedBeam> verified = verify_beams_by(models, std::move(beams));
  constexpr std::size_t most = 64;
  const std::lock_guard lock(mutex_);
  if (known || std::any_of(models_.begin(), models_.end(), is_known)) return verified;
  models_.emplace_back(std::move(looked_at), std::move(models));
  if (models_.size() > most) models_.pop_front();
  return verified;
}

std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string in_short(const InputError& error) {
  const std::vector<Problem>& problems = error.problems();
  return in_one_line(problems.empty() ? error.what() : problems.front().message);
}

std::string in_short(const AnalysisError& error) {
  const AnalysisFailure& failure = error.failure();
  return in_one_line(failure.where.empty() ? failure.what
                                           : fmt::format("{}: {}", failure.where, failure.what));
}

}  // namespace boxbeam::program
