#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// Vibration of a frame at rest, or of a beam on supports, under forces that follow functions of
/// time and wheels that run along its members: all members elastic, joints and supports as stiff as
/// they are, the axial forces of an instant in the stiffness. Wheels push, their mass does not move
/// with the frame. Out of a plane frame's plane nothing moves.
class VibratingFrame {
 public:
  /// `parts`: about so many pieces of each member. `project` and `structure` stay. Throws
  /// AnalysisError where the frame cannot be solved.
  VibratingFrame(const Project& project, const frame::Structure& structure, int parts);

  /// Under the axial forces of what acts at a time, the verified beam being the first. Throws
  /// AnalysisError where the frame buckles.
  std::vector<frame::BeamMode> modes(double time, std::size_t count) const;

  /// What acts over time does on the modes, force times motion, at a time within these [s].
  Eigen::VectorXd forces(const std::vector<frame::BeamMode>& modes, double time, double begin,
                         double end) const;

 private:
  /// What moves a place of a beam: the motions of two nodes of the scene, which stand in a mode's
  /// motion from `row` on.
  struct Moved {
    Eigen::Index row = 0;
    Eigen::Matrix<double, 6, 12> by;
  };
  Moved moved_at(std::size_t beam, double s) const;

  const frame::Structure* structure_;
  frame::Structure moving_;  ///< what changes over time alone
  frame::Statics statics_;
  std::vector<std::size_t> order_;          ///< members, the verified one first
  std::vector<std::size_t> place_;          ///< of each member in that order
  std::deque<frame::VibratingBeam> beams_;  ///< in that order
};

}  // namespace boxbeam
