#pragma once

#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// A calculation sheet for a terminal: "symbol = formula = values = result", what does not fit on
/// one line goes on below, notes under it.
std::string text_of(const Sheet& sheet);

}  // namespace boxbeam::report
