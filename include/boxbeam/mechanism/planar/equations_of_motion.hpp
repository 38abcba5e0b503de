#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/state.hpp"

namespace boxbeam::planar {

/// The equations of a motion that forces decide, the constraints differentiated twice (index 1),
///
///     [ M  J^T ] [ a      ]   [ Q     ]
///     [ J   0  ] [ lambda ] = [ gamma ]
///
/// Where constraints repeat each other, the smallest multipliers are taken (the system is made
/// regular by 1e-10 of its scale, and refined). Source: Haug (1989), chapter 7.
class EquationsOfMotion {
 public:
  explicit EquationsOfMotion(const Mechanism& mechanism);

  /// Accelerations and multipliers, of contacts that slide and of what acts as its length says;
  /// false where they are not determined.
  bool solve_rates(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                   Eigen::VectorXd& a, Eigen::VectorXd& lambda);
  /// The same of a state, with its friction; contacts slide or stick as its slips say, without them
  /// by their velocity; what acts one way as its touches say.
  bool solve_rates(State& state);

  /// Contacts that rub.
  const std::vector<FrictionContact>& contacts() const { return contacts_; }
  /// Accelerations and multipliers without friction, and what it does; rates of sliding as well.
  /// False where they are not determined.
  bool friction_response(const State& state, FrictionResponse& response);
  /// What impulses along contacts do to velocities, at the state of the last `friction_response`.
  Eigen::VectorXd velocities_by(const Eigen::VectorXd& impulses) const;

  /// Moves positions and velocities onto the constraints, the shortest way with lengths by the
  /// mechanism's size; false at a singular position, and where they cannot be met. Source: Eich,
  /// SIAM J. Numer. Anal. 30 (1993).
  bool project(double time, Eigen::VectorXd& q, Eigen::VectorXd& v);

  /// The constraints at a position, without more.
  void evaluate_at(double time, const Eigen::VectorXd& q);
  /// Stands at a position, factors the matrix there; false where it is singular.
  bool stand_at(double time, const Eigen::VectorXd& q);
  /// The right side [f; g] in place of the forces and gamma, at the position stood at.
  void solve(const Eigen::VectorXd& f, const Eigen::VectorXd& g, Eigen::VectorXd& x,
             Eigen::VectorXd& y);
  /// M a + J^T lambda - Q at the position stood at: what is out of balance.
  Eigen::VectorXd imbalance(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                            const Eigen::VectorXd& a, const Eigen::VectorXd& lambda) const;
  /// -Phi_t - J v at the position stood at: what velocities violate the constraints by.
  void velocity_defect(const Eigen::VectorXd& v, Eigen::VectorXd& defect) const;

  /// The constraints and their derivatives, at the position that was last evaluated.
  const ConstraintEquations& constraints() const { return constraints_; }
  const Eigen::VectorXd& phi() const { return phi_; }
  /// Largest error of the constraints there, lengths by the size of the mechanism.
  double residual() const;
  /// Smallest pivot of the scaled system at the last rates: falls towards a singular position.
  double smallest_pivot() const { return dynamics_.smallest_pivot(); }
  /// How often rates were asked for, or the matrix factored in their place.
  int evaluations() const { return evaluations_; }

 private:
  /// Factors [W J^T; J 0] at the position that the equations stand at; false where it is singular.
  bool factor(SparseElimination& elimination, const Eigen::VectorXd& weight);
  /// Solves with these factors for the right side at hand.
  void solve(const SparseElimination& elimination);

  const Mechanism* mechanism_;
  ConstraintEquations constraints_;
  std::vector<FrictionContact> contacts_;
  bool sticking_ = false;    ///< whether any of them can stick
  Eigen::MatrixXd by_unit_;  ///< accelerations and multipliers per unit of each friction force
  Eigen::VectorXd mass_, weight_, metric_;
  Eigen::VectorXd scale_;  ///< of rows and columns of the whole system
  SparsePattern pattern_;
  std::vector<std::uint32_t> source_;  ///< per entry of the pattern: which value of the Jacobian
  std::vector<double> values_, jacobian_;
  SparseElimination dynamics_, projection_;
  bool regularised_ = false;  ///< constraints repeat each other
  double time_ = 0.0;
  Eigen::VectorXd phi_, gamma_, right_, solution_, correction_, left_over_;
  int evaluations_ = 0;
};

}  // namespace boxbeam::planar
