#pragma once

#include <vector>

namespace boxbeam {

/// Point `index` of Halton's sequence, a coordinate in [0, 1) for each of so many dimensions: fills
/// the cube evenly without randomness. Source: Halton, Numerische Mathematik 2 (1960).
std::vector<double> halton_point(int index, int dimensions);

}  // namespace boxbeam
