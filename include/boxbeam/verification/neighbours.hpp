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

/// The same of a pin that is to be replaceable, in service.
struct ServedPin {
  PinJoint geometry;
  PinStrength strength;
  Stress youngs_modulus;
};

/// A pin or rod of the mechanism, and what its factor follows from beside the acting force.
struct NeighbourResult {
  Check check;
  std::variant<LoadedPin, ServedPin, PulledRod, PressedRod> basis;
};

/// Checks of neighbours, what stands against them, and what bears no force at any time.
struct NeighbourChecks {
  std::vector<NeighbourResult> results;
  std::vector<Gate> gates;
  std::vector<NotJudged> not_judged;
};

/// The pins a case names, under the largest force of their joint in any situation, times its load
/// factor; one that is to be replaceable in service too, where load factors do not count, as a
/// check of its own. The factor is one on the force. Valid for rigid bodies, see `model_gates_of`.
/// Source: EN 1993-1-8:2005, 3.13.2.
NeighbourChecks check_pins(const Project& project, const std::deque<SituationRun>& runs);

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
NeighbourChecks check_rods(const Project& project, const std::deque<SituationRun>& runs);

/// Pins and rods.
NeighbourChecks check_neighbours(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
