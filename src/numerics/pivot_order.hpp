#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "boxbeam/numerics/sparse_elimination.hpp"

namespace boxbeam {

inline constexpr std::uint32_t no_pivot = std::numeric_limits<std::uint32_t>::max();

/// The pivots one after the other, and the number of each row's and column's.
struct PivotOrder {
  /// An entry that is eliminated with, and what it meets.
  struct Pivot {
    int row = -1;
    int col = -1;
    std::vector<int> cols;  ///< right of it in its row
    std::vector<int> rows;  ///< below it in its column
  };

  std::vector<Pivot> pivots;
  std::vector<std::uint32_t> row_number, col_number;  ///< `no_pivot` without a pivot
  std::vector<int> rows_left, cols_left;
};

/// The cheapest acceptable pivots by Markowitz' counts, of a matrix scaled by rows and columns.
PivotOrder order_of(const SparsePattern& pattern, const std::vector<double>& values,
                    const Eigen::VectorXd& row_scale, const Eigen::VectorXd& col_scale);

}  // namespace boxbeam
