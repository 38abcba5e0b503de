#pragma once

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"

namespace boxbeam::flexible {

/// Loads on the beam that is a link at a time after the harmonic loads are switched on: joints,
/// loads, weight, and the inertia of the modes, in balance to round-off.
/// Precondition: `modes` are of this structure; the link's axis is that of the beam.
BeamLoads beam_loads_after_start(const Structure& structure, int link, const TaperedBeam& beam,
                                 const SuddenStartModes& modes, double time);

}  // namespace boxbeam::flexible
