#pragma once

#include <string>
#include <string_view>

namespace boxbeam {

/// What to write instead of a line that is not TOML, from what stands there: the place, a column in
/// characters from 1, and the words of the parser. Never empty.
std::string toml_hint(std::string_view line, int column, std::string_view description);

}  // namespace boxbeam
