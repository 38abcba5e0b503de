#pragma once

#include <string>

#include "drawing.hpp"

namespace boxbeam::plot {

/// What gnuplot 5's terminal "svg" drew: its lines, areas, marks and words. Of SVG it knows what
/// that terminal writes. Throws OutputError where something else stands.
Drawing drawing_of_gnuplot(const std::string& svg);

}  // namespace boxbeam::plot
