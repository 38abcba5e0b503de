#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "drawing.hpp"
#include "plot_script.hpp"

namespace boxbeam {

/// A figure by its name, and what draws it: gnuplot by a script, or this program.
struct DrawnFigure {
  std::string name;
  std::variant<std::function<void(plot::Script&)>, std::function<plot::Drawing()>> draw;
};

/// Draws figures into a folder, NAME.svg each, and where `tex_folder` is not empty NAME.tex there,
/// for the PDF; the scripts of those that gnuplot draws stay in its folder "plots". All or none:
/// until the last is drawn nothing is moved to its place. Returns the names of the SVG files.
/// Throws OutputError where gnuplot is missing or fails.
std::vector<std::string> draw_into(const std::string& folder, const std::string& tex_folder,
                                   const std::vector<DrawnFigure>& figures);

}  // namespace boxbeam
