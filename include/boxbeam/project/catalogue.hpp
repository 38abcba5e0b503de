#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/strength/material.hpp"

namespace boxbeam {

/// A structural steel of the built-in catalogue (sections/catalogue/steels.toml), by name, with the
/// lower strengths of all sources at every thickness: of its product standard and of the design
/// code.
std::optional<Material> find_steel(const std::string& name);

/// The same with the strengths of one source, "EN 10025-2" or "EN 1993-1-1"; nothing where it does
/// not have the steel.
std::optional<Material> find_steel(const std::string& name, const std::string& source);

/// The names of all steels there, without those that are another's second name.
std::vector<std::string> steel_names();

/// The sources of their strengths.
const std::vector<std::string>& steel_sources();

/// The sources that have a steel.
std::vector<std::string> sources_of_steel(const std::string& name);

}  // namespace boxbeam
