#pragma once

#include "boxbeam/verification/verify.hpp"
#include "json_number.hpp"

/// In results.json what the loads on the beam come from; null where a case has no such thing.
namespace boxbeam {

/// Gravity and the masses of rigid bodies; null for elastic links, whose mass lies along them.
Json mechanism_json(const Project& project);

/// Degrees of freedom by count and by rank; null for a chain in space and for elastic links.
Json freedom_json(const Verification& verification);

Json equivalent_mass_json(const Project& project, const Verification& verification);

/// The Newton chain's loads and the rigorous ones beside them.
Json newton_chain_json(const Verification& verification);

/// What joints and loads do to the beam at the critical instants.
Json loads_json(const Project& project, const Verification& verification);

}  // namespace boxbeam
