#pragma once

#include <optional>
#include <string>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// What is impossible about a section, or nothing: a non-positive dimension, walls that leave no
/// hollow, radii that do not fit, a stiffener outside the box or in another one, a loop that
/// crosses itself or another, walls that do not hang together, an inner profile that does not fit
/// the clear space.
std::optional<std::string> defect_of(const Section& section);

/// Where a plate is thinner than a ten thousandth of its profile: no plate is, it has another unit.
/// "1e-05 mm thin in a profile of 300 mm", or nothing. Precondition: no defect.
std::optional<std::string> foil_in(const Section& section);

}  // namespace boxbeam
