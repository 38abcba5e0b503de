#pragma once

#include <string>

#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/mechanism.hpp"

namespace boxbeam {

/// The bodies of a mechanism in space and the joints that carry them, as tables.
std::string chain_tables(const spatial::Mechanism& mechanism);

/// Its drivers, loads, line forces, where the beam lies and the time looked at, in words with
/// units, an entry for each.
std::string chain_inputs(const spatial::Mechanism& mechanism,
                         const spatial::BeamPlacement& placement);

}  // namespace boxbeam
