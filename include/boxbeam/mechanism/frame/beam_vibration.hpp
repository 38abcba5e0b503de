#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/beam/flexibility_profile.hpp"
#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"

namespace boxbeam::frame {

/// A body that moves as a whole, in the axes of a scene.
struct RigidMass {
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre [kg m^2]
};

/// One way in which places of beams, of bodies and of the ground are tied to each other. Its gap is
/// what the forces and couples `per`, which it puts on its places for a unit of its own force, work
/// when these move.
struct Tie {
  struct End {
    /// The beams are members 0, 1, ..., the bodies follow; in the axes of a scene.
    Place at;
    Vector6 per = Vector6::Zero();
    /// Whether its place moves along a beam with the posture: there between nodes.
    bool slides = false;
  };
  std::vector<End> ends;
  double stiffness = std::numeric_limits<double>::infinity();  ///< infinite: rigid
  double damping = 0.0;                                        ///< viscous
  std::string_view name = {};  ///< of the joint or spring that it is of, which owns the text
  /// Of a joint or rod that gives way: what draws its gap together by rigid bodies, the opposite of
  /// its force [N or N m]. Springs have none: what is in them loads the rigid bodies.
  std::optional<double> rigid = {};

  /// Its place among the six cut forces: that of N where it shifts, of T where it turns.
  Eigen::Index way() const { return ends.front().per.head<3>().isZero(0.0) ? 3 : 0; }
};

/// A free vibration, of modal mass one.
struct BeamMode {
  double frequency = 0.0;  ///< [Hz]; none of what moves without force
  CutForceDiagram cut;     ///< along the first beam, per unit of the mode
  /// What acts on the first beam in it, ties and inertia, which is in balance; one point load for
  /// every name and place of a tie. Its line loads are linear on every piece, with the force and
  /// moment of the inertia there; what the axial force does to the bent piece is a couple per
  /// length, so that V stands across the straight axis.
  BeamLoads loads;
  /// Work of the cut forces at `VibratingBeam::stations` of one beam after the other, six for each,
  /// on the strains of the mode, then of `Tie::rigid` of one tie after the other on its gap, at
  /// `Tie::way` of six: their sum is the generalised force of loads that are in balance with the
  /// rigid mechanism.
  Eigen::VectorXd work;
  double damping = 0.0;  ///< phi^T C phi [1/s]
  /// Shifts and turns of the beams' nodes and then of the bodies' centres, six for each, in the
  /// axes of the scene [per sqrt(kg)]; and C times these.
  Eigen::VectorXd motion, drag;
  double own_mass = 0.0;  ///< the first beam's part of the modal mass
  /// Parts of the elastic energy: stretching, bending about y and about z with shear and torsion of
  /// the first beam, what is in elastic ties, and in other beams. What the axial force adds is
  /// beside them.
  std::array<double, 6> energy{};
};

/// How a body turns, in the axes of a scene.
struct Turning {
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< [rad/s]
  Eigen::Vector3d alpha = Eigen::Vector3d::Zero();  ///< [rad/s^2]
};

/// What a turning frame adds to equations of motion, per rate of the coordinates and per
/// coordinate.
struct TurningTerms {
  Eigen::MatrixXd of_rate, of_size;
};

/// Of small turns theta of a body of inertia I about its centre against axes that turn with omega
/// and alpha, from the rate of its angular momentum in its own axes, w = omega + theta' + omega x
/// theta, and the virtual turn delta theta - theta x delta theta/2 of a turning vector:
///
///     of_rate = I omega~ - (I omega)~ + omega~ I
///     of_size = I alpha~ - (I omega)~ omega~ + omega~ I omega~ - (I alpha + omega x I omega)~/2
///
/// a~ b = a x b. Sources: Shabana, Dynamics of Multibody Systems (2005), chapters 3 and 5; Argyris,
/// Computer Methods in Applied Mechanics and Engineering 32 (1982), turning vectors.
TurningTerms turning_terms_of(const Eigen::Matrix3d& inertia, const Turning& frame);

/// An elastic beam cut into pieces whose shapes are those of exact statics under end forces, taper,
/// shear, torsion and couplings of unsymmetric sections as `FlexibilityProfile` knows them; mass
/// and rotary inertia are consistent with these shapes:
///
///     K = A^T F^-1 A,   M = int N^T rho N ds,   F = int B^T f B ds
///
/// Left out: warping of torsion.
/// Source: Przemieniecki, Theory of Matrix Structural Analysis (1968), 5.6, 11.3.
class VibratingBeam {
 public:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  using Leaning = Eigen::Matrix<double, 12, 5>;
  struct Sample {
    double at = 0.0;  ///< from 0 to 1 in its piece
    double weight = 0.0;
    Eigen::Matrix<double, 6, 12> cut, strain, motion;   ///< per motion of the ends
    double mass = 0.0;                                  ///< per length [kg/m]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< per length [kg m]

