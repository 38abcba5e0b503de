#pragma once

#include <vector>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// Gives contacts with dry friction a creep velocity that suits how fast they slide: at most
///
///     0.02 v_max
///
/// v_max their own largest sliding velocity over the time looked at, so that all but 2 % of the
/// friction acts wherever inertia or another load that turns with the motion is largest. Where that
/// time holds so many waves that the instants of a motion would not resolve it, 20 waves/24576 of
/// v_max. What is smaller already stays, and so do contacts that stand, all contacts where forces
/// decide the motion, and those of a motion that cannot be solved, of which its verification says
/// why. Dry friction knows no velocity: only the smoothing does. Source: Coulomb's law.
void fit_creep(Mechanism& mechanism, const std::vector<int>& joints);

}  // namespace boxbeam::planar
