#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/beam/flexibility_profile.hpp"
#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"

namespace boxbeam::frame {

/// A body that moves as a whole, in the axes of the beam from its start.
struct RigidMass {
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre [kg m^2]
};

/// One way in which places of the beam, of bodies and of the ground are tied to each other. Its gap
/// is what the forces and couples `per`, which it puts on its places for a unit of its own force,
/// work when these move.
struct Tie {
  struct End {
    /// The beam is member 0, the bodies 1, 2, ...; in the axes of the beam, from its start.
    Place at;
    Vector6 per = Vector6::Zero();
  };
  std::vector<End> ends;
  double stiffness = std::numeric_limits<double>::infinity();  ///< infinite: rigid
  double damping = 0.0;                                        ///< viscous
};

/// A free vibration, of modal mass one.
struct BeamMode {
  double frequency = 0.0;  ///< [Hz]
  CutForceDiagram cut;     ///< along the beam, per unit of the mode
  /// Work of the cut forces at `VibratingBeam::stations`, six for each, on the strains of the mode:
  /// their sum is the generalised force of loads that are in balance with the rigid mechanism.
  Eigen::VectorXd work;
  double damping = 0.0;  ///< phi^T C phi [1/s]
  /// Parts of the elastic energy: stretching, bending about y and about z with shear, torsion, and
  /// what is in elastic ties. What the axial force adds is beside them.
  std::array<double, 5> energy{};
};

/// An elastic beam among rigid bodies: small free vibrations about a posture.
///
/// The beam is cut into pieces whose shapes are those of exact statics under end forces, taper,
/// shear, torsion and couplings of unsymmetric sections as `FlexibilityProfile` knows them; mass
/// and rotary inertia are consistent with these shapes:
///
///     K = A^T F^-1 A,   M = int N^T rho N ds,   F = int B^T f B ds
///
/// Rigid ties are satisfied exactly: what they leave free is the null space of their equations.
/// Frequencies are upper bounds; of a mode of wave number k and pieces of length h high by about
/// (k h)^4/1440 and, of the part of its energy that is torsion, stretching or shear, (k h)^2/24:
/// with eight pieces a cantilever's first in bending by 2e-6, in torsion by 1.6e-3. Left out:
/// warping of torsion.
/// Sources: Przemieniecki, Theory of Matrix Structural Analysis (1968), 5.6, 11.3; Rayleigh, The
/// Theory of Sound (1877), section 88.
class VibratingBeam {
 public:
  /// Cut at the stations of `held`, and between them so that about `parts` pieces make the beam.
  /// Rotary inertia about y and z where the beam counts it, about x always. Where the torsion
  /// constant is not known the beam is as good as rigid in torsion. `beam` stays.
  VibratingBeam(const TaperedBeam& beam, double youngs_modulus, double shear_modulus,
                std::vector<double> held, int parts);

  /// The lowest modes, ascending; fewer where fewer have mass. `rigid`: cut forces of the beam in
  /// the posture, whose axial force softens or stiffens it. Throws AnalysisError where something is
  /// free to move or buckles under that axial force.
  std::vector<BeamMode> modes(const std::vector<RigidMass>& bodies, const std::vector<Tie>& ties,
                              const CutForceDiagram& rigid, std::size_t count) const;

  /// Where cut forces are taken for `BeamMode::work`.
  const std::vector<Station>& stations() const { return stations_; }

 private:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;
  struct Sample {
    double weight = 0.0;
    Eigen::Matrix<double, 6, 12> cut, strain;  ///< per motion of the ends
  };
  struct Piece {
    double from = 0.0, to = 0.0;
    Matrix12 stiffness = Matrix12::Zero(), mass = Matrix12::Zero();
    std::vector<Sample> samples;
  };
  void add_piece(double from, double to, const FlexibilityProfile& profile,
                 const std::vector<SegmentMass>& masses, bool twisted);
  std::size_t node_of(double s) const;
  BeamMode mode_of(const Eigen::VectorXd& motion, double omega, const CutForceDiagram& rigid) const;

  const TaperedBeam* beam_;
  double length_;
  bool rotary_;
  std::vector<double> nodes_;
  std::vector<Piece> pieces_;
  std::vector<Station> stations_;
};

}  // namespace boxbeam::frame
