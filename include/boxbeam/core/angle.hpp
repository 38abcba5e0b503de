#pragma once

#include <numbers>

namespace boxbeam {

/// Radians of a whole turn.
inline constexpr double full_turn = 2.0 * std::numbers::pi;

}  // namespace boxbeam
