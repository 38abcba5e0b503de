#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Yield strength of plates up to a thickness.
struct ThicknessStep {
  Length up_to;
  Stress yield_strength;
};

/// A structural steel: yield strength falls with plate thickness.
struct Material {
  std::string name;
  std::string source;
  std::vector<ThicknessStep> yield;  ///< thickness ascending
};

/// Yield strength of a plate of this thickness, or nothing where it is thicker than the table goes.
std::optional<Stress> yield_strength_of(const Material& material, Length thickness);

}  // namespace boxbeam
