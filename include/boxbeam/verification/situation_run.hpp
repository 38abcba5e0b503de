#pragma once

#include <deque>
#include <memory>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/shared_motions.hpp"

namespace boxbeam::planar {
struct Motion;
}
namespace boxbeam::spatial {
class Chain;
}

namespace boxbeam {

class SolvedMotion;

/// A situation that runs: its motion, and the loads on the beam over it. Stays where it is made,
/// for its loads look at its motion.
struct SituationRun {
  /// Solves the motion. Throws AnalysisError where a step cannot be done, loads on the beam are not
  /// determined or not in balance, or a joint slides off the beam.
  SituationRun(const Project& project, const Situation& situation, const ElasticModel& model,
               const SharedMotions& shared);
  SituationRun(const SituationRun&) = delete;
  SituationRun& operator=(const SituationRun&) = delete;
  ~SituationRun();

  const Situation* situation;
  std::unique_ptr<const SolvedMotion> motion;
  LoadHistory loads;
  double imbalance = 0.0;  ///< of force and moment on the beam, relative to the largest load
};

/// All situations of a case that run, in its order; changes between situations do not.
std::deque<SituationRun> run_situations(const Project& project, const ElasticModel& model = {},
                                        const SharedMotions& shared = {});

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

/// Where a use is largest.
struct WorstInstant {
  const SituationHistory* at;
  TurningPoint largest;  ///< without load factor
  double use = 0.0;      ///< with it
};

template <class Use>
WorstInstant worst_instant_of(const std::vector<SituationHistory>& histories, const Use& use) {
  WorstInstant worst{&histories.front(), {}, 0.0};
  for (const SituationHistory& at : histories) {
    const TurningPoint in = at.history.largest(use);
    const double with_factor = at.situation->load_factor * in.value;
    if (with_factor > worst.use) worst = {&at, in, with_factor};
  }
  return worst;
}

/// The motion of a mechanism of rigid bodies in the plane.
const planar::Motion& planar_motion_of(const SituationRun& run);
/// A mechanism in space, prepared for any time.
const spatial::Chain& chain_of(const SituationRun& run);

std::size_t index_of(const Project& project, const Situation& situation);

/// The run of a situation.
const SituationRun& run_of(const std::deque<SituationRun>& runs, const Situation& situation);

std::vector<SituationHistory> histories_at(const std::deque<SituationRun>& runs,
                                           const Station& station);

}  // namespace boxbeam
