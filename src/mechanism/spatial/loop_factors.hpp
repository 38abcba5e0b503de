#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <variant>
#include <vector>

#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam::spatial {

/// A square Jacobian of closing joints, factorised: a small one as a whole matrix, others by sparse
/// elimination.
class LoopFactors {
 public:
  /// Up to so many rows a whole matrix costs less.
  static constexpr Eigen::Index most_whole = 12;

  /// `entries` in the order of their pattern, comparable with each other. `orders`: orders of
  /// elimination that are known; the first that suits is taken, and where none does one is found.
  LoopFactors(const SparsePattern& pattern, const std::vector<double>& entries,
              const std::vector<SparseElimination>& orders);

  /// J x = b and J^T y = b; not numbers where J is singular.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& b) const;

  /// Sign of the determinant, 0 of a singular matrix; the determinant of many loops is too small
  /// for a number of its own.
  int sign_of_determinant() const;

 private:
  using Whole = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_whole,
                              most_whole>;
  struct Singular {};

  std::variant<Singular, Eigen::PartialPivLU<Whole>, SparseElimination> factors_;
};

/// Whether an order of elimination suits a matrix.
bool suits(SparseElimination order, const std::vector<double>& entries);

/// Finds an order of elimination for a matrix; the rank.
Eigen::Index find_order(const SparsePattern& pattern, const std::vector<double>& entries,
                        SparseElimination& order);

}  // namespace boxbeam::spatial
