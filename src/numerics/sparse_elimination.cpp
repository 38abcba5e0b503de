#include "boxbeam/numerics/sparse_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "boxbeam/numerics/decimal.hpp"
#include "pivot_order.hpp"

namespace boxbeam {
template <class Scalar>
Eigen::Index SparseEliminationOf<Scalar>::analyse(const SparsePattern& pattern,
                                                  const std::vector<double>& values,
                                                  const Eigen::VectorXd& row_scale,
                                                  const Eigen::VectorXd& col_scale) {
  rows_ = pattern.rows;
  const PivotOrder order = order_of(pattern, values, row_scale, col_scale);
  const auto& [pivots, row_number, col_number, rows_left, cols_left] = order;
  rows_left_ = rows_left;
  cols_left_ = cols_left;
  const std::size_t n = pivots.size();
  pivot_row_.assign(n, 0);
  pivot_col_.assign(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    pivot_row_[k] = pivots[k].row;
    pivot_col_[k] = pivots[k].col;
  }

  // Places: rows of U, then multipliers column by column.
  std::unordered_map<std::uint64_t, std::uint32_t> place_of;
  const auto key = [](std::uint64_t i, std::uint64_t j) { return i << 32U | j; };
  upper_start_.assign(1, 0);
  upper_col_.clear();
  pivot_scale_.assign(n, Scalar(0));
  for (std::size_t k = 0; k < n; ++k) {
    place_of[key(k, k)] = static_cast<std::uint32_t>(upper_col_.size());
    upper_col_.push_back(static_cast<std::uint32_t>(k));
    for (const int col : pivots[k].cols) {
      const std::uint32_t j = col_number[static_cast<std::size_t>(col)];
      if (j == no_pivot) continue;  // only where the matrix is singular
      place_of[key(k, j)] = static_cast<std::uint32_t>(upper_col_.size());
      upper_col_.push_back(j);
    }
    upper_start_.push_back(static_cast<std::uint32_t>(upper_col_.size()));
    pivot_scale_[k] = static_cast<Scalar>(row_scale[pivots[k].row] * col_scale[pivots[k].col]);
  }
  lower_start_.assign(1, static_cast<std::uint32_t>(upper_col_.size()));
  lower_row_.clear();
  lower_limit_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    for (const int row : pivots[k].rows) {
      const std::uint32_t i = row_number[static_cast<std::size_t>(row)];
      if (i == no_pivot) continue;  // left over
      place_of[key(i, k)] = static_cast<std::uint32_t>(upper_col_.size() + lower_row_.size());
      lower_row_.push_back(i);
      lower_limit_.push_back(
          static_cast<Scalar>(growth * row_scale[pivots[k].row] / row_scale[row]));
    }
    lower_start_.push_back(static_cast<std::uint32_t>(upper_col_.size() + lower_row_.size()));
  }
  const auto nowhere = static_cast<std::uint32_t>(upper_col_.size() + lower_row_.size());

  target_.clear();
  factor_operations_ = 0;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::uint32_t l = lower_start_[k]; l < lower_start_[k + 1]; ++l) {
      const std::uint32_t i = lower_row_[l - lower_start_[0]];
      for (std::uint32_t u = upper_start_[k] + 1; u < upper_start_[k + 1]; ++u) {
        target_.push_back(place_of.at(key(i, upper_col_[u])));
      }
    }
    const std::size_t below = lower_start_[k + 1] - lower_start_[k];
    factor_operations_ += 1 + below + 2 * below * (upper_start_[k + 1] - upper_start_[k] - 1);
  }
  place_.assign(pattern.entries(), nowhere);
  for (Eigen::Index r = 0; r < pattern.rows; ++r) {
    const std::uint32_t i = row_number[static_cast<std::size_t>(r)];
    if (i == no_pivot) continue;
    const auto begin = static_cast<std::size_t>(pattern.row_start[static_cast<std::size_t>(r)]);
    const auto end = static_cast<std::size_t>(pattern.row_start[static_cast<std::size_t>(r) + 1]);
    for (std::size_t e = begin; e < end; ++e) {
      const std::uint32_t j = col_number[static_cast<std::size_t>(pattern.col[e])];
      if (j != no_pivot) place_[e] = place_of.at(key(i, j));
    }
  }
  work_.assign(nowhere + 1, Scalar(0));
  inverse_.assign(n, Scalar(0));
  right_.assign(n, Scalar(0));
  return static_cast<Eigen::Index>(n);
}

