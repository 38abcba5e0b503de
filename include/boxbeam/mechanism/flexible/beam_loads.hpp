#pragma once

#include <string>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::flexible {

/// Loads on the beam that is a link, from the joints and loads on it, its weight and its inertia.
///
/// The inertia of the rigid elements is laid out along the beam so that force and moment of each
/// part stay what they are: what acts is in balance to round-off, and the moment within a part has
/// its local share q s (D - s)/2.
struct BeamResponse {
  BeamLoads constant;
  /// Amplitudes with sin(omega t) and cos(omega t); their places and stretches are those of
  /// `constant`, in the same order.
  BeamLoads sine, cosine;
  double frequency = 0.0;  ///< [Hz]
};

BeamResponse beam_response_of(const Structure& structure, int link, const TaperedBeam& beam,
                              const Response& response);

/// constant + sine sin(omega t) + cosine cos(omega t).
BeamLoads beam_loads_at(const BeamResponse& response, double time);

/// The joints and loads behind the point loads, in their order.
std::vector<std::string> names_of_beam_loads(const Mechanism& mechanism, int link);

}  // namespace boxbeam::flexible
