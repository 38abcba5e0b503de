#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// Each beam of a case as `verified_as` finds it, by its index; what goes wrong says of which one.
template <class Verify>
std::vector<VerifiedBeam> verify_each(std::vector<Project> beams, const Verify& verified_as) {
  std::vector<VerifiedBeam> verified;
  // Motions and loads look at the cases, which stay where they are.
  verified.reserve(beams.size());
  for (Project& project : beams) verified.push_back({std::move(project), {}});
  for (std::size_t i = 0; i < verified.size(); ++i) {
    VerifiedBeam& beam = verified[i];
    try {
      beam.verification = verified_as(beam.project, i);
    } catch (const AnalysisError& error) {
      if (beam.project.beam_name.empty()) throw;
      AnalysisFailure failure = error.failure();
      failure.details.push_back("beam  " + beam.project.beam_name);
      throw AnalysisError(std::move(failure));
    }
  }
  return verified;
}

}  // namespace boxbeam
