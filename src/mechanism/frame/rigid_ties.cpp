#include "rigid_ties.hpp"

#include <algorithm>

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using TiesByRow = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Some columns of a matrix, row by row.
struct SomeTies {
  SparsePattern pattern;
  std::vector<double> values;

  SomeTies(const TiesByRow& G, const std::vector<int>& columns) {
    std::vector<int> number(static_cast<std::size_t>(G.cols()), -1);
    for (std::size_t k = 0; k < columns.size(); ++k)
      number[static_cast<std::size_t>(columns[k])] = static_cast<int>(k);
    pattern.rows = G.rows();
    pattern.cols = static_cast<Index>(columns.size());
    pattern.row_start.push_back(0);
    for (Index r = 0; r < G.rows(); ++r) {
      for (TiesByRow::InnerIterator at(G, r); at; ++at) {
        const int column = number[static_cast<std::size_t>(at.col())];
        if (column < 0 || at.value() == 0.0) continue;
        pattern.col.push_back(column);
        values.push_back(at.value());
      }
      pattern.row_start.push_back(static_cast<int>(pattern.col.size()));
    }
  }
};

MatrixXd orthonormal_columns(const MatrixXd& columns) {
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

}  // namespace

RigidTies::RigidTies(const Eigen::SparseMatrix<double>& G, Index most_whole) : ties_(G.cols()) {
  const Index size = G.rows();
  if (ties_ == 0) {
    free_ = MatrixXd::Identity(size, size);
  } else if (size > most_whole) {
    factors_ = eliminated(G, free_);
  } else {
    Whole& whole = std::get<Whole>(factors_);
    whole.setThreshold(repeats);
    whole.compute(MatrixXd(G));
    const MatrixXd Q = whole.householderQ() * MatrixXd::Identity(size, size);
    free_ = Q.rightCols(size - whole.rank());
  }
}

/// Of G = [C; F], C square by the elimination's choice, x_F is free and C^T x_C = -F^T x_F.
RigidTies::Sparse RigidTies::eliminated(const Eigen::SparseMatrix<double>& by_columns,
                                        MatrixXd& free) {
  const TiesByRow G = by_columns;
  const VectorXd ones = VectorXd::Ones(std::max(G.rows(), G.cols()));
  Sparse result;
  for (int k = 0; k < static_cast<int>(G.cols()); ++k) result.kept.push_back(k);
  SomeTies ties(G, result.kept);
  SparseElimination& elimination = result.elimination;
  while (elimination.analyse(ties.pattern, ties.values, ones, ones) < ties.pattern.cols) {
    const std::vector<int> repeating = elimination.cols_left();
    for (auto k = repeating.rbegin(); k != repeating.rend(); ++k)
      result.kept.erase(result.kept.begin() + *k);
    ties = SomeTies(G, result.kept);
  }
  elimination.factor(ties.values);
  const std::vector<int>& left = elimination.rows_left();
  free.setZero(G.rows(), static_cast<Index>(left.size()));
  VectorXd asked(ties.pattern.cols), moved(G.rows());
  for (std::size_t f = 0; f < left.size(); ++f) {
    asked.setZero();
    const auto row = static_cast<std::size_t>(left[f]);
    for (int e = ties.pattern.row_start[row]; e < ties.pattern.row_start[row + 1]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      asked[ties.pattern.col[entry]] = -ties.values[entry];
    }
    elimination.solve_transposed(asked, moved);
    moved[left[f]] = 1.0;
    free.col(static_cast<Index>(f)) = moved;
  }
  if (!left.empty()) free = orthonormal_columns(free);
  return result;
}

VectorXd RigidTies::forces(const VectorXd& on_coordinates) const {
  VectorXd forces = VectorXd::Zero(ties_);
  if (const auto* sparse = std::get_if<Sparse>(&factors_)) {
    VectorXd kept(static_cast<Index>(sparse->kept.size()));
    sparse->elimination.solve(on_coordinates, kept);
    forces(sparse->kept) = kept;
  } else if (ties_ > 0) {
    forces = std::get<Whole>(factors_).solve(on_coordinates);
  }
  return forces;
}

}  // namespace boxbeam::frame
