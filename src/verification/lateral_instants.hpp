#pragma once

#include <vector>

#include "beam_holds.hpp"
#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/verification/second_order_estimate.hpp"
#include "lateral_estimate.hpp"

namespace boxbeam {

/// The instant at which a beam is nearest to turning over, of all situations that are looked at.
class LateralInstants {
 public:
  explicit LateralInstants(const Project& project) : project_(&project), estimate_(project) {}

  /// An instant at which the beam is held so against turning, of loads that count `factor` times.
  void look_at(const SituationRun& run, Time time, const CutForceDiagram& diagram,
               const BeamLoads& loads, const HeldAt<std::vector<double>>& turning, double factor);
  /// All instants of a situation, unless a bound says that none matters.
  void look_at_all(const SituationRun& run, double factor);

  const LateralLoad& most() const { return most_; }

 private:
  const Project* project_;
  LateralEstimate estimate_;
  LateralLoad most_;
};

}  // namespace boxbeam
