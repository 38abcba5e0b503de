#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/strength/material.hpp"

namespace boxbeam {

/// A structural steel of the built-in catalogue (sections/catalogue/steels.toml), by name.
std::optional<Material> find_steel(const std::string& name);

/// The names of all steels there.
std::vector<std::string> steel_names();

}  // namespace boxbeam
