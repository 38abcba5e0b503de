#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// Stops where a result is no number, or a factor is not above zero: the values of the case are too
/// far apart for the arithmetic. Throws AnalysisError that names the result.
void require_numbers(const std::vector<StationEnvelope>& stations,
                     const std::vector<CheckResult>& checks, const ModelChoice& model);
void require_numbers(const std::optional<ChainComparison>& chain);

/// Stops where more would be looked at than can be waited for: the instants of all situations that
/// run, times the places of the beam where something begins or ends. Throws AnalysisError that
/// names both.
void require_moderate_work(std::size_t instants, std::size_t places);

/// What is possible but can hardly be meant: a unit or a power of ten has probably slipped.
std::vector<std::string> odd_things(const Project& project, const Verification& verification);

}  // namespace boxbeam
