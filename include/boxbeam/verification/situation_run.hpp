#pragma once

#include <deque>
#include <memory>
#include <variant>

#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/spatial/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/load_history.hpp"
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

/// A situation that runs: its motion, and the loads on the beam over it. Stays where it is made,
/// for its loads look at its motion.
struct SituationRun {
  /// Solves the motion. Throws AnalysisError where a step cannot be done, loads on the beam are not
  /// determined or not in balance, or a joint slides off the beam.
  SituationRun(const Project& project, const Situation& situation, const ElasticModel& model);
  SituationRun(const SituationRun&) = delete;
  SituationRun& operator=(const SituationRun&) = delete;

  const Situation* situation;
  std::variant<planar::Motion, spatial::Motion, FlexibleMotion> motion;
  LoadHistory loads;
  double imbalance = 0.0;  ///< of force and moment on the beam, relative to the largest load
};

/// All situations of a case that run, in its order; changes between situations do not.
std::deque<SituationRun> run_situations(const Project& project, const ElasticModel& model = {});

/// A highest or lowest value over time and situations.
struct Extreme {
  Time time;
  double value = 0.0;
  std::size_t situation = 0;  ///< its index in the case
};

/// The cut forces of one station in one situation.
struct SituationHistory {
  const Situation* situation;
  StationHistory history;
};

/// The motion of a mechanism of rigid bodies in the plane.
const planar::Motion& planar_motion_of(const SituationRun& run);

/// The vibration of elastic links.
const FlexibleMotion& flexible_motion_of(const SituationRun& run);

std::size_t index_of(const Project& project, const Situation& situation);

/// The run of a situation.
const SituationRun& run_of(const std::deque<SituationRun>& runs, const Situation& situation);

std::vector<SituationHistory> histories_at(const std::deque<SituationRun>& runs,
                                           const Station& station);

}  // namespace boxbeam
