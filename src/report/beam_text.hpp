#pragma once

#include <string>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// What acts on the beam at the critical instants, with heading.
std::string loads_section(const Project& project, const Verification& verification);

/// Smallest and largest cut forces along the beam and the critical instants, with heading.
std::string cut_force_section(const Project& project, const Verification& verification);

/// Properties of the sections at the checked stations, with heading.
std::string section_section(const Project& project, const Verification& verification);

}  // namespace boxbeam
