#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// The mechanism at one instant. Coordinates body after body: x, y of the centre of mass, angle.
struct State {
  double time = 0.0;       ///< [s]
  Eigen::VectorXd q;       ///< [m, rad]
  Eigen::VectorXd v;       ///< [m/s, rad/s]
  Eigen::VectorXd a;       ///< [m/s^2, rad/s^2]
  Eigen::VectorXd lambda;  ///< multipliers, one per constraint equation [N, N m]
  double residual = 0.0;   ///< largest error of the constraints [m, rad]
};

/// Everything of instants of one mechanism whose drivers fix its motion: as many independent
/// equations as coordinates.
///
///     Phi(q, t) = 0,  J v = -Phi_t,  J a = -(J v)_q v - Phi_tt,  J^T lambda = Q - M a
///
/// Source: Haug (1989), chapters 3, 6 and 7. Holds the mechanism and the work space of the solver.
class InstantSolver {
 public:
  /// Throws AnalysisError where the number of equations is not the number of coordinates.
  explicit InstantSolver(const Mechanism& mechanism);

  /// Positions by Newton's method with step halving (damped) from `start`, whatever branch that
  /// leads to. Throws AnalysisError where it does not converge or the Jacobian is singular.
  Eigen::VectorXd assemble(double time, const Eigen::VectorXd& start);

  /// The state on the wanted branch of every loop, from a rough position. Where the rough position
  /// leads elsewhere, other starts are tried (its bodies turned and shifted over their reach, a
  /// fixed sequence). Throws AnalysisError where the wanted branch is not found.
  State solve_from_sketch(double time, const Eigen::VectorXd& sketch);

  /// The state near a known one: predicted by a Taylor series of second order, corrected by
  /// Newton, branch checked; the step of time is halved until it holds. Throws AnalysisError where
  /// the branch cannot be followed.
  State solve_near(double time, const State& known);

  const Mechanism& mechanism() const { return *mechanism_; }

 private:
  /// Damped Newton; false, and the place where it ended in `q`, where no assembly is found.
  bool try_assemble(double time, Eigen::VectorXd& q);
  State follow(double time, const State& known, int splits);
  /// Newton without damping from a good start; false where it does not converge at once.
  bool correct(double time, Eigen::VectorXd& q);
  State complete(double time, Eigen::VectorXd q);
  double residual_at(double time, const Eigen::VectorXd& q);

  const Mechanism* mechanism_;
  Eigen::VectorXd mass_;  ///< diagonal of the mass matrix
  Eigen::VectorXd load_;  ///< applied forces Q: weight
  Eigen::MatrixXd jacobian_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::VectorXd phi_;
  Eigen::VectorXd step_;
  Eigen::VectorXd trial_;
};

}  // namespace boxbeam::planar
