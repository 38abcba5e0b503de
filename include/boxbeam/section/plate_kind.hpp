#pragma once

#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// What a plate is in its section, as far as it may be of a steel of its own.
enum class PlateKind {
  top_flange,
  bottom_flange,
  left_web,
  right_web,
  stiffener,
  inner,  ///< any wall of the inner profile
  wall,   ///< of a tube or a path, a solid: an outer profile without plates of its own
};
constexpr std::size_t plate_kinds = 7;

/// "top flange", "inner profile", ... as case files name them.
const std::vector<std::string>& plate_kind_names();

struct PlateAt {
  PlateKind kind = PlateKind::wall;
  Length thickness;
};

/// All plates of a section.
std::vector<PlateAt> plates_of(const Section& section);

/// The plates that hold or touch a place of a section: two where a web meets its flange or an inner
/// profile lies against the outer one. All of them where the place lies in none.
std::vector<PlateAt> plates_at(const Section& section, Length y, Length z);

}  // namespace boxbeam
