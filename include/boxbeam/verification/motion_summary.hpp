#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/closure_summary.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/support_reaction.hpp"

namespace boxbeam {

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
