#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Strengths of plates up to a thickness.
struct ThicknessStep {
  Length up_to;
  Stress yield_strength;    ///< f_y, R_eH
  Stress tensile_strength;  ///< f_u, lower end of R_m
};

/// A structural steel: its strengths fall with plate thickness.
struct Material {
  std::string name;
  std::string source;                ///< of the strengths
  double beta_w = 1.0;               ///< correlation factor of fillet welds, EN 1993-1-8, table 4.1
  std::vector<ThicknessStep> steps;  ///< thickness ascending
};

/// Strength of a plate of this thickness, or nothing where it is thicker than the table goes.
std::optional<Stress> yield_strength_of(const Material& material, Length thickness);
std::optional<Stress> tensile_strength_of(const Material& material, Length thickness);

/// A steel of one strength at every thickness.
Material steel_of(Stress yield_strength);

/// The same steel by two sources: at every thickness the lower strength of both, and that of one
/// alone where the other ends.
Material lower_of(const Material& one, const Material& other);

}  // namespace boxbeam
