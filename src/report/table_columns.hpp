#pragma once

#include <cstddef>
#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// Whether a cell is a number: it begins with a digit, which a sign may precede, or is a sign by
/// itself.
bool is_number(const std::string& cell);

/// A column of numbers, which stands at the right: every cell is one, but what is left out of any
/// column but the first.
bool holds_numbers(const Table& table, std::size_t column);

}  // namespace boxbeam::report
