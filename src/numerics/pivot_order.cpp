#include "pivot_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace boxbeam {
namespace {

using Pivot = PivotOrder::Pivot;

/// The part of the matrix that is not eliminated yet, scaled, and the pivots taken so far.
class ActiveMatrix {
 public:
  struct Entry {
    int col;
    double value;
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

}  // namespace

PivotOrder order_of(const SparsePattern& pattern, const std::vector<double>& values,
                    const Eigen::VectorXd& row_scale, const Eigen::VectorXd& col_scale) {
  ActiveMatrix active(pattern, values, row_scale, col_scale);
  PivotOrder order;
  order.row_number.assign(static_cast<std::size_t>(pattern.rows), no_pivot);
  order.col_number.assign(static_cast<std::size_t>(pattern.cols), no_pivot);
  for (Pivot pivot; active.find_pivot(pivot); pivot = {}) {
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

}  // namespace boxbeam
