#pragma once

#include <optional>

#include "boxbeam/mechanism/spatial/motion.hpp"

namespace boxbeam::spatial {

/// The mechanism held where it is at a time: drivers keep their values, nothing moves, forces and
/// springs are those of that time, and nothing rubs. Precondition: forces move nothing.
State held_state(const Chain& chain, double time);

/// Whether no body moves where a motion begins and where it ends, by a millionth of the fastest in
/// it.
struct EndsAtRest {
  bool begin = false, end = false;
};
EndsAtRest ends_at_rest_of(const Chain& chain, const Motion& motion);

/// States at any time: of a motion, and before and behind an open one that drivers fix of the
/// mechanism held where it begins and ends. Keeps a reference to the chain.
class StatesAround {
 public:
  StatesAround(const Chain& chain, const Motion& motion);

  /// Throws AnalysisError as `Chain::at`.
  State at(double time) const;

 private:
  const Chain* chain_;
  double begin_, end_;
  std::optional<State> before_, behind_;
};

}  // namespace boxbeam::spatial
