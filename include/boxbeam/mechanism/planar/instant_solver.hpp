#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cstdint>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"
#include "boxbeam/mechanism/planar/state.hpp"
#include "boxbeam/numerics/least_squares_elimination.hpp"

namespace boxbeam::planar {

/// How linear systems are solved.
enum class Elimination {
  sparse,  ///< in an order found once per mechanism
  dense,   ///< Eigen's LU with partial pivoting, for comparison
};

/// Everything of instants of one mechanism whose drivers fix its motion: at least as many
/// independent equations as coordinates.
///
///     Phi(q, t) = 0,  J v = -Phi_t,  J a = -(J v)_q v - Phi_tt,  J^T lambda = Q - M a
///
/// Equations that only repeat others are satisfied with them in the sense of least squares, and the
/// multipliers are then the smallest that hold the balance: those that are unique are right, the
/// others are one choice of many (`degrees_of_freedom_of` tells which). Holds the mechanism and the
/// work space of the solver; following a motion allocates no memory, but for friction and redundant
/// equations.
/// Source: Haug (1989), chapters 3, 6 and 7.
class InstantSolver {
 public:
  /// Throws AnalysisError where there are fewer equations than coordinates.
  explicit InstantSolver(const Mechanism& mechanism, Elimination elimination = Elimination::sparse);

  /// Positions from `start` by damped least squares and Newton's method, whatever branch that leads
  /// to. Throws AnalysisError where there is no assembly near.
  Eigen::VectorXd assemble(double time, const Eigen::VectorXd& start);

  /// The state on the wanted branch of every loop, from a rough position. Where the rough position
  /// leads elsewhere, other starts are tried (its bodies turned and shifted over their reach, a
  /// fixed sequence). Throws AnalysisError where the wanted branch is not found.
  State solve_from_sketch(double time, const Eigen::VectorXd& sketch);

  /// The state near a known one: predicted by a Taylor series of second order, corrected by
  /// Newton, and accepted where Newton contracts fast, no irreducible block of the Jacobian has
  /// changed its sign, the wanted branches hold and the position's change agrees with velocities
  /// and accelerations of both ends; else the step of time is halved. A change point, where two
  /// branches cross, is passed on the smooth one and counted in `change_points`. Throws
  /// AnalysisError where the branch cannot be followed.
  State solve_near(double time, const State& known);
  /// The same into a state whose memory is used again.
  void solve_near(double time, const State& known, State& result);

  /// Velocities, accelerations and multipliers at an assembled position. Throws AnalysisError where
  /// they are not determined.
  State solve_at(double time, const Eigen::VectorXd& q);

  const Mechanism& mechanism() const { return *mechanism_; }
  const ConstraintEquations& equations() const { return equations_; }
  /// The elimination in use, after a first solution.
  const SparseElimination& elimination() const {
    return redundant_ ? redundant_->elimination() : sparse_;
  }
  /// How often the order of elimination had to be found anew.
  int reorderings() const { return reorderings_; }
  /// Times of change points passed so far.
  const std::vector<double>& change_points() const { return change_points_; }

 private:
  enum class Outcome { good, no_convergence, singular, other_assembly, off_branch, not_smooth };

  void order_anew();
  /// Factors the Jacobian at hand; false where it is singular.
  bool factor_at_position();
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  void solve_transposed(const Eigen::VectorXd& b, Eigen::VectorXd& y);

  /// Newton without damping from a good start; leaves the equations at the position.
  bool correct(Eigen::VectorXd& q);
  /// Everything but the position, where the equations stand; false at a singular position.
  bool complete(State& state);
  void solve_multipliers(State& state);
  double smallest_pivot() const;
  std::uint64_t assembly_of_factors() const;
  /// Whether redundant equations ask for different velocities.
  bool contradicts(const Eigen::VectorXd& v) const;
  /// Whether the change of position agrees with the rates of both ends.
  bool smooth(const State& from, const State& to, double tolerance) const;
  /// One step of time, without splitting.
  Outcome step(double time, const State& known, State& result, double tolerance, bool crossing);
  /// Steps of time down to `splits` halvings; `reached`: the last state before the failure.
  Outcome follow(double time, const State& known, State& result, State& reached, int splits);
  bool pass_change_point(double time, double place, const State& known, State& result);
  /// Whether the mechanism can be assembled all around a change point between two states.
  bool assembles_around(double place, const State& before, const State& behind) const;
  bool start_at_change_point(double time, const Eigen::VectorXd& sketch, State& state);
  /// Whether no change point of redundant equations lies between two positions.
  bool on_same_side(const State& known, const State& result);
  /// The state at a singular position between two regular ones of a smooth motion.
  void interpolate_singular(double time, const State& before, const State& behind, State& result);

  const Mechanism* mechanism_;
  Elimination kind_;
  ConstraintEquations equations_;
  SparseElimination sparse_;
  std::optional<LeastSquaresElimination> redundant_;  ///< where equations outnumber coordinates
  Eigen::MatrixXd dense_matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> dense_;
  bool ordered_ = false;
  int reorderings_ = 0;
  bool at_dead_point_ = false;            ///< the last assembly could not be brought to round-off
  std::vector<std::uint64_t> block_key_;  ///< per pivot: the key of its block
  std::uint64_t parity_key_ = 0;          ///< signs of the order of rows and columns
  std::vector<double> change_points_;
  double split_work_ = 0.0;  ///< steps by halving so far, times the coordinates
  std::vector<FrictionContact> contacts_;

  Eigen::VectorXd mass_;    ///< diagonal of the mass matrix
  Eigen::VectorXd weight_;  ///< generalised force of gravity
  Eigen::VectorXd inverse_scale_;
  std::vector<double> jacobian_;
  Eigen::VectorXd phi_, right_, step_;
};

}  // namespace boxbeam::planar
