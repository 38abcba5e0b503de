#include "boxbeam/numerics/sparse_elimination.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "boxbeam/numerics/decimal.hpp"

namespace boxbeam {
namespace {

/// The part of the matrix that is not eliminated yet, scaled, and the pivots taken so far.
class ActiveMatrix {
 public:
  struct Entry {
    int col;
    double value;
  };
  struct Pivot {
    int row = -1;
    int col = -1;
    std::vector<int> cols;  ///< right of it in its row
    std::vector<int> rows;  ///< below it in its column
  };

  ActiveMatrix(const SparsePattern& pattern, const std::vector<double>& values,
               const Eigen::VectorXd& row_scale, const Eigen::VectorXd& col_scale)
      : row_(static_cast<std::size_t>(pattern.rows)),
        col_(static_cast<std::size_t>(pattern.cols)),
        at_(static_cast<std::size_t>(pattern.cols), -1) {
    for (std::size_t r = 0; r < row_.size(); ++r) {
      for (int e = pattern.row_start[r]; e < pattern.row_start[r + 1]; ++e) {
        const int c = pattern.col[static_cast<std::size_t>(e)];
        const double value = values[static_cast<std::size_t>(e)] *
                             row_scale[static_cast<Eigen::Index>(r)] * col_scale[c];
        row_[r].push_back({c, value});
        col_[static_cast<std::size_t>(c)].push_back(static_cast<int>(r));
      }
      rows_by_count_.emplace(row_[r].size(), static_cast<int>(r));
    }
    for (std::size_t c = 0; c < col_.size(); ++c) {
      cols_by_count_.emplace(col_[c].size(), static_cast<int>(c));
    }
  }

  /// The cheapest acceptable pivot by Markowitz' count; false where none is left.
  bool find_pivot(Pivot& pivot) const {
    Choice best;
    int looked_at = 0;
    auto row = rows_by_count_.begin();
    auto col = cols_by_count_.begin();
    // Rows and columns in the order of their counts; four lists with an acceptable entry are enough
    // (Zlatev), and no list of larger count can be cheaper than the square of its count.
    while (row != rows_by_count_.end() || col != cols_by_count_.end()) {
      const bool take_col =
          row == rows_by_count_.end() || (col != cols_by_count_.end() && col->first <= row->first);
      const std::size_t count = take_col ? col->first : row->first;
      if (best.row >= 0 && count > 0 && (count - 1) * (count - 1) >= best.cost) break;
      const bool found = take_col ? look_at_col(col->second, best) : look_at_row(row->second, best);
      if (found && ++looked_at >= 4) break;
      if (take_col) {
        ++col;
      } else {
        ++row;
      }
    }
    pivot.row = best.row;
    pivot.col = best.col;
    return best.row >= 0;
  }

  /// Takes a pivot's row and column out, and updates the rest.
  void eliminate(Pivot& pivot) {
    const auto r = static_cast<std::size_t>(pivot.row);
    const auto c = static_cast<std::size_t>(pivot.col);
    const double value = value_at(pivot.row, pivot.col);
    forget(rows_by_count_, row_[r].size(), pivot.row);
    forget(cols_by_count_, col_[c].size(), pivot.col);
    for (const Entry& entry : row_[r]) {
      if (entry.col == pivot.col) continue;
      pivot.cols.push_back(entry.col);
      drop_from_col(entry.col, pivot.row);
    }
    for (const int other : col_[c]) {
      if (other == pivot.row) continue;
      pivot.rows.push_back(other);
      subtract(other, pivot, value);
    }
    row_[r].clear();
    col_[c].clear();
  }

  std::vector<int> rows_left() const { return names_of(rows_by_count_); }
  std::vector<int> cols_left() const { return names_of(cols_by_count_); }

 private:
  using Counts = std::set<std::pair<std::size_t, int>>;
  struct Choice {
    int row = -1;
    int col = -1;
    std::size_t cost = std::numeric_limits<std::size_t>::max();
    double size = 0.0;
  };

  static std::vector<int> names_of(const Counts& counts) {
    std::vector<int> names;
    for (const auto& [count, name] : counts) names.push_back(name);
    std::sort(names.begin(), names.end());
    return names;
  }

  static void forget(Counts& counts, std::size_t count, int name) { counts.erase({count, name}); }

  double value_at(int row, int col) const {
    for (const Entry& entry : row_[static_cast<std::size_t>(row)]) {
      if (entry.col == col) return entry.value;
    }
    return 0.0;
  }

  double largest_in_col(int col) const {
    double largest = 0.0;
    for (const int r : col_[static_cast<std::size_t>(col)]) {
      largest = std::max(largest, std::abs(value_at(r, col)));
    }
    return largest;
  }

