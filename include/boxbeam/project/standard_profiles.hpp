#pragma once

#include <optional>
#include <string>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A profile of the catalogue.
struct StandardProfile {
  Profile profile;
  std::string source;
  bool unconfirmed = false;  ///< the size or the radii are recalled, not read in the standard
};

/// The profile of a designation, "RHS 200x100x8" (height, width, wall), "SHS 100x5", "CHS 168.3x8",
/// or nothing where the catalogue has none. Radii 1.5 t and 1.0 t. Source: EN 10210-2.
std::optional<StandardProfile> find_standard_profile(const std::string& designation);

/// What to write instead of a designation that is not known: the walls of that size, or the sizes
/// of that series, or the series.
std::string standard_profile_hint(const std::string& designation);

}  // namespace boxbeam
