#pragma once

#include <Eigen/Core>
#include <memory>

#include "boxbeam/mechanism/planar/rest.hpp"
#include "boxbeam/verification/elastic_beside.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/posture_modes.hpp"
#include "boxbeam/verification/transient_response.hpp"

namespace boxbeam {

class ModalTransient;
class RepeatedVibration;
struct ModalPosture;

/// A planar mechanism in its motion, and the loads on its beam as a rigid body. Before and behind a
/// motion that does not repeat and that drivers fix the loads are those of the mechanism held at
/// rest there (`StatesAround`).
struct RigidMotion {
  const planar::Mechanism* mechanism = nullptr;
  const planar::Motion* motion = nullptr;
  const TaperedBeam* beam = nullptr;
  LoadsAt loads;
};

/// Loads on the beam at any time by theory of the second order: those of the rigid beam and what
/// static bending under them adds, posture by posture (`second_order_of`).
/// `axial`: loads whose axial force the beam bears; nothing: those of the rigid beam. Precondition:
/// drivers fix the motion.
LoadsAt bent_statically(const RigidMotion& rigid, const ElasticBody& elastic, LoadsAt axial = {});

/// Elastic vibration of the beam in a large motion of its mechanism, by theory of the second order.
///
/// In every posture, under the forces of the rigid motion there, the mechanism has modes; their
/// basis is turned so that it is nearest to the one at the beginning (orthogonal Procrustes
/// problem), which makes it continuous where frequencies cross. Relative to the rigid motion the
/// beam follows
///
///     eta'' + (C + F') eta' + (K + F) eta = p(t),   K = phi^T (K + K_g) phi,   p_j = `modal_loads`
///
/// F', F of the turning bodies (`frame_terms`): in a motion that repeats the periodic solution at N
/// instants by Fourier collocation, in one that does not the solution from its beginning
/// (`ModalTransient`), K, C, F', F and p by polynomials within 1e-4.
///
/// Such a motion begins with the beam at rest in static balance under what acts on the mechanism
/// held where it begins: where accelerations are there at once, what they load the beam with is a
/// sudden load. Where bodies move already they have done so before, and the beam follows its static
/// balance without a free vibration; a blow or what vibrated before is not in it. Where the motion
/// ends at rest the free vibration is followed until it is down to a twentieth of the largest
/// coordinate, for three periods of the lowest mode at least where it does not die out.
///
/// To the loads of the beam that bends statically (`second_order_of`) come those
/// of the modes' own inertia, -K^-1 (eta'' + F' eta' + F eta): what elasticity and viscosity bear
/// together beyond the static part, and every damper c acts where it is (`JointDamper`),
///
///     sum over modes of (eta + K^-1 C_m eta' - K^-1 p)_j times (joint forces and inertia of mode
///     j)
///     + sum over dampers of c gap' times (loads for a unit of its force)
///
/// which are in balance, C_m of the strained material. Left out: the change of the modes with the
/// posture, of the order of (omega_rotation/omega_1)^2 times the part of a mode's mass that is not
/// the beam's.
///
/// Where forces move the mechanism the modes are those of it free to move, its springs and dampers
/// as they act then, and K that without axial forces. So many modes as forces move ways may move
/// whole bodies, without force or on springs: they come besides those that are asked for. p is none
/// of what is free, for loads are in balance with inertia. phi^T K_g phi stands beside F, of modes
/// that are faster than twice the turning: what is slower moves whole bodies, whose turning the
/// rigid motion has. Statically bent, by the first order, are what springs and joints take over
/// (`taken_over_in`). The beginning is under way, also at rest, and nothing is looked at behind the
/// end.
///
/// Where a cable, a stop or a spring that acts one way begins or ends to act in a motion that does
/// not repeat, modes change at once, and the coordinates go over into those of the new ones by
/// phi_new^T M phi_old. It does when the rigid motion says so: left out is how much earlier or
/// later vibration makes it, of the order of (d/p)^2 of the impulse, d how far its ends are
/// elsewhere by elasticity and p how far they are pressed, and c d of it where the force c v of a
/// damper is there at once; and the loss of an impact's law.
/// Sources: Shabana, Dynamics of Multibody Systems (2005), chapter 5; Trefethen, Spectral Methods
/// in MATLAB (2000), chapter 3; Schönemann, Psychometrika 31 (1966).
class ElasticMotion {
 public:
  /// Throws AnalysisError where a harmonic of a motion that repeats meets a natural frequency of an
  /// undamped beam, a spring begins or ends to act in one, the beam buckles, or modes change beyond
  /// recognition over the motion.
  /// `axial`: loads whose axial force the beam bears; nothing: those of the rigid beam. The axial
  /// force vibrates as well: loads of a first motion here make it known to the second order.
  ElasticMotion(RigidMotion rigid, ElasticBody elastic, std::size_t modes, LoadsAt axial = {});

