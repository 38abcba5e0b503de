#pragma once

#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report::html {

/// The figure of designs, as data for the page's script.
std::string designs_figure(const DesignTable& table);

}  // namespace boxbeam::report::html
