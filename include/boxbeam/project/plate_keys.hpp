#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// Plates of a section that are made thicker together.
enum class PlateGroup { flanges, webs, walls };

/// A thickness of a case, and the key that says it.
struct PlateKey {
  std::string key;  ///< "sections.middle.flange", as --set takes it
  Length thickness;
};

/// Where a case says the thicknesses of a group in the sections of a segment, each key once; empty
/// where it does not: standard profiles, nested sections, sections without such plates, names that
/// --set cannot reach.
std::vector<PlateKey> plate_keys_of(const Project& project, std::size_t segment, PlateGroup group);

}  // namespace boxbeam