    /// Columns v', w' of the axis and turns theta_x, theta_y, theta_z, per motion of the ends.
    Leaning leaning() const;
  };
  struct Piece {
    double from = 0.0, to = 0.0;
    Matrix12 stiffness = Matrix12::Zero(), mass = Matrix12::Zero();
    std::vector<Sample> samples;
    /// Shift and turn of a section between the ends, per motion of these: by a polynomial of degree
    /// 5 nearest to that at its samples, in an even piece as it is.
    Eigen::Matrix<double, 6, 12> motion_at(double s) const;

    /// Its leaning as c_0 + c_1 u + c_2 u^2, u from 0 to 1, which on an even piece it is; else by
    /// least squares through its samples.
    std::array<Leaning, 3> leaning;
  };

  /// Cut at the stations of `held`, and between them so that about `parts` pieces make the beam.
  /// Rotary inertia about y and z where the beam counts it, about x always. Where the torsion
  /// constant is not known the beam is as good as rigid in torsion. `beam` stays.
  /// `retardation`: of the material, whose stress is E (strain + retardation strain') [s].
  /// `masses`: along its segments where they are not those of its sections; all their rotary
  /// inertia counts.
  VibratingBeam(const TaperedBeam& beam, double youngs_modulus, double shear_modulus,
                std::vector<double> held, int parts, double retardation = 0.0,
                const std::vector<SegmentMass>& masses = {});

  double length() const { return length_; }            ///< [m]
  double retardation() const { return retardation_; }  ///< [s]
  const std::vector<double>& nodes() const { return nodes_; }
  const std::vector<Piece>& pieces() const { return pieces_; }  ///< one between two nodes
  std::size_t node_of(double s) const;                          ///< the nearest
  std::size_t piece_at(double s) const;                         ///< the last that reaches there

  /// Where cut forces are taken for `BeamMode::work`.
  const std::vector<Station>& stations() const { return stations_; }

 private:
  void add_piece(double from, double to, const FlexibilityProfile& profile,
                 const std::vector<SegmentMass>& masses, bool twisted);

  const TaperedBeam* beam_;
  double length_, retardation_;
  bool rotary_;
  std::vector<double> nodes_;
  std::vector<Piece> pieces_;
  std::vector<Station> stations_;
};

/// A beam as it lies in a scene.
struct PosedBeam {
  const VibratingBeam* beam = nullptr;
  /// Cut forces of the beam as a rigid body, whose axial force softens or stiffens it.
  CutForceDiagram rigid = {};
  Eigen::Vector3d start = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns x (along it), y and z
};

/// Elastic beams and rigid bodies in a posture, tied to each other and to the ground. Its axes are
/// those of its first beam, whose start is its origin.
struct VibratingScene {
  std::vector<PosedBeam> beams;
  std::vector<RigidMass> bodies = {};
  std::vector<Tie> ties = {};
  /// So many of its motions may need no force: modes of frequency zero, which come first, strain
  /// nothing and load nothing.
  std::size_t may_move = 0;
  /// Whether axial forces soften and stiffen the beams. Not where it is free to move: what they do
  /// to whole bodies is only right with the turns of all that presses these
  /// (`geometric_stiffness_of`).
  bool pressed = true;
};

struct EliminatedTies;
/// How the rigid ties of many bodies were eliminated: in other postures of the same scene the same
/// order mostly does.
using KeptTies = std::shared_ptr<EliminatedTies>;

/// A scene as its ties hold it, its stiffness factored: once for all that is asked of a posture.
class FactoredScene {
 public:
  /// `last`: what is kept from one posture of a scene to the next. Throws AnalysisError where
  /// something is free to move or buckles under the axial forces.
  FactoredScene(VibratingScene scene, KeptTies& last);

