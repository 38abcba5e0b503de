#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "modal_transient.hpp"

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

/// `estimate_vibration` of a frame under one situation.
struct FrameVibration {
  VibrationEstimate estimate;
  std::string obstacle;  ///< why there is none; "" where there is
  std::string shape;     ///< of the first mode
};

/// Whether a frame has loads that change over time in any situation.
bool has_loads_over_time(const Project& project);

/// By the modes of several instants' axial forces, each taken for the whole time: of what repeats
/// every harmonic, else the response from the balance in which it begins.
FrameVibration estimate_vibration_of_frame(const Project& project, const SituationRun& run,
                                           int parts = 8);

/// Loads on the verified beam with those of the frame's modes, of the instant whose first frequency
/// is lowest:
///
///     loads of statics + sum over modes of (eta + K^-1 C eta' - K^-1 p)_j (ties and inertia of
///     mode j),   eta'' + C eta' + K eta = p(t)
///
/// periodic where the loads repeat, else from the balance in which they begin, with the free
/// vibration behind them where they end at rest. Sources: as `ElasticMotionInSpace`.
class FrameResponse {
 public:
  /// `slowly`: loads on the beam by statics.
  FrameResponse(const Project& project, const frame::Structure& structure, const LoadSpan& span,
                LoadsAt slowly, std::size_t modes, int parts);

  BeamLoads loads_at(Time time) const;
  /// Shift and turn of the beam's start in its axes beside those of statics, with which the beam
  /// bends under these loads between its supports.
  frame::Vector6 start_at(Time time) const;
  LoadSpan span_of(const LoadSpan& slowly) const;

  double lowest_frequency() const { return modes_.front().frequency; }  ///< [Hz]

 private:
  Eigen::VectorXd dynamic_at(double time) const;

  LoadsAt slowly_;
  double begin_, period_;
  std::vector<frame::BeamMode> modes_;
  Eigen::MatrixXd dynamic_;  ///< of what repeats, a row for each instant
  std::shared_ptr<const ModalTransient> once_;
};

}  // namespace boxbeam
