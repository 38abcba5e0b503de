#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "modal_transient.hpp"

namespace boxbeam {

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
