#pragma once

#include <string>

#include "drawing.hpp"

namespace boxbeam::plot {

/// A drawing for a document with the preamble of reports: lines as operators of PDF, words in its
/// own type. As wide as the text of a page where it is `figure_width` wide.
std::string latex_of(const Drawing& drawing);

}  // namespace boxbeam::plot
