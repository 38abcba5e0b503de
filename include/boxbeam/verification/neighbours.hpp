#pragma once

#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/strength/rod.hpp"
#include "boxbeam/verification/checks.hpp"
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

/// A plate of a pin in strength: its part of the pin's force, and what bears it.
struct LoadedLug {
  double share = 1.0;
  Lug plate;
  Stress yield_strength;
  double gamma_M0 = 1.0;
};

/// A plate of a pin in fatigue.
struct TiredLug {
  const LugInput* lug = nullptr;
  double share = 1.0;      ///< of the pin's force
  Force range;             ///< of the whole force, along the direction below
  double direction = 0.0;  ///< of the components that take most of the life, across the pin's axis
  std::string seen;        ///< where that is: "at 30.0 deg in the axes of crank", "along the rod"
  CheckBasis life;
  std::optional<Stress> limit;  ///< of the range, where this is reached before the life is used up
};

/// A pin or rod of the mechanism, and what its factor follows from beside the acting force.
struct NeighbourResult {
  Check check;
  std::variant<LoadedPin, ServedPin, LoadedLug, TiredLug, PulledRod, PressedRod> basis;
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
/// With them the plates that the case describes as lugs, whatever the direction of the force: width
/// and end are to be no less in any direction in which it pulls.
/// Source: EN 1993-1-8:2005, 3.13.1, table 3.9, and 3.13.2.
NeighbourChecks check_pins(const Project& project, const std::deque<SituationRun>& runs);

/// The plates of pins that a case describes as lugs, in fatigue: the stress at the hole, K_t
/// F/A_net of the plate's part of the force, against the lug's detail. The force may turn: looked
/// at are its components along directions of the plane, 36 of half a turn and then between them
/// where they take most of the life, in the axes of both bodies of the joint, for the plate turns
/// with one of them. So a range is the way between two places of the force's tip, never less than
/// what its size changes. What pushes counts as what pulls does, and the mean has no say. The range
/// is limited by 1.5 f_y as well, 8(1). Source: EN 1993-1-9:2005, 6.3, 8 and annex A.
NeighbourChecks check_lugs(const Project& project, const std::deque<SituationRun>& runs);

/// The rods a case names, under their largest tension and their largest compression in any
/// situation, times its load factor: yield and net section; the section, and flexural
/// buckling about the weaker axis, of thin-walled paths with twisting (6.3.1.4), in class 4 with
/// the effective area, the slenderness by it too (6.3.1.2); of paths with what the force bends
/// beside their centroid. A rod is taken as straight, hinged and of even mass: the force in it is
/// that at its ends, and its own centrifugal force adds up to m omega^2 L/8 between them; bending
/// by its own weight and inertia is not counted. No check for a direction in which a rod is never
/// loaded.
///
/// Gates that block: a section that cannot be judged where it is compressed, or that may turn over
/// then; joints and forces that load the rod between its ends or turn it, whose bending is not
/// counted.
/// Source: EN 1993-1-1:2005, 6.2.3, 6.2.4 and 6.3.1.
NeighbourChecks check_rods(const Project& project, const std::deque<SituationRun>& runs);

/// Pins, their lugs, and rods.
NeighbourChecks check_neighbours(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
