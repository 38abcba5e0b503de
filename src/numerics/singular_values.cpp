#include "boxbeam/numerics/singular_values.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

/// The same start each time: a vector without a pattern that a mechanism could share.
Eigen::VectorXd patternless(Eigen::Index size) {
  Eigen::VectorXd start(size);
  double number = 0.5;
  for (double& entry : start) {
    number = std::fmod(number * 997.0 + 0.618033988749895, 1.0);
    entry = number - 0.5;
  }
  return start;
}

/// The symmetric tridiagonal matrix that Lanczos' method makes of one larger one.
struct Tridiagonal {
  std::vector<double> diagonal, beside;  ///< beside: one fewer

  bool all_below(double x) const {
    double pivot = diagonal.front() - x;
    for (std::size_t k = 1; pivot < 0.0 && k < diagonal.size(); ++k)
      pivot = diagonal[k] - x - beside[k - 1] * beside[k - 1] / pivot;
    return pivot < 0.0;
  }

  /// By bisection of Sturm's sequence; `least` is no larger.
  double largest(double least) const {
    double most = least;
    for (std::size_t k = 0; k < diagonal.size(); ++k) {
      const double before = k > 0 ? beside[k - 1] : 0.0,
                   behind = k < beside.size() ? beside[k] : 0.0;
      most = std::max(most, diagonal[k] + std::abs(before) + std::abs(behind));
    }
    most *= 1.0 + 1e-12;
    for (int halving = 0; halving < 60 && most - least > 1e-15 * most; ++halving) {
      const double middle = 0.5 * (least + most);
      (all_below(middle) ? most : least) = middle;
    }
    return most;
  }

  /// The last entry of the vector of length one that belongs to its largest value, which decays
  /// towards it: the recurrence from there on is stable.
  double last_of_vector(double value) const {
    double here = 1.0, behind = 0.0, last = 1.0, square = 1.0;
    for (std::size_t k = diagonal.size() - 1; k > 0; --k) {
      const double beyond = k < beside.size() ? beside[k] * behind : 0.0;
      const double before = ((value - diagonal[k]) * here - beyond) / beside[k - 1];
      behind = here;
      here = before;
      square += here * here;
      if (square < 1e200) continue;
      for (double* const of : {&here, &behind, &last}) *of *= 1e-100;
      square *= 1e-200;
    }
    return std::abs(last) / std::sqrt(square);
  }
};

