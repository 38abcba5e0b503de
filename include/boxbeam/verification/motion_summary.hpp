#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/units.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// What is left of the arithmetic at the instant nearest to a dead point.
struct DigitsLeft {
  double left = 0.0;  ///< decimal digits of velocities
  Time time;
};

/// What there is to know of a mechanism whose joints are equations to be solved.
struct ClosureSummary {
  planar::DegreesOfFreedom freedom;
  std::vector<int> branch;            ///< sign per loop
  DigitsLeft digits;                  ///< meaningless where forces decide the motion
  std::vector<double> change_points;  ///< times at which two branches cross [s]
  double largest_residual = 0.0;      ///< of the constraints, over all instants [m, rad]
};

/// The least and the largest that a support does to what it holds, over the time that is looked at:
/// force and couple, world axes [N, N m].
struct SupportReaction {
  std::string name;
  std::array<double, 6> low{}, high{};
};

/// What is to be known of the motion in a situation.
struct MotionSummary {
  std::size_t situation = 0;  ///< index in the case
  std::size_t instants = 0;
  Time begin;
  Time period;
  bool closed = true;         ///< the motion repeats by itself after its period
  bool recorded = false;      ///< the loads are given at these instants and linear between them
  bool stands_still = false;  ///< nothing moves, and the loads are always the same
  double imbalance = 0.0;     ///< of force and moment on the beam, relative to the largest load
  /// Nothing for a chain, whose motion is explicit, and for elastic links.
  std::optional<ClosureSummary> closure;
  std::vector<SupportReaction> reactions;  ///< of frames at rest
};

/// One for every situation that runs, in their order.
std::vector<MotionSummary> motion_summaries_of(const Project& project,
                                               const std::deque<SituationRun>& runs);

}  // namespace boxbeam
