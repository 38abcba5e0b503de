#include "boxbeam/numerics/least_squares_elimination.hpp"

#include <cmath>
#include <utility>

namespace boxbeam {

LeastSquaresElimination::LeastSquaresElimination(const SparsePattern& pattern,
                                                 const Eigen::VectorXd& row_scale,
                                                 const Eigen::VectorXd& col_scale)
    : rows_(pattern.rows), cols_(pattern.cols), scale_(rows_ + cols_) {
  scale_ << row_scale, col_scale;
  std::vector<std::vector<std::pair<int, int>>> of_row(static_cast<std::size_t>(rows_ + cols_));
  for (Eigen::Index r = 0; r < rows_; ++r) {
    const auto row = static_cast<std::size_t>(r);
    of_row[row].emplace_back(static_cast<int>(r), -1);
    for (int e = pattern.row_start[row]; e < pattern.row_start[row + 1]; ++e) {
      const int col = pattern.col[static_cast<std::size_t>(e)];
      of_row[row].emplace_back(static_cast<int>(rows_) + col, e);
      of_row[static_cast<std::size_t>(rows_ + col)].emplace_back(static_cast<int>(r), e);
    }
  }
  pattern_.rows = pattern_.cols = rows_ + cols_;
  places_.resize(2 * pattern.entries());
  std::vector<char> seen(pattern.entries(), 0);
  for (std::size_t r = 0; r < of_row.size(); ++r) {
    pattern_.row_start.push_back(static_cast<int>(pattern_.col.size()));
    for (const auto& [col, entry] : of_row[r]) {
      const auto place = static_cast<std::uint32_t>(pattern_.col.size());
      pattern_.col.push_back(col);
      values_.push_back(0.0);
      if (entry < 0) {
        const double weight = row_scale[static_cast<Eigen::Index>(r)];
        values_.back() = 1.0 / (weight * weight);
        continue;
      }
      const auto e = static_cast<std::size_t>(entry);
      places_[2 * e + (seen[e] != 0 ? 1U : 0U)] = place;
      seen[e] = 1;
    }
  }
  pattern_.row_start.push_back(static_cast<int>(pattern_.col.size()));
  right_.resize(rows_ + cols_);
  solution_.resize(rows_ + cols_);
}

bool LeastSquaresElimination::factor(const std::vector<double>& values) {
  for (std::size_t e = 0; 2 * e < places_.size(); ++e) {
    values_[places_[2 * e]] = values[e];
    values_[places_[2 * e + 1]] = values[e];
  }
  if (elimination_.pivots() > 0 && elimination_.factor(values_)) return true;
  const bool regular = elimination_.analyse(pattern_, values_, scale_, scale_) == pattern_.cols;
  return regular && elimination_.factor(values_);
}

void LeastSquaresElimination::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  right_.head(rows_) = b;
  right_.tail(cols_).setZero();
  elimination_.solve(right_, solution_);
  x = solution_.tail(cols_);
}

void LeastSquaresElimination::solve_transposed(const Eigen::VectorXd& f, Eigen::VectorXd& y) {
  right_.head(rows_).setZero();
  right_.tail(cols_) = f;
  elimination_.solve(right_, solution_);
  y = solution_.head(rows_);
}

double LeastSquaresElimination::smallest_pivot() const {
  return std::sqrt(elimination_.smallest_pivot());
}

}  // namespace boxbeam
