#pragma once

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// Whether loads on a beam of a mechanism in space change so fast that the vibration of the beam
/// may matter: more than the model's tolerance of its bending stresses, about both axes.
///
///     d" + omega^2 d = -sigma",  omega^2 = 3 E I/(m L^3)
///
/// what an undamped oscillator of the lowest frequency that can be has beside its statics; I the
/// least of the beams of the case, L the sum of their lengths and m all that is inert in the
/// mechanism, as at the tip of a cantilever. A slow load excites a higher frequency less. Histories
/// that close are gone through three times.
bool may_vibrate(const Project& project, const spatial::Mechanism& mechanism,
                 const LoadHistory& history);

}  // namespace boxbeam
