#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SparseCore>
#include <variant>
#include <vector>

#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam::frame {

/// How rigid ties were eliminated.
struct EliminatedTies {
  Eigen::SparseMatrix<double, Eigen::RowMajor> pattern;  ///< of all ties, its values of no matter
  SparseElimination elimination;
  std::vector<int> kept;     ///< ties that repeat none
  std::vector<int> entries;  ///< of the pattern's those of the ties kept, in order
  std::vector<double> values;
};

/// The motions that rigid ties G^T x = 0 leave free, and the forces in the ties.
class RigidTies {
 public:
  /// Ties whose columns are combinations of others' to this part of their length repeat them.
  static constexpr double repeats = 1e-9;

  /// G: a row for each coordinate, a column for each tie, of length one or zero. Up to so many
  /// coordinates by the QR of the whole matrix with pivoting; above by a sparse elimination, with
  /// time and memory by the entries of G, times the free motions that ties have a part in. `last`:
  /// that of the same ties in another posture, whose order is kept while it suits and the same ties
  /// repeat others; it is that of these then. Sources: Golub and Van Loan, Matrix Computations
  /// (1996), 5.4.1; Duff, Erisman, Reid, Direct Methods for Sparse Matrices (1986), chapter 5.
  explicit RigidTies(const Eigen::SparseMatrix<double>& G, KeptTies& last,
                     Eigen::Index most_whole = 300);

  /// How many motions are free.
  Eigen::Index free() const { return static_cast<Eigen::Index>(alone_.size()) + tied_.cols(); }
  /// Of free motions, which are orthonormal, the coordinates, a column for each.
  Eigen::MatrixXd motions(const Eigen::MatrixXd& of_free) const;
  /// What forces on the coordinates do to the free motions.
  Eigen::MatrixXd on_free(const Eigen::MatrixXd& forces) const;
  /// A symmetric matrix of the coordinates as that of the free motions.
  Eigen::MatrixXd reduced(const Eigen::SparseMatrix<double>& symmetric) const;

  /// Sizes s of the ties' forces that do G s; those of ties that repeat others are zero.
  Eigen::VectorXd forces(const Eigen::VectorXd& on_coordinates) const;

 private:
  using Whole = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
  using ByRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  void find_free(const ByRows& G, const EliminatedTies& of);

  Eigen::Index size_, ties_;
  std::variant<Whole, KeptTies> factors_;
  std::vector<Eigen::Index> alone_;  ///< coordinates that no tie has a part in: free by themselves
  Eigen::MatrixXd tied_;             ///< the other free motions, columns
};

}  // namespace boxbeam::frame
