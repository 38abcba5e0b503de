#pragma once

#include <optional>

#include "boxbeam/strength/box_distortion.hpp"

namespace boxbeam {

/// The only cell of a path, where it is a rectangle along y and z whose four plates are each of one
/// thickness; the lines are the mid-lines of its plates.
struct PathCell {
  BoxCell cell;
  Length left, right;  ///< high and low y
  Length top, bottom;
};

/// Nothing of open paths, of several cells and of other shapes. What hangs on the cell may lie
/// within it or lead a plate of it on.
std::optional<PathCell> path_cell_of(const ThinWalled& path);

}  // namespace boxbeam
