#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/mechanism/planar/instant_solver.hpp"

namespace boxbeam::planar {

/// Integrates the freedoms that no driver moves, under the forces applied. The accelerations come
/// from the equations of motion with the constraints differentiated twice (index 1),
///
///     [ M  J^T ] [ a      ]   [ Q     ]
///     [ J   0  ] [ lambda ] = [ gamma ]
///
/// by a Runge-Kutta method of order 7 with a step chosen by its error (Fehlberg 7(8),
/// Boost.Odeint). After every step positions and velocities are projected back onto the
/// constraints, the shortest way with lengths by the mechanism's size, so that nothing drifts.
/// Where constraints repeat each other, the smallest multipliers are taken (the system is made
/// regular by 1e-10 of its scale, and refined). Close to a singular position, where accelerations
/// lose digits, a step is accepted at an error of 1e-8: smaller steps would only lead deeper into
/// it. Sources: Haug (1989), chapter 7; Fehlberg, NASA TR R-287 (1968); Eich, SIAM J. Numer. Anal.
/// 30 (1993), for the projection.
class FreeSolver {
 public:
  /// `tolerance`: error of a step in scaled coordinates and their rates. `project` false leaves the
  /// drift in, to show it.
  explicit FreeSolver(const Mechanism& mechanism, double tolerance = 1e-11, bool project = true);

  /// The state at a time from rough positions and velocities: both are moved onto the constraints.
  /// Throws AnalysisError where the mechanism cannot be assembled or its mass is singular.
  State start(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  /// The state at a later (or earlier) time. Throws AnalysisError where the step falls below what
  /// arithmetic can tell apart.
  State advance(double time, const State& known);

  /// Steps taken and equations solved so far.
  int steps() const { return steps_; }
  int evaluations() const { return evaluations_; }

 private:
  /// Factors [W J^T; J 0] at the position that the equations stand at; false where it is singular.
  bool factor(SparseElimination& elimination, const Eigen::VectorXd& weight);
  /// Solves with these factors for the right side at hand.
  void solve(const SparseElimination& elimination);
  bool solve_rates(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                   Eigen::VectorXd& a, Eigen::VectorXd& lambda);
  bool project(double time, Eigen::VectorXd& q, Eigen::VectorXd& v);
  State state_of(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  const Mechanism* mechanism_;
  double tolerance_;
  bool project_;
  ConstraintEquations equations_;
  std::vector<FrictionContact> contacts_;
  Eigen::VectorXd mass_, weight_, metric_;
  Eigen::VectorXd scale_;  ///< of rows and columns of the whole system
  SparsePattern pattern_;
  std::vector<std::uint32_t> source_;  ///< per entry of the pattern: which value of the Jacobian
  std::vector<double> values_, jacobian_;
  SparseElimination dynamics_, projection_;
  bool regularised_ = false;  ///< constraints repeat each other
  Eigen::VectorXd phi_, gamma_, right_, solution_, correction_, left_over_;
  int steps_ = 0;
  int evaluations_ = 0;
};

}  // namespace boxbeam::planar
