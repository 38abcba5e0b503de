#pragma once

#include <string>
#include <string_view>

namespace boxbeam::report {

/// The code points of UTF-8. A byte that is none stands as 0xDC00 + byte, which is no code point of
/// any text (the way of Python's "surrogateescape", PEP 383).
/// Source: RFC 3629, 4: no overlong forms, no surrogates, nothing above U+10FFFF.
std::u32string code_points_of(std::string_view text);

}  // namespace boxbeam::report
