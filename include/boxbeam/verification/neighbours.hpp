#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A pin or rod of the mechanism, and what decides its check.
struct NeighbourResult {
  Check check;
  PinUtilisation pin;        ///< of a pin, under the acting force
  double slenderness = 0.0;  ///< of a rod, relative
  double reduction = 1.0;    ///< of a rod, chi
  bool weak_axis = false;    ///< a rod buckles about its z axis
};

/// The pins a case names, under the largest force of their joint in any situation, times its load
/// factor. The factor is one on the force. Valid for rigid bodies, see `model_gates_of`. Source: EN
/// 1993-1-8:2005, 3.13.2.
std::vector<NeighbourResult> check_pins(const Project& project,
                                        const std::deque<SituationRun>& runs);

/// The rods a case names, under their largest compression in any situation, times its load factor:
/// flexural buckling about the weaker axis. A rod is taken as hinged and straight; bending by its
/// own weight and inertia is not counted. Nothing for a rod that is never compressed.
/// Source: EN 1993-1-1:2005, 6.3.1.
std::vector<NeighbourResult> check_rods(const Project& project,
                                        const std::deque<SituationRun>& runs);

}  // namespace boxbeam
