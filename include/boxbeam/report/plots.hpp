#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// Draws the figures of a verification into a folder by gnuplot, NAME.svg each, and where
/// `tex_folder` is not empty NAME.tex there, for the PDF. The scripts stay in its folder "plots",
/// with their data inside, so that a figure can be restyled: `gnuplot plots/cut-forces.gp`. Returns
/// the names of the SVG files, relative to the folder. Throws OutputError where gnuplot is missing
/// (naming the package) or fails.
std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder,
                                      const std::string& tex_folder = "");

/// The files that figures of any verification have in a folder, so that none of an earlier run
/// stands beside a report it does not belong to.
std::vector<std::string> files_of_figures();

}  // namespace boxbeam
