#pragma once

#include <optional>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// How a thin-walled path without cells warps about its shear centre.
struct Warping {
  double I_w = 0.0;      ///< [m^6]
  double largest = 0.0;  ///< size of omega, of mean zero, where it is largest, on mid-lines [m^2]
};

/// Nothing of other profiles.
///
///     I_w = int omega^2 dA - (int omega dA)^2/A,  omega(s) = int r ds
///
/// r  distance of a wall's mid-line from the shear centre. What warps over the thickness of walls
/// is left out, on the safe side. Source: Vlasov, Thin-walled elastic beams (1961).
std::optional<Warping> warping_of(const Profile& profile);

/// Its I_w alone [m^6].
std::optional<double> warping_constant_of(const Profile& profile);

}  // namespace boxbeam
