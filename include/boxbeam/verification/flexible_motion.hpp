#pragma once

#include <memory>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// The vibration of elastic links: the mechanism as the model takes it, and its response.
struct FlexibleMotion {
  std::shared_ptr<const flexible::Mechanism> mechanism;
  std::shared_ptr<const flexible::Structure> structure;
  flexible::Response response;
  /// The motion whose inertia is in the response: its own, or as much as the model counts.
  flexible::LinkColumns<flexible::Complex> inertial;
};

/// Solves the model of a mechanism of elastic links. Quasi-static: without inertia. Modal: the
/// inertia of the modes' own motion, and the static response to it and to the loads (mode
/// acceleration, in balance to round-off). Throws AnalysisError where the structure is free to move
/// or, undamped, in resonance.
FlexibleMotion flexible_motion_of(const flexible::Mechanism& mechanism, const ElasticModel& model);

/// The vibration of a situation of elastic links.
const FlexibleMotion& flexible_motion_of(const SituationRun& run);

}  // namespace boxbeam
