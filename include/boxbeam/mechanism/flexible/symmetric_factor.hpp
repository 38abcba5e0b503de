#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace boxbeam::flexible {

/// P A P^T = L D L^T of a symmetric, not definite matrix (of a complex one A = A^T), D of pivots
/// of one or two rows, chosen so that no entry of L is above 2.79: backward stable, half the work
/// of an LU, and D tells how many eigenvalues are below zero.
/// Source: Ashcraft, Grimes, Lewis, SIAM Journal on Matrix Analysis and Applications 20 (1998),
/// bounded Bunch-Kaufman (rook) pivoting; the law of inertia by Sylvester.
template <class Scalar>
class SymmetricFactor {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// Of the lower half of a square matrix.
  void compute(const Matrix& of);

  /// A x = b. Precondition: no pivot is zero.
  Vector solve(const Vector& right) const;

  /// Eigenvalues below zero, of a real matrix; zero itself is not.
  std::size_t negative() const { return negative_; }

  /// The smallest pivot over the largest; zero of a singular matrix, but for round-off.
  double condition() const { return largest_ > 0.0 ? smallest_ / largest_ : 0.0; }

 private:
  Eigen::Index choose(Eigen::Index at);
  void exchange(Eigen::Index at, Eigen::Index with);
  void eliminate_one(Eigen::Index at);
  void eliminate_two(Eigen::Index at);
  void note(double pivot);

  Matrix lower_;                     ///< L below the pivots of D
  std::vector<Eigen::Index> order_;  ///< row of A by row of L
  std::vector<bool> pairs_;          ///< whether a pivot of two rows begins here
  std::size_t negative_ = 0;
  double smallest_ = 0.0, largest_ = 0.0;
};

}  // namespace boxbeam::flexible
