#include "rigid_ties.hpp"

#include <algorithm>

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using TiesByRow = Eigen::SparseMatrix<double, Eigen::RowMajor>;

bool have_same_entries(const TiesByRow& a, const TiesByRow& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Where the ties that are kept stand, row by row; `entries` and `values` likewise.
SparsePattern pattern_of_kept(const TiesByRow& G, EliminatedTies& of) {
  std::vector<int> number(static_cast<std::size_t>(G.cols()), -1);
  for (std::size_t k = 0; k < of.kept.size(); ++k)
    number[static_cast<std::size_t>(of.kept[k])] = static_cast<int>(k);
  SparsePattern pattern;
  pattern.rows = G.rows();
  pattern.cols = static_cast<Index>(of.kept.size());
  pattern.row_start.push_back(0);
  of.entries.clear();
  of.values.clear();
  for (Index r = 0; r < G.rows(); ++r) {
    for (int e = G.outerIndexPtr()[r]; e < G.outerIndexPtr()[r + 1]; ++e) {
      const int column = number[static_cast<std::size_t>(G.innerIndexPtr()[e])];
      if (column < 0) continue;
      pattern.col.push_back(column);
      of.entries.push_back(e);
      of.values.push_back(G.valuePtr()[e]);
    }
    pattern.row_start.push_back(static_cast<int>(pattern.col.size()));
  }
  return pattern;
}

KeptTies eliminated_anew(const TiesByRow& G) {
  auto of = std::make_shared<EliminatedTies>();
  of->pattern = G;
  const VectorXd ones = VectorXd::Ones(std::max(G.rows(), G.cols()));
  for (int k = 0; k < static_cast<int>(G.cols()); ++k) of->kept.push_back(k);
  SparsePattern pattern = pattern_of_kept(G, *of);
  SparseElimination& elimination = of->elimination;
  while (elimination.analyse(pattern, of->values, ones, ones) < pattern.cols) {
    const std::vector<int> repeating = elimination.cols_left();
    for (auto k = repeating.rbegin(); k != repeating.rend(); ++k)
      of->kept.erase(of->kept.begin() + *k);
    pattern = pattern_of_kept(G, *of);
  }
  elimination.factor(of->values);
  return of;
}

/// Whether the order of pivots suits other values.
bool can_factor(const TiesByRow& G, EliminatedTies& of) {
  if (!have_same_entries(G, of.pattern)) return false;
  for (std::size_t k = 0; k < of.entries.size(); ++k) of.values[k] = G.valuePtr()[of.entries[k]];
  return of.elimination.factor(of.values) &&
         of.elimination.smallest_pivot() > SparseElimination::nothing;
}

MatrixXd orthonormal_columns(const MatrixXd& columns) {
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

}  // namespace

RigidTies::RigidTies(const Eigen::SparseMatrix<double>& G, KeptTies& last, Index most_whole)
    : size_(G.rows()), ties_(G.cols()), tied_(size_, 0) {
  if (ties_ == 0) {
    for (Index k = 0; k < size_; ++k) alone_.push_back(k);
    return;
  }
  if (size_ <= most_whole) {
    Whole& whole = std::get<Whole>(factors_);
    whole.setThreshold(repeats);
    whole.compute(MatrixXd(G));
    const MatrixXd last_columns = MatrixXd::Identity(size_, size_).rightCols(size_ - whole.rank());
    tied_ = whole.householderQ() * last_columns;
    return;
  }
  const ByRows by_rows = G;
  bool repeat = false;
  if (last && can_factor(by_rows, *last)) {
    find_free(by_rows, *last);
    // What repeated others must not hold any of what is free now.
    const MatrixXd held = G.transpose() * tied_;
    repeat = !(held.size() > 0 && held.cwiseAbs().maxCoeff() > repeats);
  }
  if (!repeat) {
    last = eliminated_anew(by_rows);
    find_free(by_rows, *last);
  }
  factors_ = last;
}

/// Of G = [C; F], C square by the elimination's choice, x_F is free and C^T x_C = -F^T x_F.
void RigidTies::find_free(const ByRows& G, const EliminatedTies& of) {
  std::vector<int> number(static_cast<std::size_t>(ties_), -1);
  for (std::size_t k = 0; k < of.kept.size(); ++k)
    number[static_cast<std::size_t>(of.kept[k])] = static_cast<int>(k);
  alone_.clear();
  std::vector<int> left;
  for (const int row : of.elimination.rows_left()) {
    if (G.outerIndexPtr()[row] == G.outerIndexPtr()[row + 1])
      alone_.push_back(row);
    else
      left.push_back(row);
  }
  tied_.setZero(size_, static_cast<Index>(left.size()));
  VectorXd asked(static_cast<Index>(of.kept.size())), moved(size_);
  for (std::size_t f = 0; f < left.size(); ++f) {
    asked.setZero();
    for (ByRows::InnerIterator at(G, left[f]); at; ++at) {
      const int column = number[static_cast<std::size_t>(at.col())];
      if (column >= 0) asked[column] = -at.value();
    }
    of.elimination.solve_transposed(asked, moved);
    moved[left[f]] = 1.0;
    tied_.col(static_cast<Index>(f)) = moved;
  }
  if (!left.empty()) tied_ = orthonormal_columns(tied_);
}

MatrixXd RigidTies::motions(const MatrixXd& of_free) const {
  MatrixXd motions = tied_ * of_free.bottomRows(tied_.cols());
  for (std::size_t k = 0; k < alone_.size(); ++k)
    motions.row(alone_[k]) += of_free.row(static_cast<Index>(k));
  return motions;
}

MatrixXd RigidTies::on_free(const MatrixXd& forces) const {
  MatrixXd of_free(free(), forces.cols());
  const auto alone = static_cast<Index>(alone_.size());
  of_free.topRows(alone) = forces(alone_, Eigen::all);
  of_free.bottomRows(tied_.cols()) = tied_.transpose() * forces;
  return of_free;
}

MatrixXd RigidTies::reduced(const Eigen::SparseMatrix<double>& symmetric) const {
  const auto alone = static_cast<Index>(alone_.size());
  MatrixXd all = MatrixXd::Zero(free(), free());
  const MatrixXd by_tied = symmetric * tied_;
  all.bottomRightCorner(tied_.cols(), tied_.cols()) = tied_.transpose() * by_tied;
  std::vector<Index> place(static_cast<std::size_t>(size_), -1);
  for (Index k = 0; k < alone; ++k)
    place[static_cast<std::size_t>(alone_[static_cast<std::size_t>(k)])] = k;
  for (Index k = 0; k < alone; ++k) {
    const Index row = alone_[static_cast<std::size_t>(k)];
    all.row(k).tail(tied_.cols()) = by_tied.row(row);
    all.col(k).tail(tied_.cols()) = by_tied.row(row).transpose();
    for (Eigen::SparseMatrix<double>::InnerIterator at(symmetric, row); at; ++at) {
      const Index other = place[static_cast<std::size_t>(at.row())];
      if (other >= 0) all(other, k) = at.value();
    }
  }
  return all;
}

VectorXd RigidTies::forces(const VectorXd& on_coordinates) const {
  VectorXd forces = VectorXd::Zero(ties_);
  if (const auto* last = std::get_if<KeptTies>(&factors_)) {
    VectorXd kept(static_cast<Index>((*last)->kept.size()));
    (*last)->elimination.solve(on_coordinates, kept);
    forces((*last)->kept) = kept;
  } else if (ties_ > 0) {
    forces = std::get<Whole>(factors_).solve(on_coordinates);
  }
  return forces;
}

}  // namespace boxbeam::frame
