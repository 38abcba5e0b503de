#pragma once

#include <string>

/// Text for LaTeX, with what is needed to lay it out. Widths are in em of the roman text font
/// (Latin Modern Roman at 10 pt), good to some percent.
namespace boxbeam::report {

/// As latex_escaped; a word wider than `limit` [em] can be broken: after its punctuation, and
/// anywhere where that is not enough.
std::string latex_breakable(const std::string& text, double limit);

/// As latex_escaped; what is wider than `room` [em] ends with an ellipsis.
std::string latex_shortened(const std::string& text, double room);

/// Width of a text on one line.
double latex_width(const std::string& text);

/// Width of the widest word of a text, at most `limit`: wider ones will be broken.
double latex_widest_word(const std::string& text, double limit);

/// A text in typewriter type, spaces kept, every sign of the same width and with a break allowed
/// after it: one line of a listing.
std::string latex_typewriter(const std::string& text);

/// A text as the content of a PDF string, in UTF-16 as \Bnnn for each byte nnn in octal; the
/// preamble makes \B a backslash. For bookmarks and the document's title.
/// Source: ISO 32000-1, 7.9.2.2.
std::string latex_pdf_string(const std::string& text);

}  // namespace boxbeam::report