  const VibratingScene& scene() const;

  struct Factors;
  const Factors& factors() const { return *factors_; }

 private:
  std::shared_ptr<const Factors> factors_;
};

/// The lowest small free vibrations of a scene, ascending; fewer where fewer have mass. Throws
/// AnalysisError where something is free to move or buckles under the axial forces.
///
/// Rigid ties are satisfied exactly: what they leave free is the null space of their equations.
/// Ties of `stiff_as_rigid` times the stiffest piece of a beam are rigid. Frequencies are upper
/// bounds; of a mode of wave number k and pieces of length h high by about (k h)^4/1440 and, of the
/// part of its energy that is torsion, stretching or shear, (k h)^2/24: with eight pieces a
/// cantilever's first in bending by 2e-6, in torsion by 1.6e-3. Source: Rayleigh, The Theory of
/// Sound (1877), section 88.
std::vector<BeamMode> modes_of(const FactoredScene& scene, std::size_t count);
std::vector<BeamMode> modes_of(const VibratingScene& scene, std::size_t count);

/// A damper among the ties of a scene, which draws its gap together by `damping` times the gap's
/// rate: of modes q that is by their `gaps` times q'. What modes that are not followed do under it
/// they do statically.
struct DampedTie {
  double damping = 0.0;
  Eigen::VectorXd gaps;  ///< of the modes
  /// What acts on the first beam for a unit of its force in balance: this force, the inertia with
  /// which the modes bear their part of it, and ties, as of `BeamMode::loads`.
  BeamLoads loads;
};

/// What a scene does statically beside its modes.
struct StaticParts {
  std::vector<DampedTie> dampers;
  /// What ties take over from the first beam where a scene bends statically under loads whose cut
  /// forces in rigid beams and ties that give way are known, K y = B^T c: its loads beside those,
  /// in balance.
  std::optional<BeamLoads> taken_over;
};

/// `modes`: those that are followed, all that are soft among them. `cuts`: as of `BeamMode::work`,
/// where what is taken over is asked for, of a scene that is not pressed.
StaticParts static_parts_of(const FactoredScene& scene, const std::vector<BeamMode>& modes,
                            const std::optional<Eigen::VectorXd>& cuts);

/// The gap that each mode makes of ties that may be others than those of the scene: a row for each
/// tie.
Eigen::MatrixXd gaps_of(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                        const std::vector<Tie>& ties);

/// phi_i^T K_g phi_j of the axial forces of the beams.
Eigen::MatrixXd geometric_stiffness_of(const VibratingScene& scene,
                                       const std::vector<BeamMode>& modes);

/// phi_i^T M psi_j between modes of a scene whose beams, bodies and posture are the same.
Eigen::MatrixXd masses_between(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                               const std::vector<BeamMode>& others);

/// Above it round-off is more than what a tie gives.
inline constexpr double stiff_as_rigid = 1e4;

/// What turning adds to the equations of modes that are fixed to the axes of beams and bodies,
/// `frames` those of the beams and then of the bodies:
///
///     phi_i . m (2 omega x phi_j' + (alpha~ + omega~^2) phi_j)   and `turning_terms_of` a body
///
/// Source: Shabana, Dynamics of Multibody Systems (2005), chapter 5.
TurningTerms turning_terms_of(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                              const std::vector<Turning>& frames);

/// Motion along the beams in a mode, in the axes of each, by roots of masses, so that scalar
/// products are those of the beams' masses; turns about their axes alone.
Eigen::VectorXd shape_on_beams(const VibratingScene& scene, const BeamMode& mode);

}  // namespace boxbeam::frame
