#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/strength/material.hpp"

namespace boxbeam {

/// Standards that give the strengths of a steel, with different steps of thickness.
enum class SteelSource {
  en_10025_2,   ///< the product's: EN 10025-2, table 7
  en_1993_1_1,  ///< the design code's: EN 1993-1-1:2005, table 3.1, to 80 mm
};

/// "EN 10025-2", "EN 1993-1-1".
const char* to_text(SteelSource source);

/// A structural steel of the built-in catalogue (sections/catalogue/steels.toml), by name, with the
/// lower strengths of all sources at every thickness.
std::optional<Material> find_steel(const std::string& name);

/// The same with the strengths of one source.
std::optional<Material> find_steel(const std::string& name, SteelSource source);

/// The names of all steels there.
std::vector<std::string> steel_names();

}  // namespace boxbeam
