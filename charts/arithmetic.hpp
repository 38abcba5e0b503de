#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/numerics/decimal.hpp"

namespace boxbeam::charts {

/// A mechanism at an instant, in some arithmetic. Coordinates as in planar::State.
template <class Scalar>
struct InstantIn {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  Vector q, v, a;
  Vector lambda;  ///< multipliers, empty where they were not asked for

  template <class Other>
  InstantIn<Other> in() const {
    return {q.template cast<Other>(), v.template cast<Other>(), a.template cast<Other>(),
            lambda.template cast<Other>()};
  }
};

/// How the linear systems of a mechanism are solved.
enum class LinearMethod {
  dense,       ///< LU with partial pivoting
  sparse,      ///< in an order found once (SparseElimination)
  orthogonal,  ///< QR with column pivoting of the scaled equations: redundant ones too
};

const char* to_text(LinearMethod method);

/// The equations of instants as textbooks solve them, in any arithmetic: Newton's method with full
/// steps and no look at the branch, then velocities, accelerations and multipliers.
/// Source: Haug (1989), chapters 3, 4 and 6.
template <class Scalar>
class TextbookSolver {
 public:
  using Vector = typename InstantIn<Scalar>::Vector;
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  TextbookSolver(const planar::Mechanism& mechanism, LinearMethod method);

  /// Where drivers stand in the following.
  planar::ConstraintEquationsOf<Scalar>& equations() { return equations_; }

  /// Positions from a start, until a step is below `tolerance`, lengths by the mechanism's size, or
  /// as small as the arithmetic has it. Returns the iterations, 0 where it does not converge.
  int solve_position(Vector& q, double tolerance);
  /// Velocities and accelerations at the positions of `instant`; false where they are not
  /// determined.
  bool solve_rates(InstantIn<Scalar>& instant);
  /// What the joints have to balance, Q - M a. Forces other than weights are evaluated in double.
  Vector balance_of(double time, const InstantIn<Scalar>& instant) const;
  /// Multipliers of these; only after `solve_rates` at the same position.
  void solve_multipliers(double time, InstantIn<Scalar>& instant);
  /// The Jacobian of the last `solve_rates`.
  Matrix jacobian() const { return equations_.pattern().dense(values_); }

  /// Floating-point operations of one elimination and of one solution.
  double factor_operations() const;
  double solve_operations() const;

 private:
  bool factor();
  void solve(const Vector& right, Vector& x);
  void solve_transposed(const Vector& right, Vector& y);
  /// Q of the orthogonal decomposition, or its transpose, times x, by one reflection after another.
  void reflect(Vector& x, bool transposed) const;

  const planar::Mechanism* mechanism_;
  LinearMethod method_;
  planar::ConstraintEquationsOf<Scalar> equations_;
  SparseEliminationOf<Scalar> sparse_;
  bool ordered_ = false;
  Eigen::PartialPivLU<Matrix> dense_;
  Eigen::ColPivHouseholderQR<Matrix> orthogonal_;
  Vector row_scale_, col_scale_, phi_, step_;
  std::vector<Scalar> values_;
};

}  // namespace boxbeam::charts
