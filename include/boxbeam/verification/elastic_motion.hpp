#pragma once

#include <Eigen/Core>
#include <memory>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/posture_modes.hpp"

namespace boxbeam {

/// The elastic body that the verified beam of a planar case is, with those of its other beams.
/// `project` stays.
ElasticBody elastic_body_of(const Project& project, int parts);

/// A planar mechanism whose drivers fix its motion, and the loads on its beam as a rigid body.
struct RigidMotion {
  const planar::Mechanism* mechanism = nullptr;
  const planar::Motion* motion = nullptr;
  const TaperedBeam* beam = nullptr;
  LoadsAt loads;
};

/// Loads on the beam at any time by theory of the second order: those of the rigid beam and what
/// static bending under them adds, posture by posture (`second_order_of`).
/// `axial`: loads whose axial force the beam bears; nothing: those of the rigid beam.
LoadsAt bent_statically(const RigidMotion& rigid, const ElasticBody& elastic, LoadsAt axial = {});

/// Elastic vibration of the beam in a large periodic motion of its mechanism, by theory of the
/// second order.
///
/// In every posture, under the forces of the rigid motion there, the mechanism has modes; their
/// basis is turned so that it is nearest to the one at the beginning (orthogonal Procrustes
/// problem), which makes it continuous where frequencies cross. Relative to the rigid motion the
/// beam follows
///
///     eta'' + (C + F') eta' + (K + F) eta = p(t),   K = phi^T (K + K_g) phi,   p_j = `modal_loads`
///
/// periodic, solved at N instants by Fourier collocation; F', F of the turning bodies
/// (`frame_terms`). To the loads of the beam that bends statically (`second_order_of`) come those
/// of the modes' own inertia, -K^-1 (eta'' + F' eta' + F eta): what elasticity and viscosity bear
/// together beyond the static part,
///
///     sum over modes of (eta + K^-1 C eta' - K^-1 p)_j times (joint forces and inertia of mode j)
///
/// which are in balance. Left out: the change of the modes with the posture, of the order of
/// (omega_rotation/omega_1)^2 times the part of a mode's mass that is not the beam's; joints that
/// are elastic themselves.
/// Sources: Shabana, Dynamics of Multibody Systems (2005), chapter 5; Trefethen, Spectral Methods
/// in MATLAB (2000), chapter 3; Schönemann, Psychometrika 31 (1966).
class ElasticMotion {
 public:
  /// Throws AnalysisError where the motion is not periodic, a harmonic of it meets a natural
  /// frequency of an undamped beam, or modes change beyond recognition over it.
  /// `axial`: loads whose axial force the beam bears; nothing: those of the rigid beam. The axial
  /// force vibrates as well: loads of a first motion here make it known to the second order.
  ElasticMotion(RigidMotion rigid, ElasticBody elastic, std::size_t modes, LoadsAt axial = {});

  /// Loads on the beam at any time.
  BeamLoads loads_at(Time time) const;

  /// Modal coordinates with their viscous part, less their static one, at the instants, a row for
  /// each [sqrt(kg) m].
  const Eigen::MatrixXd& dynamic_part() const { return dynamic_; }
  /// Modal coordinates at the instants [sqrt(kg) m].
  const Eigen::MatrixXd& coordinates() const { return eta_; }
  double lowest_frequency() const { return lowest_; }  ///< over the motion [Hz]

 private:
  /// Modes of a posture, turned to the basis at the beginning.
  struct Aligned {
    PostureModes modes;
    Eigen::MatrixXd turn;
  };
  LoadedPosture posture_at(const planar::State& state, const BeamLoads& rigid) const;
  Aligned aligned_at(const LoadedPosture& posture, double time) const;
  Eigen::VectorXd dynamic_at(double time) const;

  RigidMotion rigid_;
  std::shared_ptr<planar::StateFinder> finder_;
  ElasticBody elastic_;
  std::size_t count_;
  LoadsAt axial_;
  Eigen::MatrixXd reference_;  ///< shapes at the beginning
  Eigen::MatrixXd eta_, dynamic_;
  double lowest_ = 0.0;
};

/// Loads on the beam of a planar case by a model of it: those of rigid bodies, or with vibration.
LoadsAt elastic_loads_of(const Project& project, const planar::Mechanism& mechanism,
                         const planar::Motion& motion, const ElasticModel& model, LoadsAt rigid);

}  // namespace boxbeam
