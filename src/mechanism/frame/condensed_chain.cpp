#include "condensed_chain.hpp"

#include <Eigen/Cholesky>

namespace boxbeam::frame {
namespace {

Eigen::Index row_of_node(std::size_t node) { return static_cast<Eigen::Index>(6 * node); }

}  // namespace

std::optional<CondensedChain> CondensedChain::of(const std::vector<Matrix12>& pieces,
                                                 const std::vector<bool>& kept) {
  CondensedChain chain;
  std::size_t from = 0;
  Matrix12 left;  // between `from` and the node before the piece
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Matrix12& piece = pieces[i];
    if (kept[i]) {
      from = i;
      left = piece;
    } else {
      const Eigen::LLT<Matrix6> own(left.bottomRightCorner<6, 6>() + piece.topLeftCorner<6, 6>());
      if (own.info() != Eigen::Success) return {};
      Eigen::Matrix<double, 6, 12> beside;
      beside << left.bottomLeftCorner<6, 6>(), piece.topRightCorner<6, 6>();
      Eliminated& of = chain.eliminated_.emplace_back();
      of.from = from;
      of.node = i;
      of.flexibility = own.solve(Matrix6::Identity());
      of.follows = of.flexibility.lazyProduct(beside);
      Matrix12 next = -beside.transpose().lazyProduct(of.follows);
      next.topLeftCorner<6, 6>() += left.topLeftCorner<6, 6>();
      next.bottomRightCorner<6, 6>() += piece.bottomRightCorner<6, 6>();
      left = 0.5 * (next + next.transpose());
    }
    if (kept[i + 1]) chain.stretches_.push_back({from, i + 1, left});
  }
  return chain;
}

void CondensedChain::carry_to_kept(Eigen::Ref<Eigen::MatrixXd> forces) const {
  for (const Eliminated& of : eliminated_) {
    const auto on_node = forces.middleRows<6>(row_of_node(of.node));
    forces.middleRows<6>(row_of_node(of.from)) -=
        of.follows.leftCols<6>().transpose().lazyProduct(on_node);
    forces.middleRows<6>(row_of_node(of.node + 1)) -=
        of.follows.rightCols<6>().transpose().lazyProduct(on_node);
  }
}

void CondensedChain::move_between(Eigen::Ref<Eigen::MatrixXd> motions) const {
  for (auto of = eliminated_.rbegin(); of != eliminated_.rend(); ++of) {
    const auto at_from = motions.middleRows<6>(row_of_node(of->from)),
               at_next = motions.middleRows<6>(row_of_node(of->node + 1));
    auto at_node = motions.middleRows<6>(row_of_node(of->node));
    const Eigen::MatrixXd by_forces = of->flexibility.lazyProduct(at_node);
    at_node = by_forces;
    at_node -= of->follows.leftCols<6>().lazyProduct(at_from);
    at_node -= of->follows.rightCols<6>().lazyProduct(at_next);
  }
}

}  // namespace boxbeam::frame
