#pragma once

#include "boxbeam/study/sensitivities.hpp"
#include "boxbeam/verification/verify.hpp"
#include "program/case_options.hpp"
#include "program/progress.hpp"

namespace boxbeam::program {

/// What changes the factors of a case that has been verified: it is verified four to six times
/// for each input, by as many threads as the machine runs at once.
Sensitivities sensitivities_of(const CaseOptions& options, const std::vector<VerifiedBeam>& beams,
                               Progress& progress);

}  // namespace boxbeam::program
