#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "boxbeam/numerics/chebyshev_curve.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "modal_motion.hpp"
#include "open_motion.hpp"

namespace boxbeam {

/// Modes of a posture, in the plane or in space, with further numbers that are asked of it at any
/// time of a motion.
struct PassedPosture {
  ModalPosture posture;
  Eigen::VectorXd beside;
};

/// Modes of the mechanism held at its end.
struct RestingModes {
  ModalPosture posture;
  Eigen::VectorXd frequencies;  ///< ascending [Hz]
  Eigen::VectorXd stresses;     ///< the largest that a unit of each makes
};

/// What a motion that does not repeat is to the modes of its postures.
struct PassedOnce {
  std::function<PassedPosture(double time)> posture_at;
  /// Of C, K column by column, p and what is beside, as one column.
  ChebyshevCurve::Accuracy accuracy;
  std::function<RestingModes()> resting;
  /// Of its pieces to begin with.
  double instants_to_a_piece = 8.0;
  /// Whether postures change behind an end at rest, no faster than the modes.
  bool vibrates_behind = false;
  /// Of the borders those at which modes change at once, for others act from there on, ascending.
  std::vector<double> changes = {};
  /// At one of them: what turns coordinates into those behind, of which the postures then are.
  std::function<Eigen::MatrixXd(double time)> turned_at = {};
};

/// Coordinates of modes over a motion that does not repeat, from its beginning:
///
///     eta'' + (C + F') eta' + (K + F) eta = p(t)
///
/// (`TransientResponse`), at rest or under way without a free vibration (`state_at_begin`); C, K, p
/// and what is asked beside them by polynomials between borders (`ChebyshevCurve`), from pieces of
/// so many instants on (`PassedOnce`). Where modes change at once, motion and momentum go on. Where
/// the motion ends at rest the free vibration is followed until it is down to a twentieth of the
/// largest stress that coordinates made, for three periods of the lowest mode at least where it
/// does not die out, for one and a half in any case.
class ModalTransient {
 public:
  /// Asks at construction only.
  ModalTransient(OpenMotion motion, const PassedOnce& passed);

  const TransientResponse& response() const { return *response_; }
  /// What is asked beside the equations, between the beginning and the last time.
  Eigen::VectorXd beside_at(double time) const;

  /// The time of the loads, with the free vibration behind the motion, in at least eight instants
  /// to a period of the fastest mode and, as far as their number allows, as many to a second as the
  /// motion has. Throws AnalysisError where it holds too many periods. `rigid`: of rigid bodies.
  LoadSpan span_of(const LoadSpan& rigid) const;

  double lowest_frequency() const { return lowest_; }  ///< over the motion [Hz]

 private:
  void respond(const PassedOnce& passed, const std::vector<double>& borders, double longest_piece);
  double length_watched(const RestingModes& rest) const;

  OpenMotion motion_;
  /// A time in which the same modes are passed.
  struct Passage {
    double until = 0.0;
    ChebyshevCurve curve;
    Eigen::Index modes = 0;
  };
  std::vector<Passage> passages_;  ///< of the motion, and behind it
  std::optional<TransientResponse> response_;
  std::size_t turned_ = 0;  ///< state from which on coordinates are those of the end
  double lowest_ = 1e300, fastest_ = 0.0;
};

/// The most instants in which a beam is looked at that vibrates in a motion that does not repeat.
inline constexpr double most_vibrating_instants = 8192.0;

/// Instants to a period of the fastest mode that is counted.
inline constexpr double instants_to_a_period = 8.0;

}  // namespace boxbeam