template <class Scalar>
bool SparseEliminationOf<Scalar>::factor(const std::vector<Scalar>& values) {
  using std::abs;
  Scalar* const work = work_.data();
  std::fill(work_.begin(), work_.end(), Scalar(0));
  for (std::size_t e = 0; e < place_.size(); ++e) work[place_[e]] = values[e];
  const std::uint32_t* target = target_.data();
  const Scalar* limit = lower_limit_.data();
  auto smallest = static_cast<Scalar>(std::numeric_limits<double>::infinity());
  bool fits = true;
  for (std::size_t k = 0; k < pivot_row_.size(); ++k) {
    const std::uint32_t first = upper_start_[k];
    const std::uint32_t last = upper_start_[k + 1];
    const Scalar pivot = work[first];
    const Scalar inverse = Scalar(1) / pivot;
    inverse_[k] = inverse;
    smallest = std::min(smallest, abs(pivot) * pivot_scale_[k]);
    for (std::uint32_t l = lower_start_[k]; l < lower_start_[k + 1]; ++l) {
      const Scalar multiplier = work[l] * inverse;
      work[l] = multiplier;
      fits &= abs(multiplier) <= *limit++;
      for (std::uint32_t u = first + 1; u < last; ++u) work[*target++] -= multiplier * work[u];
    }
  }
  smallest_pivot_ = smallest;
  // A pivot of zero makes infinite or undefined multipliers, or infinite solutions: caught here.
  return fits && smallest > Scalar(0);
}

template <class Scalar>
void SparseEliminationOf<Scalar>::solve(const Vector& b, Vector& x) const {
  const std::size_t n = pivot_row_.size();
  Scalar* const right = right_.data();
  const Scalar* const work = work_.data();
  for (std::size_t k = 0; k < n; ++k) right[k] = b[pivot_row_[k]];
  const std::uint32_t* row = lower_row_.data();
  for (std::size_t k = 0; k < n; ++k) {
    const Scalar value = right[k];
    for (std::uint32_t l = lower_start_[k]; l < lower_start_[k + 1]; ++l) {
      right[*row++] -= work[l] * value;
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    Scalar value = right[k];
    for (std::uint32_t u = upper_start_[k] + 1; u < upper_start_[k + 1]; ++u) {
      value -= work[u] * right[upper_col_[u]];
    }
    right[k] = value * inverse_[k];
  }
  for (std::size_t k = 0; k < n; ++k) x[pivot_col_[k]] = right[k];
}

template <class Scalar>
void SparseEliminationOf<Scalar>::solve_transposed(const Vector& b, Vector& y) const {
  const std::size_t n = pivot_row_.size();
  Scalar* const right = right_.data();
  const Scalar* const work = work_.data();
  for (std::size_t k = 0; k < n; ++k) right[k] = b[pivot_col_[k]];
  for (std::size_t k = 0; k < n; ++k) {
    const Scalar value = right[k] * inverse_[k];
    right[k] = value;
    for (std::uint32_t u = upper_start_[k] + 1; u < upper_start_[k + 1]; ++u) {
      right[upper_col_[u]] -= work[u] * value;
    }
  }
  const std::uint32_t* const rows = lower_row_.data();
  for (std::size_t k = n; k-- > 0;) {
    Scalar value = right[k];
    for (std::uint32_t l = lower_start_[k]; l < lower_start_[k + 1]; ++l) {
      value -= work[l] * right[rows[l - lower_start_[0]]];
    }
    right[k] = value;
  }
  for (const int row : rows_left_) y[row] = Scalar(0);
  for (std::size_t k = 0; k < n; ++k) y[pivot_row_[k]] = right[k];
}

Eigen::SparseMatrix<double> SparsePattern::scaled(const std::vector<double>& values,
                                                  const Eigen::VectorXd& row_scale,
                                                  const Eigen::VectorXd& col_scale) const {
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(rows, cols);
  matrix.reserve(static_cast<Eigen::Index>(entries()));
  for (Eigen::Index r = 0; r < rows; ++r) {
    matrix.startVec(r);
    in_row(r, [&](std::size_t e, int c) {
      matrix.insertBackByOuterInnerUnordered(r, c) = row_scale[r] * values[e] * col_scale[c];
    });
  }
  matrix.finalize();
  // By columns; turning it sorts them.
  return matrix;
}

template class SparseEliminationOf<float>;
template class SparseEliminationOf<double>;
template class SparseEliminationOf<long double>;
template class SparseEliminationOf<Decimal<5>>;

}  // namespace boxbeam
