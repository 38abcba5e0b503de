#pragma once

#include <string>
#include <vector>

#include "boxbeam/mechanism/spatial/beam_loads.hpp"

namespace boxbeam {

/// Whether the second body of a joint moves along the first.
bool slides_along(spatial::JointKind kind);
bool slides_along(spatial::ClosingKind kind);

/// The joints that move along a body.
std::vector<std::string> joints_sliding_along(const spatial::Mechanism& mechanism, int body);

/// What slides or rolls along a body, by name; "" where nothing does.
std::string moving_along(const spatial::Mechanism& mechanism, int body);

/// How fast any moves along a beam, by the length of the first [1/s].
double sliding_along(const spatial::Mechanism& mechanism, const spatial::State& state,
                     const std::vector<spatial::BeamPlacement>& beams, double length);

}  // namespace boxbeam
