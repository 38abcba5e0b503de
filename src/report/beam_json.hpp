#pragma once

#include "boxbeam/verification/verify.hpp"
#include "fields.hpp"

/// The beam in results.json.
namespace boxbeam::report {

/// Sides of a station as documents write them.
inline constexpr FieldNames sides{"-", "+", "0"};

/// Masses, and the cut forces at the verified stations.
void put_beam(Fields& to, const Project& project, const Verification& verification);

/// The sections at the verified stations.
void put_sections(Fields& to, const Project& project, const Verification& verification);

/// The concentration at every hole by every formula that was used, each once.
void put_concentrations(Fields& to, const Verification& verification);

}  // namespace boxbeam::report
