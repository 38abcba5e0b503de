#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Text for a screen or a plain file: what it takes of a line, and what it must not do there.
namespace boxbeam::plain_text {

/// Columns that a text takes: none for combining marks, two for wide letters of East Asia.
std::size_t columns_of(std::string_view text);

/// The words of a text in lines of at most `width` columns, the first of at most `first`; a word
/// that is longer than a line is broken. At least one line.
std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::size_t first);

}  // namespace boxbeam::plain_text
