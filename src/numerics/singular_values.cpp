#include "boxbeam/numerics/singular_values.hpp"

#include <Spectra/SymEigsSolver.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// How many at the end of descending values are wanted.
Eigen::Index wanted_at_end(const Eigen::VectorXd& values, double bound) {
  Eigen::Index count = 0;
  while (count < values.size() && values[values.size() - 1 - count] <= bound) ++count;
  return std::min(count + 1, values.size());
}

SingularValues by_svd(const Sparse& A, double wanted) {
  const Eigen::Index columns = A.cols();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Eigen::MatrixXd(A), Eigen::ComputeFullV);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(columns);
  values.head(svd.singularValues().size()) = svd.singularValues();
  SingularValues found;
  found.largest = columns > 0 ? values[0] : 0.0;
  const Eigen::Index count = wanted_at_end(values, wanted * found.largest);
  found.smallest = values.tail(count);
  found.vectors = svd.matrixV().rightCols(count);
  return found;
}

/// A^T A times a vector, as Spectra asks for it.
class Squared {
 public:
  using Scalar = double;
  explicit Squared(const Sparse& A) : A_(A), transposed_(A.transpose()) {}
  Eigen::Index rows() const { return A_.cols(); }
  Eigen::Index cols() const { return A_.cols(); }
  void perform_op(const double* from, double* to) const {
    const Eigen::Map<const Eigen::VectorXd> x(from, A_.cols());
    Eigen::Map<Eigen::VectorXd>(to, A_.cols()) = transposed_ * (A_ * x);
  }

 private:
  const Sparse& A_;
  Sparse transposed_;
};

/// What the others are measured by: its error is about the square of the vector's, 1e-4, and where
/// very many lie close together a bound that is a little above does as well.
double largest_of(const Sparse& A) {
  Squared squared(A);
  Spectra::SymEigsSolver<Squared> solver(squared, 1, std::min<Eigen::Index>(30, A.cols()));
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 40, 1e-4);
  if (solver.info() == Spectra::CompInfo::Successful)
    return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(A.rows()), columns = Eigen::VectorXd::Zero(A.cols());
  for (Eigen::Index c = 0; c < A.outerSize(); ++c) {
    for (Sparse::InnerIterator it(A, c); it; ++it) {
      rows[it.row()] += std::abs(it.value());
      columns[c] += std::abs(it.value());
    }
  }
  return std::sqrt(rows.maxCoeff() * columns.maxCoeff());
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

/// The smallest values of A with `count` vectors; those of a subspace are never below those of the
/// whole, so that all wanted at any step says that there are more, and ends the iteration.
SingularValues by_iteration(const Sparse& A, const Eigen::SimplicialLDLT<Sparse>& inverse,
                            double largest, double wanted, Eigen::Index count) {
  constexpr int most_steps = 100;
  // Of values that are wanted; of the next above it is only said how large it is.
  constexpr double close = 1e-8, next_close = 1e-4;
  const double round_off = 1e-14 * largest;
  // The same start each time: fixed columns without a pattern that a mechanism could share.
  Eigen::MatrixXd block(A.cols(), count);
  double number = 0.5;
  for (double& entry : block.reshaped()) {
    number = std::fmod(number * 997.0 + 0.618033988749895, 1.0);
    entry = number - 0.5;
  }
  block = orthonormal(block);
  SingularValues found;
  found.largest = largest;
  Eigen::VectorXd before;
  for (int step = 0; step < most_steps; ++step) {
    block = orthonormal(inverse.solve(block));
    const Eigen::MatrixXd image = A * block;
    const Eigen::MatrixXd corner = Eigen::HouseholderQR<Eigen::MatrixXd>(image)
                                       .matrixQR()
                                       .topRows(std::min(image.rows(), count))
                                       .triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(corner, Eigen::ComputeFullV);
    block *= svd.matrixV();
    Eigen::VectorXd values = Eigen::VectorXd::Zero(count);
    values.head(svd.singularValues().size()) = svd.singularValues();
    const Eigen::Index used = wanted_at_end(values, wanted * largest);
    found.smallest = values.tail(used);
    found.vectors = block.rightCols(used);
    if (used == count && values[0] <= wanted * largest) break;
    if (before.size() == count && step > 1) {
      const auto has_settled = [&](Eigen::Index k, double within) {
        return std::abs(values[k] - before[k]) <= within * values[k] + round_off;
      };
      bool settled = has_settled(count - used, used > 1 ? next_close : close);
      for (Eigen::Index k = count - used + 1; k < count; ++k)
        settled = settled && has_settled(k, close);
      if (settled) break;
    }
    before = values;
  }
  return found;
}

}  // namespace

SingularValues smallest_singular_values(const Sparse& A, double wanted, Eigen::Index dense_below) {
  if (A.cols() <= dense_below) return by_svd(A, wanted);
  const double largest = largest_of(A);
  SingularValues found;
  if (largest == 0.0) return by_svd(A, wanted);
  const double delta = 1e-7 * largest;
  Sparse shifted = A.transpose() * A;
  Sparse unit(A.cols(), A.cols());
  unit.setIdentity();
  shifted += delta * delta * unit;
  const Eigen::SimplicialLDLT<Sparse> inverse(shifted);
  for (Eigen::Index count = 8;; count *= 2) {
    if (inverse.info() != Eigen::Success || 2 * count > A.cols()) return by_svd(A, wanted);
    found = by_iteration(A, inverse, largest, wanted, count);
    // Otherwise the block may have been too narrow for all that are wanted.
    if (found.smallest.size() < count) return found;
  }
}

}  // namespace boxbeam
