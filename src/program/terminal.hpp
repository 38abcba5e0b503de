#pragma once

#include <cstddef>
#include <string>

#include "boxbeam/report/marked_text.hpp"

/// Standard output and what a terminal can show.
namespace boxbeam::program {

/// Writes to standard output. Throws OutputError where it cannot be written.
void put(const std::string& text);

/// Likewise for people: what a user's text could do to a terminal is shown as its code, and the
/// words that say a result stand in colour, where colours are shown.
void put_text(const report::MarkedText& text);

/// The result of a command as JSON or as text, to where the user wants it: "-" is JSON on standard
/// output instead of the text, another name a file beside the text.
void put_result(const std::string& json_file, const std::string& json,
                const report::MarkedText& text);

/// Writes a line about what went wrong to standard error.
void put_error(const std::string& text);

/// Columns of the terminal that standard output is, from 60 to 200; else what COLUMNS says, or 110.
std::size_t columns();

/// Whether standard output shows colours: on a terminal that is not dumb, unless NO_COLOR is set or
/// CLICOLOR is 0; by CLICOLOR_FORCE also elsewhere.
bool shows_colours();

/// A word as a shell takes it whole: in quotes where it holds anything but letters, digits and
/// "._-/".
std::string shell_word(const std::string& word);

}  // namespace boxbeam::program
