#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace boxbeam {

/// What of the singular values of a matrix says how near it is to a singular one.
struct SingularValues {
  double largest = 0.0;
  /// The smallest ones, descending, without those that surely count (all below `wanted` of the
  /// largest, and the one before): of all its columns, zeros included where it has fewer rows.
  Eigen::VectorXd smallest;
  Eigen::MatrixXd vectors;  ///< what they belong to, columns in the same order
};

/// Largest and smallest singular values of A with right singular vectors. `wanted`: all that are
/// below it, relative to the largest, are found to some 1e-8, and the next above them: to 1e-4
/// where it is not the only one.
///
/// Up to `dense_below` columns by the SVD of the whole matrix. Above, by (A^T A + delta^2)^-1,
/// factored once, delta = 1e-7 of the largest: the smallest by Lanczos' method, until within
/// 1e-8 of each there surely is one. Where one is below delta, or a thousandth of the next, so that
/// it may tell a rank, it does not do: of a value that stands there twice it sees one. Then by
/// iteration of a block of vectors, which grows until it holds one value that surely counts: what
/// lies below delta is brought up in one or two steps. Elsewhere a value that stands there twice
/// may be given once. Each value is the length of A times its vector, or from the SVD of A times
/// the block, so that squaring costs no digit. The largest by Lanczos' method, to some 5e-6. Memory
/// and time grow with the entries of the factor, times the number of small values. Source: Golub
/// and Van Loan, Matrix Computations (1996), sections 8.2.4, 8.5.2, 8.6, 9.1, 9.2.
SingularValues smallest_singular_values(const Eigen::SparseMatrix<double>& A, double wanted,
                                        Eigen::Index dense_below = 150);

}  // namespace boxbeam
