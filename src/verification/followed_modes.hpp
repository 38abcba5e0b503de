#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "open_motion.hpp"
#include "stopped_vibration.hpp"

namespace boxbeam {

/// Modes of the beams of a mechanism in space, followed through its postures: as many in each, in
/// the basis nearest to that where they begin (`turn_between`).
class FollowedModes {
 public:
  using StateAt = std::function<spatial::State(double time)>;
  using CutsIn = std::function<CutForceDiagram(const spatial::State& state)>;

  /// `cuts_in`: cut forces of the verified beam as a rigid body. `modes`: at least so many beside
  /// those of frequency zero, where there are. `statically`: as of `modes_in_motion`. `stopped`
  /// stays.
  FollowedModes(StoppedVibration& stopped, StateAt state_at, CutsIn cuts_in, std::size_t modes,
                bool statically);

  /// Begins with those of the posture at a time, which are returned. Throws AnalysisError where
  /// there are none.
  ModesOfPosture begin_at(double time);
  /// Those of another posture. Throws AnalysisError where there are fewer.
  ModesInMotion at(double time);
  /// From the basis they began in to their own. Throws AnalysisError where they are not recognised.
  Eigen::MatrixXd turn_of(const Eigen::MatrixXd& shapes, double time) const;
  std::size_t count() const { return count_; }

  /// Borders between, at which the modes are to begin anew: those at which `acting_at` changes, and
  /// others, which are added to the motion, before modes are hard to recognise: they are looked at
  /// once in so many of its instants.
  std::vector<double> changes_over(OpenMotion& motion, double instants,
                                   const std::function<std::vector<bool>(double time)>& acting_at);

  /// Begins anew at a border; what turns coordinates of the modes before into those behind: their
  /// motion and their momentum go on.
  Eigen::MatrixXd turned_at(const OpenMotion& motion, double border);

 private:
  ModesOfPosture shapes_at(double time, std::size_t count);
  /// Those of another posture, without their motion through it.
  ModesOfPosture still_at(double time);
  void require_all(std::size_t found, double time) const;

  StoppedVibration* stopped_;
  StateAt state_at_;
  CutsIn cuts_in_;
  std::size_t modes_, count_ = 0;
  bool statically_;
  Eigen::MatrixXd reference_;
};

}  // namespace boxbeam
