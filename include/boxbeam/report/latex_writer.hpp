#pragma once

#include <functional>
#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// A report as a LaTeX document (pdflatex; packages of texlive-latex-recommended and lmodern only).
/// `has_picture` says which figures stand as NAME.tex or NAME.pdf beside it.
std::string latex_of(const Document& document,
                     const std::function<bool(const std::string& name)>& has_picture);

/// Any text for LaTeX, as it was written: special signs, letters of Latin and Greek; what the fonts
/// do not have stands as its code point, "U+4E2D".
std::string latex_escaped(const std::string& text);

}  // namespace boxbeam::report
