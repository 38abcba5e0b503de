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
  correction_.resize(rows_ + cols_);
}

bool LeastSquaresElimination::factor(const std::vector<double>& values) {
  for (std::size_t e = 0; 2 * e < places_.size(); ++e) {
    values_[places_[2 * e]] = values[e];
    values_[places_[2 * e + 1]] = values[e];
  }
  const bool ordered = elimination_.pivots() == static_cast<std::size_t>(pattern_.cols);
  bool regular = ordered && elimination_.factor(values_);
  if (!regular) {
    regular = elimination_.analyse(pattern_, values_, scale_, scale_) == pattern_.cols &&
              elimination_.factor(values_);
  }
  smallest_singular_value_ = 0.0;
  if (!regular) return false;
  // x = (A^T R^2 A)^-1 f with an f that no structure of A is likely to be blind to.
  const auto columns = scale_.tail(cols_);
  right_.head(rows_).setZero();
  double size = 0.0;
  for (Eigen::Index c = 0; c < cols_; ++c) {
    const double f = std::cos(1.7 * static_cast<double>(c) + 0.3);
    size += f * f;
    right_[rows_ + c] = f / columns[c];
  }
  elimination_.solve(right_, solution_);
  const double grown = solution_.tail(cols_).cwiseQuotient(columns).norm();
  smallest_singular_value_ = std::isfinite(grown) ? std::sqrt(std::sqrt(size) / grown) : 0.0;
  return true;
}

void LeastSquaresElimination::solve_refined() {
  elimination_.solve(right_, solution_);
  left_over_ = right_;
  for (Eigen::Index r = 0; r < pattern_.rows; ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (int e = pattern_.row_start[row]; e < pattern_.row_start[row + 1]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      left_over_[r] -= values_[entry] * solution_[pattern_.col[entry]];
    }
  }
  elimination_.solve(left_over_, correction_);
  solution_ += correction_;
}

void LeastSquaresElimination::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  right_.head(rows_) = b;
  right_.tail(cols_).setZero();
  solve_refined();
  x = solution_.tail(cols_);
}

void LeastSquaresElimination::solve_transposed(const Eigen::VectorXd& f, Eigen::VectorXd& y) {
  right_.head(rows_).setZero();
  right_.tail(cols_) = f;
  solve_refined();
  y = solution_.head(rows_);
}

}  // namespace boxbeam
