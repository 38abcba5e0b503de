#pragma once

#include <optional>

#include "boxbeam/mechanism/planar/motion.hpp"

namespace boxbeam::planar {

/// The mechanism held where it is in a state of its motion: drivers keep their values, nothing
/// moves, forces are those of that time. Throws AnalysisError where it cannot be held there (a dead
/// point). Precondition: drivers fix the motion.
State held_state(const Mechanism& mechanism, const State& known);

/// Whether no body moves in a state, by a millionth of the fastest in the motion.
bool is_at_rest(const Motion& motion, const State& state);

/// States at any time: of a motion, and before and behind an open one that drivers fix of the
/// mechanism held where it begins and ends.
class StatesAround {
 public:
  StatesAround(const Mechanism& mechanism, const Motion& motion)
      : mechanism_(&mechanism), motion_(&motion), finder_(mechanism, motion) {}

  /// Throws AnalysisError for a time outside a motion that forces decide.
  State at(double time);

 private:
  const Mechanism* mechanism_;
  const Motion* motion_;
  StateFinder finder_;
  std::optional<State> before_, behind_;
};

}  // namespace boxbeam::planar
