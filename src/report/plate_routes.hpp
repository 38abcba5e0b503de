#pragma once

#include <string>

#include "blocks.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam::report {

/// By which route of EN 1993-1-5 slender plates are judged, how far they are used by it, and how
/// far by the other one; "" where none is slender.
std::string plate_routes_text(const Verification& verification);

}  // namespace boxbeam::report
