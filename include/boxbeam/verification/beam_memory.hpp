#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/equivalent_mass.hpp"
#include "boxbeam/verification/figures.hpp"
#include "boxbeam/verification/motion_summary.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/station_memory.hpp"

namespace boxbeam {

/// What the loads of a beam alone tell, whatever resists them.
struct KnownOfLoads {
  std::vector<CutForceLine> envelope;  ///< of the cut forces, as it is drawn
  std::vector<MotionSummary> motions;
  std::optional<planar::EquivalentMass> equivalent_mass;
  std::vector<NotJudged> unestimated_vibration;
};

/// What is known of a beam from designs under the same loads. Not for several threads at once.
struct BeamMemory {
  /// Looks at the runs, which stay.
  explicit BeamMemory(std::deque<SituationRun>& of) : runs(&of), stations(of) {}

  /// From now on it is that of this design, as `StationMemory::turn_to`.
  void turn_to(const Project& project, StationMemory::Change by) {
    stations.turn_to(project, by);
    change = by;
  }

  std::deque<SituationRun>* runs;
  StationMemory stations;
  StationMemory::Change change = StationMemory::Change::any;
  KeptPatches patches;
  std::optional<KnownOfLoads> of_loads;
};

}  // namespace boxbeam
