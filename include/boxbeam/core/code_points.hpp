#pragma once

#include <string>
#include <string_view>

/// The code points of UTF-8, and which of them a reader would not see.
namespace boxbeam {

/// A code point and the bytes that it takes.
struct CodePoint {
  char32_t code = 0;
  std::size_t length = 1;
};

/// The code point of UTF-8 at a place within the text. A byte that is none stands as 0xDC00 + byte,
/// which is no code point of any text (the way of Python's "surrogateescape", PEP 383).
/// Source: RFC 3629, 4: no overlong forms, no surrogates, nothing above U+10FFFF.
CodePoint code_point_at(std::string_view text, std::size_t at);

/// All of a text.
std::u32string code_points_of(std::string_view text);

/// With the capitals of ASCII made small.
std::string small_letters(std::string_view text);

/// Whether it is a byte that is not UTF-8.
bool is_stray_byte(char32_t code);

/// Whether it moves the cursor or cannot be seen: controls, line ends and tabs among them, marks of
/// writing direction, what has no width, bytes that are not UTF-8, and what is no character.
/// Joiners are none: some scripts are written with them.
bool is_hidden(char32_t code);

/// How a hidden code point is shown: "\x1B", "\n", "\u202E".
std::string escape_of(char32_t code);

/// The text with its hidden code points shown, but those of `kept`: "\n\t" leaves lines and tabs.
std::string visible(std::string_view text, std::string_view kept = "");

}  // namespace boxbeam
