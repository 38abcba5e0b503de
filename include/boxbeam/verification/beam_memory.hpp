#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/figures.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/station_memory.hpp"

namespace boxbeam {

/// What is known of a beam from designs under the same loads. Not for several threads at once.
struct BeamMemory {
  /// Looks at the runs, which stay.
  explicit BeamMemory(std::deque<SituationRun>& of) : runs(&of), stations(of) {}

  std::deque<SituationRun>* runs;
  StationMemory stations;
  KeptPatches patches;
  std::optional<std::vector<CutForceLine>> envelope;  ///< of the cut forces, as it is drawn
};

}  // namespace boxbeam
