#pragma once

#include <string>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam {

/// Joints, drivers, forces, velocities at the start and the time looked at, in words with units, an
/// entry for each.
std::string mechanism_text(const planar::Mechanism& mechanism);

}  // namespace boxbeam
