#pragma once

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {

/// "a table", "a bare number": what a case has where something else is wanted.
const char* kind_name(const Node& node);

/// Of bare numbers above zero: below it none is meant.
inline constexpr double smallest_number = 1e-20;

}  // namespace boxbeam
