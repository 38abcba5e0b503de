#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SparseCore>
#include <variant>
#include <vector>

#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam::frame {

/// The motions that rigid ties G^T x = 0 leave free, and the forces in the ties.
class RigidTies {
 public:
  /// Ties whose columns are combinations of others' to this part of their length repeat them.
  static constexpr double repeats = 1e-9;

  /// G: a row for each coordinate, a column for each tie, of length one or zero. Up to so many
  /// coordinates by the QR of the whole matrix with pivoting; above by a sparse elimination, with
  /// time and memory by the entries of G, times the motions that are free. Sources: Golub and Van
  /// Loan, Matrix Computations (1996), 5.4.1; Duff, Erisman, Reid, Direct Methods for Sparse
  /// Matrices (1986), chapter 5.
  explicit RigidTies(const Eigen::SparseMatrix<double>& G, Eigen::Index most_whole = 300);

  /// Free motions: orthonormal columns.
  const Eigen::MatrixXd& free() const { return free_; }

  /// Sizes s of the ties' forces that do G s; those of ties that repeat others are zero.
  Eigen::VectorXd forces(const Eigen::VectorXd& on_coordinates) const;

 private:
  struct Sparse {
    SparseElimination elimination;
    std::vector<int> kept;  ///< ties that repeat none
  };
  using Whole = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

  static Sparse eliminated(const Eigen::SparseMatrix<double>& G, Eigen::MatrixXd& free);

  Eigen::Index ties_;
  std::variant<Whole, Sparse> factors_;
  Eigen::MatrixXd free_;
};

}  // namespace boxbeam::frame
