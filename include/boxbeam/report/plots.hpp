#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// Draws the figures of a verification into a folder by gnuplot: cut-forces.svg, mechanism.svg,
/// loads.svg (in space only), stress.svg (computed stresses only) and sn.svg. The scripts stay in
/// its folder "plots", with their data inside, so that a figure can be restyled: `gnuplot
/// plots/cut-forces.gp`. Returns the names of what was written, relative to the folder. Throws
/// OutputError where gnuplot is missing (naming the package) or fails.
std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder);

/// Removes the figures of an earlier run, so that none stands beside a report it does not belong
/// to.
void remove_figures(const std::string& folder);

}  // namespace boxbeam
