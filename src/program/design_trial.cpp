#include "program/design_trial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/error.hpp"

namespace boxbeam::program {

VerifiedDesign DesignTrials::verify(const std::vector<std::string>& set) const {
  std::string looked_at;
  bool all = true;
  for (const std::string& change : set) {
    const bool counts = runs_depend_on(change);
    if (counts) looked_at += change + '\n';
    all = all && counts;
  }
  std::call_once(opened_, [&] { source_.emplace(options_.file); });
  std::vector<Project> beams = read_beams_of(options_, *source_, set);
  if (beams.size() == 1) beams.front().beam_name.clear();
  if (all) return {nullptr, verify_beams(std::move(beams))};
  std::optional<Kept> taken = take(std::move(looked_at));
  if (!taken) return {nullptr, verify_beams(std::move(beams))};
  auto kept = std::make_unique<Kept>(*std::move(taken));
  std::vector<VerifiedBeam> verified = kept->runs->verify(std::move(beams));
  const auto back = [this](Kept* of) { put_back(std::move(*std::unique_ptr<Kept>(of))); };
  return {std::shared_ptr<Kept>(kept.release(), back), std::move(verified)};
}

/// Designs that are alike follow each other but for those that other threads have.
bool DesignTrials::is_worth_keeping(const std::string& looked_at) const {
  constexpr std::size_t most = 64, enough = 8;
  const auto known = std::find(seen_.begin(), seen_.end(), looked_at);
  unlike_ = known == seen_.end() ? unlike_ + 1 : 0;
  if (known != seen_.end()) seen_.erase(known);
  seen_.push_front(looked_at);
  if (seen_.size() > most) seen_.pop_back();
  return unlike_ < enough;
}

std::optional<DesignTrials::Kept> DesignTrials::take(std::string looked_at) const {
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(idle_.begin(), idle_.end(),
                                  [&](const Kept& of) { return of.looked_at == looked_at; });
  const bool keeps = is_worth_keeping(looked_at);
  if (known == idle_.end()) {
    if (!keeps) return std::nullopt;
    return Kept{std::move(looked_at), std::make_unique<KeptRuns>()};
  }
  Kept kept = std::move(*known);
  idle_.erase(known);
  return kept;
}

void DesignTrials::put_back(Kept kept) const {
  constexpr std::size_t most = 32;
  const std::lock_guard lock(mutex_);
  idle_.push_front(std::move(kept));
  if (idle_.size() > most) idle_.pop_back();
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
