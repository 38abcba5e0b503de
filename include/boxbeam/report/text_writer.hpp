#pragma once

#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// A report as plain text, 110 columns.
std::string text_of(const Document& document);

/// A calculation sheet as plain text.
std::string text_of(const Sheet& sheet);

}  // namespace boxbeam::report
