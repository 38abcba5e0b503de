#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/verification/loaded_posture.hpp"

namespace boxbeam {

/// Free vibrations of a planar mechanism with its elastic beams, stopped in a posture under the
/// forces of its rigid motion there.
struct PostureModes {
  /// Ascending [Hz]; none of what moves without force, which strains and loads nothing.
  std::vector<double> frequencies;
  std::vector<flexible::Mode> motions;  ///< of the links, mass one
  /// What acts on the beam in each, joints and inertia, per unit of the mode [per sqrt(kg) m].
  std::vector<BeamLoads> loads;
  std::vector<CutForceDiagram> diagrams;  ///< of these
  Eigen::MatrixXd damping;                ///< phi^T C phi [1/s]
  /// Motion of the bodies in their own axes, by roots of masses: a column per mode. Tells modes of
  /// different postures apart.
  Eigen::MatrixXd shapes;
  /// An elastic link, and of every part of it, a column per mode: how it is stretched, shifted and
  /// turned.
  struct Strained {
    flexible::DividedLink link;
    std::vector<Eigen::Matrix3Xd> strains;
  };
  Strained beam;
  std::vector<Strained> beside;  ///< in the order of `LoadedPosture::beside`
  /// How far joints that give way open along their axes and turn, a column per mode, in the order
  /// of `LoadedPosture::joints`.
  std::vector<Eigen::Matrix3Xd> gaps;
  /// Of every body, over its masses: sum of m d_i . d_j and of m d_i x d_j of the modes' shifts,
  /// whose frame turns with the body.
  std::vector<Eigen::MatrixXd> shifting, turning;
};

/// Throws AnalysisError where the stopped mechanism is free to move in more ways than it `may`.
/// Precondition: the posture stands, or no axial force counts in it.
PostureModes modes_in_posture(const LoadedPosture& posture, std::size_t count, std::size_t may = 0);

/// The same without those of what moves without force.
PostureModes straining_modes_in(const LoadedPosture& posture, std::size_t count, std::size_t may);

/// A damper of a spring or a joint, which draws its ends together by `damping` times the rate of
/// its gap: of modes eta that is by their `gaps` times eta'. What modes that are not followed do
/// under it they do statically.
struct JointDamper {
  double damping = 0.0;  ///< [N s/m, N m s/rad]
  Eigen::VectorXd gaps;  ///< of the modes
  /// What acts on the beam for a unit of its force in balance: this force, the inertia with which
  /// the modes bear their part of it, and joints, as of `PostureModes::loads`:
  ///
  ///     K y = (1 - M Phi Phi^T) f
  ///
  /// Source: Cornwell, Craig, Johnson, Earthquake Engineering and Structural Dynamics 11 (1983).
  BeamLoads loads;
};

/// `modes`: those that are followed, all of frequency zero among them.
std::vector<JointDamper> dampers_in(const LoadedPosture& posture, const PostureModes& modes);

/// phi^T C phi without dampers: of what is in the strained material [1/s].
Eigen::MatrixXd damping_of_material(const PostureModes& modes,
                                    const std::vector<JointDamper>& dampers);

/// phi_i^T K_g phi_j, K_g of all that presses a mechanism. `straight`: its posture without, of
/// which the modes are; `pressed`: the same with it.
Eigen::MatrixXd geometric_stiffness_of(const PostureModes& modes, const LoadedPosture& straight,
                                       const LoadedPosture& pressed);

/// phi_i^T M psi_j between modes of a posture and others of the same mechanism there, for which
/// other springs act. Throws AnalysisError where its links are divided otherwise.
Eigen::MatrixXd masses_between(const LoadedPosture& posture, const PostureModes& modes,
                               const PostureModes& others);

/// What the turning of the bodies adds to the equations of modes that are fixed to them, at angular
/// velocities omega and accelerations alpha,
///
///     Coriolis  2 omega x eta',   centrifugal and Euler  (alpha x - omega^2) eta
///
/// Source: Shabana, Dynamics of Multibody Systems (2005), chapter 5.
struct FrameTerms {
  Eigen::MatrixXd of_rate, of_size;
};
FrameTerms frame_terms(const PostureModes& modes, const planar::State& state);

/// The generalised force of a mode under loads on the rigid beam that are in balance: the work of
/// their cut forces on its strains,
///
///     p_j = integral of N epsilon_j + V gamma_j + M kappa_j   over the elastic bodies
///           + sum of F gap_j   of the joints that give way
///
/// the same as phi_j^T of all forces and inertia of the rigid mechanism, for joints do no work and
/// rigid bodies are in balance. Per part with the mean cut forces. Source: principle of virtual
/// work.
/// `posture`: of these modes or of the same mechanism in another state.
Eigen::VectorXd modal_loads(const PostureModes& modes, const LoadedPosture& posture);
/// The part of one elastic link, by the mean cut forces over its parts.
Eigen::VectorXd modal_loads(const PostureModes::Strained& of, const Eigen::Matrix3Xd& means);

/// The mean cut forces over each part of a beam, a column each.
Eigen::Matrix3Xd means_over(const CutForceDiagram& diagram,
                            const std::vector<flexible::SpringElement>& springs);

}  // namespace boxbeam
