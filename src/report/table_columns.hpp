#pragma once

#include <cstddef>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// A column of numbers, which stands at the right: every cell begins with a digit, a sign or is
/// "-".
bool holds_numbers(const Table& table, std::size_t column);

}  // namespace boxbeam::report
