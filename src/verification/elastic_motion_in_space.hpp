#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "load_numbers.hpp"
#include "modal_transient.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {

struct ModesInMotion;

/// Elastic vibration of the verified beam in a large motion of its mechanism in space, the other
/// beams of the case, its rods and joints that give way elastic as well: bending about both axes,
/// torsion and stretching.
///
/// In every posture, under the beam's axial force there, the stopped mechanism has modes
/// (`StoppedVibration`), whose basis is turned so that it is nearest to the one at the beginning.
/// Relative to the rigid motion the beams follow
///
///     eta'' + (C + F') eta' + (K + F) eta = p(t),   p_j = work of the rigid cut forces
///     (`BeamMode`)
///
/// F', F of all bodies and beams, whose modes are fixed to their axes (`turning_terms_of`): in a
/// motion that repeats the periodic solution (`solve_modal_motion`), in one that does not the one
/// from its beginning, at rest or under way, with the free vibration behind its end
/// (`ModalTransient`, as `ElasticMotion`). To the loads of the rigid beam come those of the modes'
/// inertia
///
///     sum over modes of (eta + K^-1 C_m eta' - K^-1 p)_j times (tie forces and inertia of mode j)
///     + sum over dampers of c gap' times (`DampedTie`)
///     + what springs take over as the beams bend statically (`taken_over_of`)
///
/// or, where that is given, in place of the last what static bending of the second order does;
/// C_m of the beams' material; all are in balance. Between the instants they are trigonometric
/// polynomials in time, in a motion that does not repeat the modes' forces polynomials on pieces
/// (`ChebyshevCurve`), each number of them for itself, on the beam, where ties and pieces keep
/// their places: what is in balance at the instants is so between them. Modes whose frequencies are
/// alike come together. Left out: the change of the modes with the posture, of the order of
/// (omega_rotation/omega_1)^2 times the part of a mode's mass that is not the verified beam's; the
/// vibrating part of the axial force, and without the second order its static part on a beam that
/// bends statically; (s'/(L omega_1))^2 of a joint that slides along the beam with s'; the impulse
/// c d of a damper whose force is there at once at a contact that vibration shifts by d. Sources:
/// Shabana, Dynamics of Multibody Systems (2005), chapter 5; as `ElasticMotion`.
class ElasticMotionInSpace {
 public:
  /// `rigid`: loads on the rigid beam, before and behind a span that does not repeat those of the
  /// mechanism held there. `modes`: at least so many, where there are; `parts`: of the beam.
  /// `bent`: as `rigid`, with what static bending of the second order does
  /// (`bent_statically_in_space`), in place of what is taken over by the first.
  /// `project` and `chain` stay for the time of the call, the names of joints longer. Throws
  /// AnalysisError where teeth mesh with an elastic beam, the stopped
  /// mechanism is free to move or buckles, a harmonic of a motion that repeats meets a natural
  /// frequency of an undamped beam, modes change beyond recognition, a stop or a cable begins or
  /// ends to act in a motion that repeats, or vibration itself lets one act.
  ElasticMotionInSpace(const Project& project, const spatial::Chain& chain, const LoadSpan& span,
                       LoadsAt rigid, std::size_t modes, int parts, LoadsAt bent = {});

  /// Loads on the beam at any time; of a motion that does not repeat between its beginning and the
  /// end of `span_of`.
  BeamLoads loads_at(Time time) const;

  /// The time of the loads: of a motion that does not repeat with the free vibration behind it.
  /// Throws AnalysisError where it holds too many periods.
  LoadSpan span_of(const LoadSpan& rigid) const;

  /// Modal coordinates at the instants of a motion that repeats, a row for each [sqrt(kg) m].
  const Eigen::MatrixXd& coordinates() const { return eta_; }
  /// The same with their viscous part, less their static one.
  const Eigen::MatrixXd& dynamic_part() const { return dynamic_; }
  /// Modal coordinates over a motion that does not repeat; nothing of others.
  const TransientResponse* transient() const;
  double lowest_frequency() const { return lowest_; }  ///< over the motion [Hz]

 private:
  /// Modes of a posture, and the numbers of the loads of the turned ones, a row for each.
  struct Posture {
    ModalPosture modal;
    Eigen::MatrixXd loads;
    Eigen::MatrixXd by_rate;     ///< of dampers, per rate of the modes; of no rows without them
    Eigen::VectorXd taken_over;  ///< by springs; nothing without these
    Eigen::MatrixXd gaps;        ///< of springs that act from a length on, a row for each mode
  };
  using PostureAt = std::function<Posture(double time)>;
  /// `turn`: of the modes' basis there; `yields`: whether the material dampens.
  Posture posture_of(ModesInMotion at, Eigen::MatrixXd turn, bool yields);

  void solve_periodic(const PostureAt& posture_at, Eigen::Index instants);
  /// `passed`: but for postures and accuracy.
  void solve_once(const PostureAt& posture_at, const OpenMotion& motion, PassedOnce passed);
  Eigen::VectorXd allowed_of(const Eigen::VectorXd& largest, Eigen::Index modes) const;

  Eigen::VectorXd vibrating_at(double time) const;

  LoadsAt rigid_, bent_;  ///< the second or nothing
  double begin_, period_;
  LoadNumbers numbers_;
  Eigen::MatrixXd loads_;      ///< of the modes, a row for each instant of a motion that repeats
  bool damped_ = false;        ///< whether joints, springs or rods are
  bool takes_over_ = false;    ///< whether anything takes loads over from the beam
  Eigen::Index contacts_ = 0;  ///< springs that act from a length on
  Eigen::MatrixXd eta_, dynamic_;
  std::shared_ptr<const ModalTransient> once_;
  double lowest_ = 1e300;
};

/// Why modes of the beams do not hold in their motion: teeth, or clearance; "" where they do.
/// `beams`: the elastic ones, the verified one first.
std::string obstacle_to_modes(const spatial::Mechanism& mechanism,
                              const std::vector<spatial::BeamPlacement>& beams);

/// Loads on the beam of a case in space by a model of it: those of rigid bodies, bent under them,
/// or with vibration. `span`: of the rigid bodies' loads.
LoadHistory elastic_loads_in_space(const Project& project, const spatial::Chain& chain,
                                   const LoadSpan& span, const ElasticModel& model, LoadsAt rigid);

}  // namespace boxbeam
