#include "held_scene.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::Index row_of_node(std::size_t node) { return static_cast<Eigen::Index>(6 * node); }

/// Below it a motion needs no force, by the stiffest.
constexpr double round_off = 1e-14;

Index rows_of_nodes(const PosedBeam& posed) {
  return static_cast<Index>(6 * posed.beam->nodes().size());
}

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

HeldScene::HeldScene(const VibratingScene& scene, const std::vector<Place>& pushed, KeptTies& last)
    : scene_(&scene), rows_(rows_of(scene)), ties_(ties_of(scene, rows_)) {
  place_.assign(static_cast<std::size_t>(rows_.size / 6), -1);
  const auto keep = [&](Index row) { place_[static_cast<std::size_t>(row / 6)] = 0; };
  for (const std::vector<Tied>* const all : {&ties_.held, &ties_.elastic})
    for (const Tied& of : *all)
      for (const auto& part : of.gap.parts) keep(part.first);
  for (const Place& at : pushed)
    if (at.member != ground) keep(followed_by(scene, rows_, at).row);
  for (Index row = rows_.bodies; row < rows_.size; row += 6) keep(row);
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const std::size_t nodes = scene.beams[b].beam->nodes().size();
    const Index last_row = rows_.beams[b] + static_cast<Index>(6 * (nodes - 1));
    keep(rows_.beams[b]);
    keep(last_row);
    std::vector<bool>& kept = kept_.emplace_back(nodes);
    for (std::size_t i = 0; i < nodes; ++i)
      kept[i] = place_[static_cast<std::size_t>(rows_.beams[b] / 6) + i] == 0;
  }
  for (Index& place : place_) {
    if (place < 0) continue;
    place = size_;
    size_ += 6;
  }

  norms_ = VectorXd::Ones(static_cast<Index>(ties_.held.size()));
  MatrixSum holding;
  for (std::size_t k = 0; k < ties_.held.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const auto scaled = [&](Vector6 per) {
      per.head<3>() *= ties_.length;
      return per;
    };
    double square = 0.0;
    for (const auto& part : ties_.held[k].gap.parts) square += scaled(part.second).squaredNorm();
    // Of the ground alone: nothing moves.
    if (square > 0.0) norms_[column] = std::sqrt(square);
    // Also what is zero in this posture alone: the same entries in all of them. Couples hold no
    // shifts in any.
    for (const auto& [row, per] : ties_.held[k].gap.parts) {
      const Vector6 entries = scaled(per) / norms_[column];
      const Index at = kept_row(row), first = entries.head<3>().isZero(0.0) ? 3 : 0;
      for (Index i = first; i < 6; ++i) holding.entries.emplace_back(at + i, column, entries[i]);
    }
  }
  rigidly_.emplace(holding.of_size(size_, norms_.size()), last);
}

MatrixSum HeldScene::elastic_ties() const {
  MatrixSum sum;
  for (const Tied& of : ties_.elastic) {
    if (of.tie->stiffness == 0.0) continue;
    for (const auto& [row, per_row] : of.gap.parts)
      for (const auto& [column, per_column] : of.gap.parts)
        sum.add(kept_row(row), kept_row(column),
                of.tie->stiffness * per_row * per_column.transpose());
  }
  return sum;
}

MatrixXd HeldScene::on_kept(const MatrixXd& forces) const {
  MatrixXd kept(size_, forces.cols());
  for (std::size_t i = 0; i < place_.size(); ++i) {
    if (place_[i] < 0) continue;
    auto there = kept.middleRows<6>(place_[i]);
    there = forces.middleRows<6>(static_cast<Index>(6 * i));
    there.topRows<3>() *= ties_.length;
  }
  return kept;
}

VectorXd HeldScene::tie_forces(const VectorXd& on_coordinates) const {
  return rigidly_->forces(on_kept(on_coordinates)).cwiseQuotient(norms_);
}

std::optional<StandingScene> HeldScene::standing(const SceneStiffness& stiffness,
                                                 const MatrixXd& holding) const {
  StandingScene of(*this);
  MatrixSum sum = stiffness.beside;
  const double square = ties_.length * ties_.length;
  for (std::size_t b = 0; b < kept_.size(); ++b) {
    for (const VibratingBeam::Matrix12& piece : stiffness.pieces[b])
      for (Index k = 0; k < 12; ++k)
        of.stiffest_ = std::max(of.stiffest_, piece(k, k) * (k % 6 < 3 ? square : 1.0));
    auto chain = CondensedChain::of(stiffness.pieces[b], kept_[b]);
    if (!chain) return {};
    const auto first = static_cast<std::size_t>(rows_.beams[b] / 6);
    for (const CondensedChain::Stretch& stretch : chain->stretches()) {
      const std::array<Index, 2> ends{place_[first + stretch.from], place_[first + stretch.to]};
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 2; ++k)
          sum.add(
              ends[i], ends[k],
              stretch.stiffness.block<6, 6>(static_cast<Index>(6 * i), static_cast<Index>(6 * k)));
    }
    of.chains_.push_back(std::move(*chain));
  }
  for (Eigen::Triplet<double>& entry : sum.entries)
    entry = {entry.row(), entry.col(),
             entry.value() * unit_of_row(entry.row(), ties_.length) *
                 unit_of_row(entry.col(), ties_.length)};
  MatrixXd left = rigidly_->reduced(sum.of_size(size_, size_));
  if (holding.cols() > 0) {
    const MatrixXd held = rigidly_->on_free(on_kept(holding)).colwise().normalized();
    left += of.stiffest_ * held * held.transpose();
  }
  of.factor_.compute(left);
  if (of.factor_.info() != Eigen::Success) return {};
  if (left.size() > 0) {
    const double largest = left.cwiseAbs().colwise().sum().maxCoeff();
    if (!(of.factor_.rcond() * largest > round_off * of.stiffest_)) return {};
  }
  return of;
}

MatrixXd StandingScene::moved_by(MatrixXd forces) const {
  const HeldScene& held = *held_;
  const auto beam_rows = [&](std::size_t b) {
    return forces.middleRows(held.rows_.beams[b], rows_of_nodes(held.scene_->beams[b]));
  };
  for (std::size_t b = 0; b < chains_.size(); ++b) chains_[b].carry_to_kept(beam_rows(b));
  const MatrixXd kept =
      held.rigidly_->motions(factor_.solve(held.rigidly_->on_free(held.on_kept(forces))));
  for (std::size_t i = 0; i < held.place_.size(); ++i) {
    if (held.place_[i] < 0) continue;
    auto here = forces.middleRows<6>(static_cast<Index>(6 * i));
    here = kept.middleRows<6>(held.place_[i]);
    here.topRows<3>() *= held.ties_.length;
  }
  for (std::size_t b = 0; b < chains_.size(); ++b) chains_[b].move_between(beam_rows(b));
  return forces;
}

}  // namespace boxbeam::frame
