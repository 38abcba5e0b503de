#include "boxbeam/mechanism/flexible/symmetric_factor.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

namespace boxbeam::flexible {
namespace {

/// A pivot of one row is taken where it is not below this part of what stands beside it:
/// (1 + sqrt(17))/8, which makes two steps of one row grow as much as one of two.
const double alone_from = (1.0 + std::sqrt(17.0)) / 8.0;

/// The largest entry beside the diagonal in a row of what is left, from `at` on.
template <class Matrix>
std::pair<double, Eigen::Index> largest_beside(const Matrix& lower, Eigen::Index at,
                                               Eigen::Index row) {
  double most = 0.0;
  Eigen::Index where = row;
  const auto look = [&](double size, Eigen::Index i) {
    if (!(size > most)) return;
    most = size;
    where = i;
  };
  for (Eigen::Index i = at; i < row; ++i) look(std::abs(lower(row, i)), i);
  for (Eigen::Index i = row + 1; i < lower.rows(); ++i) look(std::abs(lower(i, row)), i);
  return {most, where};
}

}  // namespace

template <class Scalar>
void SymmetricFactor<Scalar>::compute(const Matrix& of) {
  lower_ = of;
  const Eigen::Index size = of.rows();
  order_.resize(static_cast<std::size_t>(size));
  std::iota(order_.begin(), order_.end(), Eigen::Index{0});
  pairs_.assign(order_.size(), false);
  negative_ = 0;
  smallest_ = size > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  largest_ = 0.0;
  for (Eigen::Index at = 0; at < size;) at += choose(at);
}

/// Brings a pivot to `at` and eliminates it; returns its rows.
template <class Scalar>
Eigen::Index SymmetricFactor<Scalar>::choose(Eigen::Index at) {
  Eigen::Index first = at;
  auto [beside, next] = largest_beside(lower_, at, first);
  if (std::abs(lower_(at, at)) >= alone_from * beside) {
    eliminate_one(at);
    return 1;
  }
  // Until the pivot is the largest of its row and its column, as a rook would go.
  for (;;) {
    const auto [further, other] = largest_beside(lower_, at, next);
    if (std::abs(lower_(next, next)) >= alone_from * further) {
      exchange(at, next);
      eliminate_one(at);
      return 1;
    }
    if (other == first || !(further > beside)) {
      // Two exchanges: the second row may have been moved by the first one.
      exchange(at, first);
      exchange(at + 1, next == at ? first : next);
      eliminate_two(at);
      return 2;
    }
    first = next;
    next = other;
    beside = further;
  }
}

template <class Scalar>
void SymmetricFactor<Scalar>::exchange(Eigen::Index at, Eigen::Index with) {
  if (at == with) return;
  if (at > with) std::swap(at, with);
  const Eigen::Index size = lower_.rows();
  std::swap(order_[static_cast<std::size_t>(at)], order_[static_cast<std::size_t>(with)]);
  for (Eigen::Index i = 0; i < at; ++i) std::swap(lower_(at, i), lower_(with, i));
  std::swap(lower_(at, at), lower_(with, with));
  for (Eigen::Index i = at + 1; i < with; ++i) std::swap(lower_(i, at), lower_(with, i));
  for (Eigen::Index i = with + 1; i < size; ++i) std::swap(lower_(i, at), lower_(i, with));
}

template <class Scalar>
void SymmetricFactor<Scalar>::note(double pivot) {
  smallest_ = std::min(smallest_, pivot);
  largest_ = std::max(largest_, pivot);
}

template <class Scalar>
void SymmetricFactor<Scalar>::eliminate_one(Eigen::Index at) {
  const Scalar pivot = lower_(at, at);
  note(std::abs(pivot));
  if constexpr (std::is_same_v<Scalar, double>) {
    if (pivot < 0.0) ++negative_;
  }
  const Eigen::Index left = lower_.rows() - at - 1;
  if (pivot == Scalar(0.0)) return;  // so is all beside it
  const Scalar inverse = Scalar(1.0) / pivot;
  for (Eigen::Index j = 0; j < left; ++j) {
    const Eigen::Index column = at + 1 + j;
    const Scalar beside = lower_(column, at);
    if (beside == Scalar(0.0)) continue;
    const Scalar times = beside * inverse;
    lower_.col(column).tail(left - j).noalias() -= times * lower_.col(at).tail(left - j);
    lower_(column, at) = times;
  }
}

template <class Scalar>
void SymmetricFactor<Scalar>::eliminate_two(Eigen::Index at) {
  pairs_[static_cast<std::size_t>(at)] = true;
  const Scalar a = lower_(at, at), b = lower_(at + 1, at), c = lower_(at + 1, at + 1);
  // |a c| < 0.41 |b|^2 by the choice: one eigenvalue on either side of zero.
  const Scalar det = (a / b) * c - b;  // over b
  note(std::abs(b));
  note(std::abs(det));
  if constexpr (std::is_same_v<Scalar, double>) ++negative_;
  const Eigen::Index left = lower_.rows() - at - 2;
  for (Eigen::Index j = 0; j < left; ++j) {
    const Eigen::Index column = at + 2 + j;
    const Scalar x = lower_(column, at), y = lower_(column, at + 1);
    if (x == Scalar(0.0) && y == Scalar(0.0)) continue;
    const Scalar by_first = ((c / b) * x - y) / det, by_second = ((a / b) * y - x) / det;
    lower_.col(column).tail(left - j).noalias() -=
        by_first * lower_.col(at).tail(left - j) + by_second * lower_.col(at + 1).tail(left - j);
    lower_(column, at) = by_first;
    lower_(column, at + 1) = by_second;
  }
}

template <class Scalar>
typename SymmetricFactor<Scalar>::Vector SymmetricFactor<Scalar>::solve(const Vector& right) const {
  const Eigen::Index size = lower_.rows();
  Vector x(size);
  for (Eigen::Index i = 0; i < size; ++i) x[i] = right[order_[static_cast<std::size_t>(i)]];
  struct Pivot {
    Eigen::Index at, rows;
  };
  std::vector<Pivot> pivots;
  pivots.reserve(order_.size());
  for (Eigen::Index at = 0; at < size; at += pivots.back().rows) {
    const Eigen::Index rows = pairs_[static_cast<std::size_t>(at)] ? 2 : 1;
    const Eigen::Index left = size - at - rows;
    pivots.push_back({at, rows});
    for (Eigen::Index i = at; i < at + rows; ++i) {
      if constexpr (std::is_same_v<Scalar, double>) {
        // Columns are short: what prepares an expression of Eigen's would take longer than they do.
        const double times = x[i];
        const double* const column = lower_.data() + i * size + at + rows;
        double* const rest = x.data() + at + rows;
        for (Eigen::Index row = 0; row < left; ++row) rest[row] -= times * column[row];
      } else {
        x.tail(left).noalias() -= x[i] * lower_.col(i).tail(left);
      }
    }
  }
  for (const auto& [at, rows] : pivots) {
    if (rows == 1) {
      x[at] /= lower_(at, at);
      continue;
    }
    const Scalar a = lower_(at, at), b = lower_(at + 1, at), c = lower_(at + 1, at + 1);
    const Scalar det = (a / b) * c - b;
    const Scalar first = x[at], second = x[at + 1];
    x[at] = ((c / b) * first - second) / det;
    x[at + 1] = ((a / b) * second - first) / det;
  }
  for (auto pivot = pivots.rbegin(); pivot != pivots.rend(); ++pivot) {
    const auto& [at, rows] = *pivot;
    const Eigen::Index left = size - at - rows;
    for (Eigen::Index i = at; i < at + rows; ++i)
      x[i] -= lower_.col(i).tail(left).cwiseProduct(x.tail(left)).sum();
  }
  Vector result(size);
  for (Eigen::Index i = 0; i < size; ++i) result[order_[static_cast<std::size_t>(i)]] = x[i];
  return result;
}

template class SymmetricFactor<double>;
template class SymmetricFactor<std::complex<double>>;

}  // namespace boxbeam::flexible
