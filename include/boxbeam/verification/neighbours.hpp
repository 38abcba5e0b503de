#pragma once

#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/strength/rod.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A pin and its plates, as checked.
struct LoadedPin {
  PinJoint geometry;
  PinStrength strength;
};

/// A pin or rod of the mechanism, and what its factor follows from beside the acting force.
struct NeighbourResult {
  Check check;
  std::variant<LoadedPin, PulledRod, PressedRod> basis;
};

/// The pins a case names, under the largest force of their joint in any situation, times its load
/// factor. The factor is one on the force. Valid for rigid bodies, see `model_gates_of`. Nothing
/// for a pin without force. Source: EN 1993-1-8:2005, 3.13.2.
std::vector<NeighbourResult> check_pins(const Project& project,
                                        const std::deque<SituationRun>& runs);

/// Checks of rods, and what stands against them.
struct RodChecks {
  std::vector<NeighbourResult> results;
  std::vector<Gate> gates;
  std::vector<std::string> unloaded;  ///< names of rods that bear no force at any time
};

/// The rods a case names, under their largest tension and their largest compression in any
/// situation, times its load factor: yield and net section; the section, and flexural
/// buckling about the weaker axis, in class 4 with the effective area, the slenderness by it too
/// (6.3.1.2). A rod is taken as straight, hinged and of even mass: the force in it is that at its
/// ends, and its own centrifugal force adds up to m omega^2 L/8 between them; bending by its own
/// weight and inertia is not counted. No check for a direction in which a rod is never loaded.
///
/// Gates that block: a section that cannot be judged where it is compressed; joints and forces that
/// load the rod between its ends or turn it, whose bending is not counted.
/// Source: EN 1993-1-1:2005, 6.2.3, 6.2.4 and 6.3.1.
RodChecks check_rods(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
