#pragma once

#include <deque>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// The cut forces of a situation that runs, at instants and stations.
struct SampledSituation {
  std::size_t situation = 0;               ///< index in the case
  std::vector<double> times;               ///< [s], strictly ascending
  std::vector<std::vector<CutForces>> at;  ///< of each instant, by stations
};

/// How far straight lines between stations and instants are from the cut forces, measured halfway:
/// as a part of the largest force and of the largest moment of the beam.
struct SamplingError {
  double force = 0.0, moment = 0.0;
};

/// The cut forces of a beam at so many stations and instants that what lies between them is a
/// straight line in good approximation.
struct LoadSamples {
  /// In order, the ends of the beam within it; on both sides where a cut force jumps.
  std::vector<Station> stations;
  std::vector<SampledSituation> situations;
  SamplingError error;
  std::vector<Length> held;  ///< where what carries the beam takes hold of it, ascending
  /// A load slides along the beam: no stations can follow its jump. Then nothing is sampled.
  bool slides = false;
};

/// Samples the runs of a verification. Stations are all that it looked at, the places where loads
/// begin, end or act, and between them as many as keep the chord within 1e-5 of the largest force
/// and moment, or about 120; instants likewise, about 4000 at most, are those of the loads, those
/// in which a cut force or the stress of a check has its extreme, and the turning points of the
/// stresses that govern.
LoadSamples sample_loads(const Project& project, const std::deque<SituationRun>& runs,
                         const Verification& verification);

}  // namespace boxbeam