  bool consider(int row, int col, double value, double largest, Choice& best) const {
    constexpr double threshold = 0.2;
    const double size = std::abs(value);
    if (size <= SparseElimination::nothing || size < threshold * largest) return false;
    const std::size_t cost = (row_[static_cast<std::size_t>(row)].size() - 1) *
                             (col_[static_cast<std::size_t>(col)].size() - 1);
    if (cost < best.cost || (cost == best.cost && size > best.size)) {
      best = {row, col, cost, size};
    }
    return true;
  }

  bool look_at_col(int col, Choice& best) const {
    const double largest = largest_in_col(col);
    bool found = false;
    for (const int r : col_[static_cast<std::size_t>(col)]) {
      found = consider(r, col, value_at(r, col), largest, best) || found;
    }
    return found;
  }

  bool look_at_row(int row, Choice& best) const {
    bool found = false;
    for (const Entry& entry : row_[static_cast<std::size_t>(row)]) {
      found = consider(row, entry.col, entry.value, largest_in_col(entry.col), best) || found;
    }
    return found;
  }

  void drop_from_col(int col, int row) {
    std::vector<int>& rows = col_[static_cast<std::size_t>(col)];
    forget(cols_by_count_, rows.size(), col);
    rows.erase(std::find(rows.begin(), rows.end(), row));
    cols_by_count_.emplace(rows.size(), col);
  }

  /// row -= (its entry in the pivot's column / pivot) * pivot's row; the entry itself goes.
  void subtract(int name, const Pivot& pivot, double value) {
    std::vector<Entry>& row = row_[static_cast<std::size_t>(name)];
    forget(rows_by_count_, row.size(), name);
    const auto own = std::find_if(row.begin(), row.end(),
                                  [&](const Entry& entry) { return entry.col == pivot.col; });
    const double factor = own->value / value;
    *own = row.back();
    row.pop_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      at_[static_cast<std::size_t>(row[i].col)] = static_cast<int>(i);
    }
    for (const Entry& entry : row_[static_cast<std::size_t>(pivot.row)]) {
      if (entry.col == pivot.col) continue;
      const int place = at_[static_cast<std::size_t>(entry.col)];
      if (place >= 0) {
        row[static_cast<std::size_t>(place)].value -= factor * entry.value;
        continue;
      }
      row.push_back({entry.col, -factor * entry.value});
      std::vector<int>& rows = col_[static_cast<std::size_t>(entry.col)];
      forget(cols_by_count_, rows.size(), entry.col);
      rows.push_back(name);
      cols_by_count_.emplace(rows.size(), entry.col);
    }
    for (const Entry& entry : row) at_[static_cast<std::size_t>(entry.col)] = -1;
    rows_by_count_.emplace(row.size(), name);
  }

  std::vector<std::vector<Entry>> row_;
  std::vector<std::vector<int>> col_;  ///< rows per column
  std::vector<int> at_;                ///< place of a column in the row at hand
  Counts rows_by_count_, cols_by_count_;
};

constexpr std::uint32_t no_pivot = std::numeric_limits<std::uint32_t>::max();

/// The pivots one after the other, and the number of each row's and column's.
struct PivotOrder {
  std::vector<ActiveMatrix::Pivot> pivots;
  std::vector<std::uint32_t> row_number, col_number;  ///< `no_pivot` without a pivot
  std::vector<int> rows_left, cols_left;
};

PivotOrder order_of(const SparsePattern& pattern, const std::vector<double>& values,
                    const Eigen::VectorXd& row_scale, const Eigen::VectorXd& col_scale) {
  ActiveMatrix active(pattern, values, row_scale, col_scale);
  PivotOrder order;
  order.row_number.assign(static_cast<std::size_t>(pattern.rows), no_pivot);
  order.col_number.assign(static_cast<std::size_t>(pattern.cols), no_pivot);
  for (ActiveMatrix::Pivot pivot; active.find_pivot(pivot); pivot = {}) {
    active.eliminate(pivot);
    const auto k = static_cast<std::uint32_t>(order.pivots.size());
    order.row_number[static_cast<std::size_t>(pivot.row)] = k;
    order.col_number[static_cast<std::size_t>(pivot.col)] = k;
    order.pivots.push_back(std::move(pivot));
  }
  order.rows_left = active.rows_left();
  order.cols_left = active.cols_left();
  return order;
}

}  // namespace

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
    const auto begin = static_cast<std::size_t>(row_start[static_cast<std::size_t>(r)]);
    const auto end = static_cast<std::size_t>(row_start[static_cast<std::size_t>(r) + 1]);
    for (std::size_t e = begin; e < end; ++e)
      matrix.insertBackByOuterInnerUnordered(r, col[e]) =
          row_scale[r] * values[e] * col_scale[col[e]];
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
