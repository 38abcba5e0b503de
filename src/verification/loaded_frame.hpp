#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "frame_time.hpp"

namespace boxbeam {

/// A frame under what stands on it, solved once, and under wheels that move, at every instant.
class LoadedFrame {
 public:
  explicit LoadedFrame(const frame::Structure& of);

  BeamLoads loads_at(int beam, double time) const;
  /// Shift and turn of a beam's start, in its axes.
  frame::Vector6 start_at(int beam, double time) const;
  /// By which heat bends a beam about its y [1/m].
  double heat_curvature(int beam) const;
  /// What a support or joint does to what it holds, world axes.
  std::vector<frame::Vector6> reactions_at(double time) const;
  /// Nothing where all loads stand still.
  std::optional<TimeSpan> time() const { return changes_ ? std::optional(time_) : std::nullopt; }

  /// Members in parts, and the axial forces in these of the instants that may buckle the frame.
  struct Pressed {
    explicit Pressed(const frame::Structure& of) : finer(of, 8) {}

    /// The least over instants, at most `most`.
    double critical_factor(double most) const;

    frame::Statics finer;
    std::vector<std::vector<double>> forces;
  };
  std::unique_ptr<const Pressed> pressed_by(const LoadHistory& loads) const;

  const frame::Structure& structure;

 private:
  /// Of what does not repeat beyond its ends what acts there.
  frame::ActingLoads acting_moved(double time) const;

  frame::Statics statics_;
  frame::Structure lasting_, moving_;
  frame::Equilibrium standing_;
  bool changes_ = false;
  TimeSpan time_;
};

}  // namespace boxbeam
