#pragma once

#include <cstddef>
#include <string>

#include "boxbeam/report/document.hpp"
#include "boxbeam/report/marked_text.hpp"

namespace boxbeam::report {

/// Columns of a report in a file.
inline constexpr std::size_t report_columns = 110;

/// A report as plain text.
std::string text_of(const Document& document, std::size_t width = report_columns);

/// A calculation sheet as plain text, in a frame of so many columns.
MarkedText text_of(const Sheet& sheet, std::size_t width = report_columns);

}  // namespace boxbeam::report
