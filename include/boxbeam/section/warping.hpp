#pragma once

#include <optional>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// Warping constant I_w of a thin-walled path without cells, about its shear centre [m^6]; nothing
/// of other profiles.
///
///     I_w = int omega^2 dA - (int omega dA)^2/A,  omega(s) = int r ds
///
/// r  distance of a wall's mid-line from the shear centre. What warps over the thickness of walls
/// is left out, on the safe side. Source: Vlasov, Thin-walled elastic beams (1961).
std::optional<double> warping_constant_of(const Profile& profile);

}  // namespace boxbeam
