#pragma once

#include <string>

#include "boxbeam/study/study_reliability.hpp"

namespace boxbeam::program {

/// The limit state of a case, verified anew for every point; smooth as the logarithm of how many
/// times the wanted safety factor is there, -ln(utilisation), in which products of powers of
/// lognormal variables are planes. A design of which a gate stops the verdict, or of which a check
/// that is asked for is not judged, cannot be judged.
///
/// Verifies the design of all medians first. Throws InputError where a key, a criterion or a column
/// is none of the case, AnalysisError where it cannot be verified.
struct CaseLimitState {
  std::string sha256;  ///< of the study, the case and its tables
  LimitState limit_state;
};

CaseLimitState limit_state_of_case(const Study& study, std::size_t threads);

}  // namespace boxbeam::program
