#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plot_script.hpp"

namespace boxbeam {

/// A figure by its name, and what writes its script.
struct DrawnFigure {
  std::string name;
  std::function<void(plot::Script&)> draw;
};

/// Draws figures into a folder by gnuplot, NAME.svg each, and where `pdf_folder` is not empty
/// NAME.pdf there; their scripts stay in its folder "plots". All or none: until the last is drawn
/// nothing is moved to its place. Returns the names of the SVG files. Throws OutputError where
/// gnuplot is missing or fails.
std::vector<std::string> draw_into(const std::string& folder, const std::string& pdf_folder,
                                   const std::vector<DrawnFigure>& figures);

}  // namespace boxbeam
