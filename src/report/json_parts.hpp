#pragma once

#include "boxbeam/verification/verify.hpp"
#include "fields.hpp"

/// Parts of results.json; null where a case has no such thing.
namespace boxbeam::report {

/// Sides of a station as documents write them.
inline constexpr FieldNames sides{"-", "+", "0"};

/// Masses, and the cut forces at the verified stations.
void put_beam(Fields& to, const Project& project, const Verification& verification);

/// The sections at the verified stations.
void put_sections(Fields& to, const Project& project, const Verification& verification);

/// The concentration at every hole by every formula that was used, each once.
void put_concentrations(Fields& to, const Verification& verification);

/// Gravity and the masses of rigid bodies; null for elastic links, whose mass lies along them.
void put_mechanism(Fields& to, const Project& project);

/// Degrees of freedom by count and by rank; null for a chain in space and for elastic links.
void put_freedom(Fields& to, const Verification& verification);

void put_equivalent_mass(Fields& to, const Project& project, const Verification& verification);

/// The Newton chain's loads and the rigorous ones beside them.
void put_newton_chain(Fields& to, const Verification& verification);

/// What joints and loads do to the beam at the critical instants.
void put_loads(Fields& to, const Project& project, const Verification& verification);

/// The name of a situation by its index.
std::string situation_name(const Project& project, std::size_t situation);

}  // namespace boxbeam::report
