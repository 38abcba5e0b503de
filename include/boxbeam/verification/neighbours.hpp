#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/strength/compressed_section.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// A pin or rod of the mechanism, and what decides its check.
struct NeighbourResult {
  Check check;
  PinUtilisation pin;  ///< of a pin, under the acting force
  // Of a rod under tension:
  Force plastic;  ///< N_pl,Rd
  Force net;      ///< N_u,Rd
  // Of a rod under compression:
  CompressedSection section;
  double slenderness = 0.0;  ///< relative
  double reduction = 1.0;    ///< chi
  bool weak_axis = false;    ///< it buckles about its z axis
};

/// The pins a case names, under the largest force of their joint in any situation, times its load
/// factor. The factor is one on the force. Valid for rigid bodies, see `model_gates_of`. Nothing
/// for a pin without force. Source: EN 1993-1-8:2005, 3.13.2.
std::vector<NeighbourResult> check_pins(const Project& project,
                                        const std::deque<SituationRun>& runs);

/// Resistance of a rod to tension, the smaller of the whole section's and the net section's. A rod
/// without holes for fasteners has its whole area as net area.
///
///     N_pl,Rd = A f_y/gamma_M0,  N_u,Rd = 0.9 A_net f_u/gamma_M2
///
/// Source: EN 1993-1-1:2005, 6.2.3(2), equations 6.6 and 6.7.
Force plastic_resistance(const RodInput& rod);
Force net_resistance(const RodInput& rod);

/// Checks of rods, and what stands against them.
struct RodChecks {
  std::vector<NeighbourResult> results;
  std::vector<Gate> gates;
  std::vector<std::string> unloaded;  ///< names of rods that bear no force at any time
};

/// The rods a case names, under their largest tension and their largest compression in any
/// situation, times its load factor: yield and net section; flexural buckling about the weaker
/// axis, in class 4 with the effective area, the slenderness by it too (6.3.1.2). A rod is taken
/// as straight, hinged and of even mass: the force in it is that at its ends, and its own
/// centrifugal force adds up to m omega^2 L/8 between them; bending by its own weight and inertia
/// is not counted. No check for a direction in which a rod is never loaded.
///
/// Gates that block: a section that cannot be judged where it is compressed; joints and forces that
/// load the rod between its ends or turn it, whose bending is not counted.
/// Source: EN 1993-1-1:2005, 6.2.3 and 6.3.1.
RodChecks check_rods(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
