#include "loop_factors.hpp"

#include <limits>

namespace boxbeam::spatial {
namespace {

/// 1 of an even permutation, -1 of an odd one: each cycle of even length changes it.
int sign_of_permutation(const std::vector<int>& to) {
  int sign = 1;
  std::vector<char> seen(to.size(), 0);
  for (std::size_t i = 0; i < to.size(); ++i) {
    bool even = false;
    for (std::size_t k = i; seen[k] == 0; k = static_cast<std::size_t>(to[k])) {
      seen[k] = 1;
      if (k != i) even = !even;
    }
    if (even) sign = -sign;
  }
  return sign;
}

/// That of a permutation, times those of all pivots.
int sign_with_pivots(int sign, std::size_t count, const auto& pivot) {
  for (std::size_t k = 0; k < count; ++k) {
    const double value = pivot(k);
    if (!(value != 0.0)) return 0;
    if (value < 0.0) sign = -sign;
  }
  return sign;
}

template <class... Visitors>
struct ByFactors : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
ByFactors(Visitors...) -> ByFactors<Visitors...>;

}  // namespace

LoopFactors::LoopFactors(const SparsePattern& pattern, const std::vector<double>& entries,
                         const std::vector<SparseElimination>& orders) {
  if (pattern.rows <= most_whole) {
    Whole J = Whole::Zero(pattern.rows, pattern.cols);
    for (Eigen::Index r = 0; r < pattern.rows; ++r) {
      const auto row = static_cast<std::size_t>(r);
      for (int e = pattern.row_start[row]; e < pattern.row_start[row + 1]; ++e)
        J(r, pattern.col[static_cast<std::size_t>(e)]) = entries[static_cast<std::size_t>(e)];
    }
    factors_.emplace<Eigen::PartialPivLU<Whole>>(J);
    return;
  }
  for (const SparseElimination& order : orders) {
    if (factors_.emplace<SparseElimination>(order).factor(entries)) return;
  }
  SparseElimination& own = factors_.emplace<SparseElimination>();
  if (find_order(pattern, entries, own) < pattern.cols || !own.factor(entries))
    factors_.emplace<Singular>();
}

Eigen::VectorXd LoopFactors::solve(const Eigen::VectorXd& b) const {
  return std::visit(
      ByFactors{
          [&](const Singular&) -> Eigen::VectorXd {
            return Eigen::VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
          },
          [&](const Eigen::PartialPivLU<Whole>& lu) -> Eigen::VectorXd { return lu.solve(b); },
          [&](const SparseElimination& elimination) {
            Eigen::VectorXd x(b.size());
            elimination.solve(b, x);
            return x;
          }},
      factors_);
}

Eigen::VectorXd LoopFactors::solve_transposed(const Eigen::VectorXd& b) const {
  return std::visit(ByFactors{[&](const Singular&) -> Eigen::VectorXd {
                                return Eigen::VectorXd::Constant(
                                    b.size(), std::numeric_limits<double>::quiet_NaN());
                              },
                              [&](const Eigen::PartialPivLU<Whole>& lu) -> Eigen::VectorXd {
                                return lu.transpose().solve(b);
                              },
                              [&](const SparseElimination& elimination) {
                                Eigen::VectorXd y(b.size());
                                elimination.solve_transposed(b, y);
                                return y;
                              }},
                    factors_);
}

int LoopFactors::sign_of_determinant() const {
  return std::visit(
      ByFactors{[](const Singular&) { return 0; },
                [](const Eigen::PartialPivLU<Whole>& lu) {
                  return sign_with_pivots(lu.permutationP().determinant() > 0 ? 1 : -1,
                                          static_cast<std::size_t>(lu.rows()), [&](std::size_t k) {
                                            const auto i = static_cast<Eigen::Index>(k);
                                            return lu.matrixLU()(i, i);
                                          });
                },
                [](const SparseElimination& elimination) {
                  std::vector<int> col_of(elimination.pivots());
                  for (std::size_t k = 0; k < col_of.size(); ++k)
                    col_of[static_cast<std::size_t>(elimination.pivot_row(k))] =
                        elimination.pivot_col(k);
                  return sign_with_pivots(sign_of_permutation(col_of), col_of.size(),
                                          [&](std::size_t k) { return elimination.pivot(k); });
                }},
      factors_);
}

bool suits(SparseElimination order, const std::vector<double>& entries) {
  return order.factor(entries);
}

Eigen::Index find_order(const SparsePattern& pattern, const std::vector<double>& entries,
                        SparseElimination& order) {
  return order.analyse(pattern, entries, Eigen::VectorXd::Ones(pattern.rows),
                       Eigen::VectorXd::Ones(pattern.cols));
}

}  // namespace boxbeam::spatial
