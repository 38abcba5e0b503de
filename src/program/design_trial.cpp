#include "program/design_trial.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/error.hpp"

namespace boxbeam::program {

std::vector<VerifiedBeam> verify_design(const CaseOptions& options,
                                        const std::vector<std::string>& set) {
  CaseOptions of = options;
  of.set.insert(of.set.end(), set.begin(), set.end());
  std::vector<Project> beams = read_beams_of(of);
  if (beams.size() == 1) beams.front().beam_name.clear();
  return verify_beams(std::move(beams));
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
