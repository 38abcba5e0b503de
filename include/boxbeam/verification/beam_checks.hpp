#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/cut_force_envelope.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/verified_stations.hpp"

namespace boxbeam {

/// By which route of EN 1993-1-5 the slender plates of a segment were judged, and why.
struct SegmentRoute {
  std::string segment;
  PlateRoute route = PlateRoute::effective_widths;
  std::string reason;  ///< of a steep one; "" where the case says so
};

/// What was found along the beam.
struct BeamChecks {
  /// In order, at both ends also outside, where nothing is cut: the jump to zero there is part of
  /// the diagram.
  std::vector<StationEnvelope> stations;
  std::vector<CheckResult> checks;
  /// The worst of each criterion of the route that does not judge, at the same stations.
  std::vector<CheckResult> beside;
  std::vector<SegmentRoute> routes;  ///< of segments with slender plates that are judged
  std::vector<Gate> gates;
};

/// Everything that is looked at in the beam: the cut forces at the stations, every criterion at
/// every point of them, its plates, the welds of the case. Of stresses that were given only these.
/// Of long records the fatigue of every place that is estimated near the worst of its criterion is
/// counted over all instants. What other designs under the same loads have found of a station is
/// taken from `memory`. Throws AnalysisError where no point is ever stressed, or a stress is not
/// known.
BeamChecks check_beam(const Project& project, const std::deque<SituationRun>& runs,
                      const std::vector<BendingZone>& zones, const VerifiedStations& verified,
                      const ModelChoice& model, StationMemory* memory = nullptr);

}  // namespace boxbeam