/// What the others are measured by, from below, without orthogonalisation, of which the largest
/// value has no need. It has settled where a singular value is within 5e-6 of it, or where twice
/// the steps raised it by three times that: where very many lie close together it closes in as the
/// square of the steps, so that a third is left. Where it does not settle a bound that is a little
/// above does as well.
double largest_of(const Sparse& A) {
  constexpr int most_steps = 1280;
  constexpr double close = 1e-5;  // of the square
  int looked_at = 10;
  const Eigen::SparseMatrix<double, Eigen::RowMajor> by_rows = A;
  Eigen::VectorXd here = patternless(A.cols()).normalized(), before, image, next;
  Tridiagonal of;
  double square = 0.0;
  for (int step = 1; step <= most_steps; ++step) {
    image.noalias() = by_rows * here;
    next.noalias() = A.transpose() * image;
    if (step > 1) next -= of.beside.back() * before;
    of.diagonal.push_back(image.squaredNorm());
    next -= of.diagonal.back() * here;
    const double length = next.norm();
    if (step == looked_at || step == A.cols() || length == 0.0) {
      const double halfway = square;
      square = of.largest(square);
      if (length * of.last_of_vector(square) <= close * square ||
          square - halfway <= 3.0 * close * square)
        return std::sqrt(square);
      looked_at *= 2;
    }
    of.beside.push_back(length);
    before.swap(here);
    here = next / length;
  }
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

/// Turns orthonormal vectors to those of the SVD of A times them; its values, descending.
Eigen::VectorXd turned_to_values(const Sparse& A, Eigen::MatrixXd& block) {
  const Eigen::Index count = block.cols();
  const Eigen::MatrixXd image = A * block;
  const Eigen::MatrixXd corner = Eigen::HouseholderQR<Eigen::MatrixXd>(image)
                                     .matrixQR()
                                     .topRows(std::min(image.rows(), count))
                                     .triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(corner, Eigen::ComputeFullV);
  block *= svd.matrixV();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(count);
  values.head(svd.singularValues().size()) = svd.singularValues();
  return values;
}

/// All wanted and the next by Lanczos' method on the inverse, where each value stands once or how
/// often does not matter: nothing where one is below `least` or far below the next, so that those
/// like it must be counted, or where they do not settle. Values and vectors are
/// those of the SVD of A times these.
std::optional<SingularValues> without_counting(const Sparse& A,
                                               const Eigen::SimplicialLDLT<Sparse>& inverse,
                                               double largest, double wanted, double least) {
  constexpr Eigen::Index most_steps = 150, most_wanted = 30;
  constexpr double close = 1e-10;  // of the square
  constexpr double far = 1e3;
  const Eigen::Index steps = std::min(most_steps, A.cols());
  Eigen::MatrixXd basis(A.cols(), steps);
  basis.col(0) = patternless(A.cols()).normalized();
  Eigen::VectorXd diagonal(steps), beside(steps), next;
  for (Eigen::Index k = 0; k < steps; ++k) {
    next = inverse.solve(basis.col(k));
    diagonal[k] = basis.col(k).dot(next);
    const auto known = basis.leftCols(k + 1);
    for (int twice = 0; twice < 2; ++twice) next -= known * (known.transpose() * next);
    beside[k] = next.norm();
    const bool last = k + 1 == steps || !(beside[k] > 0.0);
    if (k % 5 == 4 || last) {
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
      small.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k));
      if (small.info() != Eigen::Success) return {};
      std::vector<double> values;  // ascending
      for (Eigen::Index i = k; i >= 0 && k - i < most_wanted; --i) {
        const double square = small.eigenvalues()[i];
        if (!(beside[k] * std::abs(small.eigenvectors()(k, i)) <= close * square)) break;
        values.push_back((A * (known * small.eigenvectors().col(i))).norm());
        if (values.front() <= least) return {};
        if (values.size() > 1 && values.back() > far * values[values.size() - 2]) return {};
        if (values.back() <= wanted * largest) continue;
        // Vectors of small values mix with those behind, whose squares differ by little more than
        // round-off: these are turned with them, settled or not.
        const Eigen::Index count = k - i + 1;
        const Eigen::Index turned = std::min(k + 1, count == 1 ? 1 : 2 * count + 8);
        Eigen::MatrixXd block = orthonormal(known * small.eigenvectors().rightCols(turned));
        const Eigen::VectorXd all = turned_to_values(A, block);
        const Eigen::Index used = wanted_at_end(all, wanted * largest);
        return SingularValues{largest, all.tail(used), block.rightCols(used)};
      }
    }
    if (last) break;
    basis.col(k + 1) = next / beside[k];
  }
  return {};
}

/// The smallest values of A with `count` vectors; those of a subspace are never below those of the
/// whole, so that all wanted at any step says that there are more, and ends the iteration.
SingularValues by_iteration(const Sparse& A, const Eigen::SimplicialLDLT<Sparse>& inverse,
                            double largest, double wanted, Eigen::Index count) {
  constexpr int most_steps = 100;
  // Of values that are wanted; of the next above it is only said how large it is.
  constexpr double close = 1e-8, next_close = 1e-4;
  const double round_off = 1e-14 * largest;
  Eigen::MatrixXd block = patternless(A.cols() * count).reshaped(A.cols(), count);
  block = orthonormal(block);
  SingularValues found;
  found.largest = largest;
  Eigen::VectorXd before;
  for (int step = 0; step < most_steps; ++step) {
    block = orthonormal(inverse.solve(block));
    const Eigen::VectorXd values = turned_to_values(A, block);
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
  if (inverse.info() == Eigen::Success) {
    if (const auto few = without_counting(A, inverse, largest, wanted, delta)) return *few;
  }
  for (Eigen::Index count = 8;; count *= 2) {
    if (inverse.info() != Eigen::Success || 2 * count > A.cols()) return by_svd(A, wanted);
    found = by_iteration(A, inverse, largest, wanted, count);
    // Otherwise the block may have been too narrow for all that are wanted.
    if (found.smallest.size() < count) return found;
  }
}

}  // namespace boxbeam
