#pragma once

#include "boxbeam/section/wall_cells.hpp"

namespace boxbeam {

/// Of the cells of walls only how they are cut open: what hangs on each wall, and the material of
/// each component.
WallCells opened_walls_of(const WallGraph& graph);

}  // namespace boxbeam
