#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {

/// Elastic vibration of the verified beam in a large periodic motion of its mechanism in space, the
/// other beams of the case elastic as well: bending about both axes, torsion and stretching.
///
/// In every posture, under the beam's axial force there, the stopped mechanism has modes
/// (`StoppedVibration`), whose basis is turned so that it is nearest to the one at the beginning.
/// Relative to the rigid motion the beams follow
///
///     eta'' + (C + F') eta' + (K + F) eta = p(t),   p_j = work of the rigid cut forces
///     (`BeamMode`)
///
/// periodic (`solve_modal_motion`); F', F of all bodies and beams, whose modes are fixed to their
/// axes (`turning_terms_of`). To the loads of the rigid beam come those of the modes' inertia
///
///     sum over modes of (eta + K^-1 C eta' - K^-1 p)_j times (tie forces and inertia of mode j)
///
/// which are in balance. Between the instants they are trigonometric polynomials in time, each
/// number of them for itself, on the beam, where ties and pieces keep their places: what is in
/// balance at the instants is so between them. Modes whose frequencies are alike come together.
/// Left out: the change of the modes with the posture, of the order of (omega_rotation/omega_1)^2
/// times the part of a mode's mass that is not the verified beam's; what springs beside beams take
/// over when these bend statically; what the axial force does to a beam that bends statically, and
/// its vibrating part.
/// Sources: Shabana, Dynamics of Multibody Systems (2005), chapter 5; as `ElasticMotion`.
class ElasticMotionInSpace {
 public:
  /// `rigid`: loads on the rigid beam over a closed span. `modes`: at least so many, where there
  /// are; `parts`: of the beam. `project` and `chain` stay for the time of the call, the names of
  /// joints longer. Throws AnalysisError where the motion does not repeat, a joint slides along an
  /// elastic beam or teeth mesh with it, the stopped mechanism is free to move or buckles, a
  /// harmonic meets a natural frequency of an undamped beam, or modes change beyond recognition.
  ElasticMotionInSpace(const Project& project, const spatial::Chain& chain, const LoadSpan& span,
                       LoadsAt rigid, std::size_t modes, int parts);

  /// Loads on the beam at any time.
  BeamLoads loads_at(Time time) const;

  /// Modal coordinates at the instants, a row for each [sqrt(kg) m].
  const Eigen::MatrixXd& coordinates() const { return eta_; }
  /// The same with their viscous part, less their static one.
  const Eigen::MatrixXd& dynamic_part() const { return dynamic_; }
  double lowest_frequency() const { return lowest_; }  ///< over the motion [Hz]

 private:
  /// The numbers of loads on the beam: coefficients of the line loads of every piece, then force
  /// and moment of every point; new points become places.
  Eigen::RowVectorXd numbers_of(const BeamLoads& loads);
  BeamLoads loads_of(const Eigen::VectorXd& numbers) const;

  LoadsAt rigid_;
  double begin_, period_;
  BeamLoads places_;       ///< points and pieces where modes load the beam, without loads
  Eigen::MatrixXd loads_;  ///< of the modes, a row for each instant
  Eigen::MatrixXd eta_, dynamic_;
  double lowest_ = 0.0;
};

/// Why modes of the beams do not hold in their motion: a joint that slides along one, or teeth; ""
/// where they do. `beams`: the elastic ones, the verified one first.
std::string obstacle_to_modes(const spatial::Mechanism& mechanism,
                              const std::vector<spatial::BeamPlacement>& beams);

/// Loads on the beam of a case in space by a model of it: those of rigid bodies, or with vibration.
LoadsAt elastic_loads_in_space(const Project& project, const spatial::Chain& chain,
                               const LoadSpan& span, const ElasticModel& model, LoadsAt rigid);

}  // namespace boxbeam
