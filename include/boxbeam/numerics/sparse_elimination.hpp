#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace boxbeam {

/// Where the entries of a sparse matrix stand, row by row; the values come as an array in the same
/// order.
struct SparsePattern {
  Eigen::Index rows = 0;
  Eigen::Index cols = 0;
  std::vector<int> row_start;  ///< rows + 1 entries
  std::vector<int> col;        ///< of each entry, no column twice in a row

  std::size_t entries() const { return col.size(); }
  /// Calls f(entry, column) of every entry of a row.
  template <class F>
  void in_row(Eigen::Index r, const F& f) const {
    const auto begin = static_cast<std::size_t>(row_start[static_cast<std::size_t>(r)]);
    const auto end = static_cast<std::size_t>(row_start[static_cast<std::size_t>(r) + 1]);
    for (std::size_t e = begin; e < end; ++e) f(e, col[e]);
  }
  /// `values` as a dense matrix.
  template <class Scalar>
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> dense(
      const std::vector<Scalar>& values) const {
    Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> matrix(rows, cols);
    matrix.setZero();
    for (Eigen::Index r = 0; r < rows; ++r)
      in_row(r, [&](std::size_t entry, int column) { matrix(r, column) = values[entry]; });
    return matrix;
  }
  /// row_scale * `values` * col_scale as a matrix of Eigen's.
  Eigen::SparseMatrix<double> scaled(const std::vector<double>& values,
                                     const Eigen::VectorXd& row_scale,
                                     const Eigen::VectorXd& col_scale) const;
};

/// Gaussian elimination of sparse matrices of one pattern, in an order of pivots that is chosen
/// once: `analyse` finds an order with little fill-in at given values, `factor` repeats it on other
/// values as a list of multiply-adds, without a search and without memory allocation.
///
/// Rows may be more than columns: rows that hold nothing after the elimination are left over and
/// take no part. The order holds while no multiplier exceeds `growth`; then `factor` says so and
/// the caller analyses anew. Sources: Markowitz, Management Science 3 (1957); Duff, Erisman, Reid,
/// Direct Methods for Sparse Matrices (1986), chapters 5, 7 and 9.
///
/// Scalar: the arithmetic: float, double, long double or Decimal<5>.
template <class Scalar>
class SparseEliminationOf {
 public:
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  /// Multipliers, in scaled rows, above which an order is refused.
  static constexpr double growth = 20.0;
  /// An entry of the scaled matrix that is nothing but round-off.
  static constexpr double nothing = 1e-11;

  /// `row_scale`, `col_scale`: factors that make the matrix's entries comparable. They decide on
  /// the order only, so that it does not depend on units. Returns the rank found: below `cols`
  /// where the matrix is singular; the elimination then cannot be used.
  Eigen::Index analyse(const SparsePattern& pattern, const std::vector<double>& values,
                       const Eigen::VectorXd& row_scale, const Eigen::VectorXd& col_scale);

  /// Factors other values in the same order; false where the order does not suit them.
  bool factor(const std::vector<Scalar>& values);

  /// A x = b on the rows that take part.
  void solve(const Vector& b, Vector& x) const;
  /// A^T y = b; rows left over get y = 0.
  void solve_transposed(const Vector& b, Vector& y) const;

  /// Rows that took no part, ascending.
  const std::vector<int>& rows_left() const { return rows_left_; }
  /// Columns without a pivot, ascending; only after a singular `analyse`.
  const std::vector<int>& cols_left() const { return cols_left_; }

  /// Row and column of the k-th pivot.
  std::size_t pivots() const { return pivot_row_.size(); }
  int pivot_row(std::size_t k) const { return pivot_row_[k]; }
  int pivot_col(std::size_t k) const { return pivot_col_[k]; }
  /// Its value in the last factorisation.
  Scalar pivot(std::size_t k) const { return work_[upper_start_[k]]; }
  /// The smallest pivot of the last factorisation, in the scaled matrix.
  Scalar smallest_pivot() const { return smallest_pivot_; }
  /// Floating-point operations of one factorisation, and of one solution.
  std::size_t factor_operations() const { return factor_operations_; }
  std::size_t solve_operations() const { return 2 * (lower_row_.size() + upper_col_.size()); }

 private:
  // Work space: the rows of U one after the other, each led by its pivot, then the multipliers of
  // pivot after pivot, then a place for the entries of rows left over.
  std::vector<Scalar> work_;
  std::vector<std::uint32_t> place_;        ///< of each entry of the pattern in the work space
  std::vector<std::uint32_t> upper_start_;  ///< per pivot and one behind
  std::vector<std::uint32_t> lower_start_;  ///< per pivot and one behind
  std::vector<std::uint32_t> target_;       ///< of every update, in order
  std::vector<std::uint32_t> upper_col_;    ///< pivot number per place of U
  std::vector<std::uint32_t> lower_row_;    ///< pivot number of the row per multiplier
  std::vector<Scalar> lower_limit_;         ///< per multiplier
  std::vector<Scalar> pivot_scale_;
  std::vector<Scalar> inverse_;  ///< of the pivots
  std::vector<int> pivot_row_, pivot_col_;
  std::vector<int> rows_left_, cols_left_;
  mutable std::vector<Scalar> right_;  ///< right side in the order of the pivots
  Eigen::Index rows_ = 0;
  Scalar smallest_pivot_{};
  std::size_t factor_operations_ = 0;
};

using SparseElimination = SparseEliminationOf<double>;

}  // namespace boxbeam
