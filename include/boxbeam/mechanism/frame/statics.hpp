#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <memory>
#include <string_view>
#include <vector>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/beam/flexibility_profile.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"

namespace boxbeam::frame {

/// A shift [m] and a turn [rad], or a force [N] and a couple [N m].
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// What acts at an instant: the weight of every member, points and lines, heat, shifted joints;
/// each already times its factor, wheels where they stand.
struct ActingLoads {
  double weight = 0.0;  ///< so often
  struct Point {
    std::string_view name;  ///< of the action, whose structure stays
    PointAction action;
    std::size_t part = 0;  ///< number of a wheel, from 1 on
  };
  std::vector<Point> points;
  std::vector<LineAction> lines;
  std::vector<HeatAction> heat;
  std::vector<Settlement> settlements;
};

ActingLoads acting_at(const Structure& structure, double time);

/// What is done to a member, in its axes, and what that cuts.
struct MemberLoads {
  BeamLoads loads;  ///< the seam to the verification
  CutForceDiagram cut;
  bool line_loaded = false;        ///< by more than its weight
  Vector6 heat = Vector6::Zero();  ///< strains, in the order of the cut forces
};

/// How a frame stands under loads.
struct Equilibrium {
  std::vector<MemberLoads> members;
  std::vector<Vector6> joints;  ///< what each does to its a, world axes, about the joint's place
  Eigen::VectorXd motion;       ///< of the nodes, for `Statics`
};

class Stability;

/// Solves frames under loads, members exact: their taper, shear and torsion as `FlexibilityProfile`
/// knows them, small displacements.
///
/// Members are cut where joints are. Unknown are the motions u of these nodes, the cut forces c at
/// the end of each piece and the forces of the joints; equations are the balance of the nodes, that
/// pieces fit between their nodes, and the joints:
///
///     A^T c + G^T r = p,   A u - F c = d,   G u - r/k = -settlement
///
/// F = int B^T f B ds and d = int B^T (f c_q + e) ds over a piece, c_q the cut forces of what acts
/// along it between its nodes, e the strains of heat. A point load w at s adds B F(s) w to d, F(s)
/// from the piece's beginning to s, known at the borders of the profile. No stiffness is formed:
/// rigid joints have 1/k = 0, and where balance alone decides, forces are free of the round-off of
/// elasticity. Source: principle of virtual forces; Argyris, Kelsey, Energy Theorems and Structural
/// Analysis (1960).
class Statics {
 public:
  /// `structure` stays. Throws AnalysisError where something is free to move (says what), where
  /// rigid joints hold the same twice, so that their forces are not determined, or where the
  /// torsion constant of a member in space is not known.
  explicit Statics(const Structure& structure) : Statics(structure, 1) {}

  /// The same with every piece cut into so many, for `critical_factor`. `known`: profiles of its
  /// first members that are known already.
  Statics(const Structure& structure, int parts,
          const std::vector<std::shared_ptr<const FlexibilityProfile>>& known = {});

  /// Throws AnalysisError where the loads are not finite.
  Equilibrium solve(const ActingLoads& loads) const;

  /// The same without the diagrams of its members.
  Equilibrium balance(const ActingLoads& loads) const;

  /// Shift and turn of a member's section at a station, at an end of it beyond; world axes.
  Vector6 motion_at(int member, double s, const Equilibrium& of) const;

  /// In the middle of each piece, tension positive [N]; also of what another `Statics` of the same
  /// structure has solved.
  std::vector<double> axial_forces(const Equilibrium& of) const;

  /// At so many times the axial forces in its pieces the frame buckles elastically, sway included,
  /// a plane frame in its plane; at most `most`, beyond which it is not looked. Members bend as
  /// cubics within their pieces: with eight parts N_cr of a bar fixed at both ends is 0.05 % high.
  /// Torsional buckling is not in it. Source: Przemieniecki, Theory of Matrix Structural Analysis
  /// (1968), 15.2 (geometric stiffness); Sylvester's law of inertia for the count.
  double critical_factor(const std::vector<double>& axial_forces, double most = 1e3) const;

  const Structure& structure() const { return *structure_; }

 private:
  struct Node {
    int member = 0;
    double s = 0.0;
  };
  struct Piece {
    int member = 0;
    std::size_t from = 0, to = 0;  ///< nodes
  };
  Eigen::Index row_of_node(std::size_t node) const;
  Eigen::Index row_of_piece(std::size_t piece) const;
  /// F of every piece; gives the flexibility of the softest across [m/N].
  double reach_along_pieces();
  void assemble();
  /// What the loads put on the right of the equations; `members`: by what acts on each.
  Eigen::VectorXd right_side(const ActingLoads& loads,
                             const std::vector<MemberLoads>& members) const;
  std::shared_ptr<Stability> stability() const;
  void refuse_held_twice() const;
  void refuse_mechanisms(const Eigen::SparseMatrix<double>& matrix) const;
  std::size_t node_of(const Place& at) const;
  std::vector<MemberLoads> member_loads_of(const ActingLoads& loads) const;
  std::vector<LineLoad> lines_on(int member, const ActingLoads& loads) const;
  /// How far the section at `to` is shifted and turned from where the one at `from` would carry it,
  /// per cut force at `to`, member axes.
  Eigen::Matrix<double, 6, 6> flexibility_between(int member, double from, double to) const;
  /// The same from the beginning of a piece to a place in it, under a cut force there.
  Vector6 strain_to(std::size_t piece, double s, const Vector6& cut) const;

  const Structure* structure_;
  std::vector<std::shared_ptr<const FlexibilityProfile>> profiles_;  ///< of each member
  std::vector<std::vector<SegmentMass>> masses_;
  std::vector<Node> nodes_;
  std::vector<Piece> pieces_;
  /// F from the beginning of a piece to a place.
  struct Reached {
    double s = 0.0;
    Eigen::Matrix<double, 6, 6> flexibility;
  };
  /// Of each piece, from its beginning on where its profile has borders to its end.
  std::vector<std::vector<Reached>> reached_;
  std::vector<Eigen::Index> joint_rows_;
  double length_ = 1.0, force_ = 1.0;             ///< units of the unknowns [m, N]
  mutable std::shared_ptr<Stability> stability_;  ///< made when first asked for
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace boxbeam::frame
