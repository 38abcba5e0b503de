#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam {

/// Sparse systems of more equations than unknowns, of full column rank, by the augmented system
///
///     [ R^-2  A ] [ r ]   [ b ]
///     [ A^T   0 ] [ x ] = [ f ]
///
/// with f = 0 for the least squares of R (A x - b), and b = 0 for the y = r of least norm |R^-1 y|
/// with A^T y = f. One elimination in a fixed order serves both. It is regular wherever A has full
/// rank, whichever of its rows repeat others.
/// Source: Björck, Numerical Methods for Least Squares Problems (1996), sections 1.4 and 7.7.
class LeastSquaresElimination {
 public:
  /// `row_scale` R and `col_scale` make the entries of A comparable; R is the weight as well.
  LeastSquaresElimination(const SparsePattern& pattern, const Eigen::VectorXd& row_scale,
                          const Eigen::VectorXd& col_scale);

  /// Values of A in the order of its pattern; false where its columns depend on each other.
  bool factor(const std::vector<double>& values);
  /// Least squares of A x = b.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  /// The shortest y with A^T y = f.
  void solve_transposed(const Eigen::VectorXd& f, Eigen::VectorXd& y);

  /// An estimate, within a small factor, of the smallest singular value of the scaled A, by one
  /// step of inverse iteration on A^T A.
  double smallest_singular_value() const { return smallest_singular_value_; }
  const SparseElimination& elimination() const { return elimination_; }

 private:
  /// Solves for the right side at hand and refines once: so the error grows with the condition of A
  /// and not with its square.
  void solve_refined();

  SparsePattern pattern_;
  Eigen::Index rows_, cols_;
  std::vector<double> values_;
  std::vector<std::uint32_t> places_;  ///< two of each entry of A
  Eigen::VectorXd scale_;
  SparseElimination elimination_;
  Eigen::VectorXd right_, solution_, left_over_, correction_;
  double smallest_singular_value_ = 0.0;
};

}  // namespace boxbeam
