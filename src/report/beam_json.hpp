#pragma once

#include "boxbeam/verification/verify.hpp"
#include "json_number.hpp"

/// The beam in results.json.
namespace boxbeam {

/// Masses, and the cut forces at the verified stations.
Json beam_json(const Project& project, const Verification& verification);

/// The sections at the verified stations.
Json sections_json(const Project& project, const Verification& verification);

/// The concentration at every hole by every formula that was used, each once.
Json concentrations_json(const Verification& verification);

}  // namespace boxbeam
