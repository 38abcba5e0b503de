#pragma once

#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// Writes a report as PDF by pdflatex, which runs in a folder of its own where the figures stand as
/// NAME.tex or NAME.pdf ("" or absent: without figures). The same document gives the same bytes.
/// Throws OutputError where pdflatex is missing (naming the packages) or fails (its first error
/// line; its log is kept beside `path`).
void write_pdf(const Document& document, const std::string& figures, const std::string& path);

}  // namespace boxbeam::report
