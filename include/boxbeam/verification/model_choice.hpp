#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/second_order_estimate.hpp"
#include "boxbeam/verification/shared_motions.hpp"

namespace boxbeam {

/// How much of the elasticity counts.
enum class ModelLevel {
  rigid,         ///< rigid bodies: inertia of the rigid motion
  quasi_static,  ///< elastic statics under these loads, instant by instant
  modal,         ///< the lowest modes, with static correction
  flexible,      ///< all rigid finite elements
};

/// "rigid", "quasi-static", "modal", "flexible".
const char* to_text(ModelLevel level);

/// A model of the mechanism.
struct ElasticModel {
  ModelLevel level = ModelLevel::rigid;
  int modes = 0;  ///< of `modal`
  int parts = 0;  ///< least number of every elastic link; zero: as the case says
  std::optional<flexible::Element> element;  ///< nothing: as the case says
  /// Bending links are taken with their elasticity along the axis as well.
  bool axial = false;
  /// Of `modal` in space: what bends statically does so by the second order.
  bool bends_twice = false;
};

/// A model that was weighed.
struct ModelEstimate {
  ElasticModel model;
  std::string basis;   ///< what the estimate rests on, in words with its numbers
  double error = 0.0;  ///< estimated, of the governing stress, relative
  /// The same after the solve: against the next better model or, of a beam that bends, by what its
  /// loads leave unbalanced on the bent beam, the larger.
  std::optional<double> found;
};

/// A harmonic of the loads that drive the beam.
struct LoadHarmonic {
  double frequency = 0.0;  ///< [Hz]
  double share = 0.0;      ///< of the largest bending moment
};

/// The model that is used, and why.
struct ModelChoice {
  ElasticModel chosen;
  double tolerance = 0.0;
  std::string reason;                   ///< one sentence with its numbers
  std::vector<ModelEstimate> weighed;   ///< in the order in which they were
  std::vector<double> frequencies;      ///< of the mechanism with all its masses, lowest first [Hz]
  std::vector<LoadHarmonic> harmonics;  ///< the significant ones
  SecondOrderEstimate second_order;
  /// Whether the chosen model has what the beam's axial force does to the bent beam.
  bool counts_second_order = false;
  /// Whether it is the beam of rigid bodies that bends, about the motion that these have.
  bool bends_rigid_motion = false;
};

/// Whether what the beam's axial force does to the bent beam is in the cut forces, or known to be
/// within the tolerance.
bool knows_second_order(const ModelChoice& model);

/// The cheapest model whose error of the governing stress is within the tolerance that the case
/// asks for, or the one that it demands.
ModelChoice choose_model(const Project& project);

struct SituationRun;

/// All situations of a case that run, by the model that is chosen.
struct ModelledRuns {
  ModelChoice model;
  std::deque<SituationRun> runs;
};
ModelledRuns run_by_chosen_model(const Project& project, const SharedMotions& shared = {});

}  // namespace boxbeam