  /// Loads on the beam at any time.
  BeamLoads loads_at(Time time) const;

  /// The time of the loads: of a motion that does not repeat with the free vibration behind it
  /// (`ModalTransient`). Throws AnalysisError where it holds too many periods.
  LoadSpan span_of(const LoadSpan& rigid) const;

  /// Modal coordinates at the instants of a motion that repeats, a row for each [sqrt(kg) m].
  const Eigen::MatrixXd& coordinates() const;
  /// The same over a motion that does not repeat; nothing of others.
  const TransientResponse* transient() const;
  double lowest_frequency() const { return lowest_; }  ///< over the motion [Hz]

 private:
  /// Modes of a posture, turned to the basis at the beginning, and dampers by them.
  struct Aligned {
    PostureModes modes;
    Eigen::MatrixXd turn;
    std::vector<JointDamper> dampers;
  };
  /// What makes the loads of an instant: those of the bent beam, and modes.
  struct Moment {
    BeamLoads bent;
    Aligned aligned;
    Eigen::VectorXd statically;  ///< K^-1 p in the basis of the posture
  };
  /// In how many ways forces move the mechanism.
  std::size_t freedoms() const;
  /// What presses it counts so many times, where forces move it none or once.
  LoadedPosture posture_at(const planar::State& state, const BeamLoads& rigid, double time,
                           double pressed) const;
  LoadedPosture posture_at(const planar::State& state, const BeamLoads& rigid, double time) const;
  PostureModes modes_of(const LoadedPosture& posture) const;
  void begin_passage(double from, double beside, const PostureModes& modes);
  Aligned aligned_at(const LoadedPosture& posture, double time) const;
  void press_free(const planar::State& state, const BeamLoads& rigid, const LoadedPosture& straight,
                  const PostureModes& modes, FrameTerms& frame) const;
  ModalPosture passed_in(const planar::State& state, const BeamLoads& rigid,
                         const LoadedPosture& loaded, const Aligned& aligned) const;
  ModalPosture passed_at(double time) const;
  Eigen::MatrixXd turned_at(double change, const std::vector<double>& borders);
  double beside_changes(double time) const;
  Moment moment_at(double time) const;
  void solve_periodic();
  void solve_once();

  RigidMotion rigid_;
  std::shared_ptr<planar::StatesAround> states_;
  ElasticBody elastic_;
  std::size_t count_;
  LoadsAt axial_;
  /// A time over which the same springs act.
  struct Passage {
    double from = 0.0, beside = 0.0;  ///< and how near to it nothing has changed yet [s]
    Eigen::MatrixXd shapes;           ///< where it begins
    Eigen::Index free = 0;            ///< so many of them, the first, move without force
  };
  std::vector<Passage> passages_;
  std::shared_ptr<const RepeatedVibration> repeated_;  ///< of a motion that does
  std::shared_ptr<const ModalTransient> transient_;    ///< of another one
  double lowest_ = 1e300;
  mutable std::shared_ptr<const Moment> at_end_;  ///< at rest behind the end
};

/// Loads on the beam of a planar case by a model of it: those of rigid bodies, or with vibration.
/// `span`: of the rigid bodies' loads.
LoadHistory elastic_loads_of(const Project& project, const planar::Mechanism& mechanism,
                             const planar::Motion& motion, const ElasticModel& model,
                             const LoadSpan& span, LoadsAt rigid);

}  // namespace boxbeam
