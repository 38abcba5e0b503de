#include "src/mechanism/frame/held_scene.hpp"

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "catch.hpp"

namespace condensed_chain_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using frame::CondensedChain;
using Matrix12 = CondensedChain::Matrix12;

namespace {

/// Pieces without any order; the least eigenvalue of each by `least`.
std::vector<Matrix12> some_pieces(std::size_t count, double least, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<Matrix12> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    Matrix12 root = Matrix12::NullaryExpr([&](Index, Index) { return any(random); });
    pieces.push_back(root * root.transpose() + least * Matrix12::Identity());
  }
  return pieces;
}

MatrixXd whole_of(const std::vector<Matrix12>& pieces) {
  const auto size = static_cast<Index>(6 * (pieces.size() + 1));
  MatrixXd whole = MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    whole.block<12, 12>(static_cast<Index>(6 * i), static_cast<Index>(6 * i)) += pieces[i];
  return whole;
}

std::vector<bool> some_kept(std::size_t pieces, std::mt19937& random) {
  std::vector<bool> kept(pieces + 1);
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = random() % 3 == 0;
  kept.front() = kept.back() = true;
  return kept;
}

/// Of the stretches at the kept nodes.
MatrixXd left_of(const CondensedChain& chain, const std::vector<bool>& kept) {
  std::vector<Index> row(kept.size(), -1);
  Index size = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    row[i] = size;
    size += 6;
  }
  MatrixXd left = MatrixXd::Zero(size, size);
  for (const CondensedChain::Stretch& stretch : chain.stretches()) {
    REQUIRE(row[stretch.from] + 6 == row[stretch.to]);
    left.block<12, 12>(row[stretch.from], row[stretch.from]) += stretch.stiffness;
  }
  return left;
}

}  // namespace

// Independent: the whole matrix, dense.
TEST_CASE("a condensed chain moves as the whole one does", "[frame][condensed]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (const std::size_t count : {1U, 2U, 5U, 17U, 40U}) {
    const std::vector<Matrix12> pieces = some_pieces(count, 0.1, random);
    const std::vector<bool> kept = some_kept(count, random);
    const MatrixXd whole = whole_of(pieces);
    const auto chain = CondensedChain::of(pieces, kept);
    REQUIRE(chain);
    const MatrixXd forces =
        MatrixXd::NullaryExpr(whole.rows(), 3, [&](Index, Index) { return any(random); });
    const MatrixXd expected = whole.ldlt().solve(forces);
    MatrixXd found = forces;
    chain->carry_to_kept(found);
    std::vector<Index> rows;
    for (std::size_t i = 0; i < kept.size(); ++i)
      for (Index k = 0; kept[i] && k < 6; ++k) rows.push_back(static_cast<Index>(6 * i) + k);
    const MatrixXd left = left_of(*chain, kept);
    const MatrixXd at_kept = left.ldlt().solve(MatrixXd(found(rows, Eigen::all)));
    found(rows, Eigen::all) = at_kept;
    chain->move_between(found);
    CAPTURE(count);
    CHECK((found - expected).norm() < 1e-10 * expected.norm());
  }
}

// Haynsworth: the whole matrix has a negative eigenvalue where a node between or what is left has.
TEST_CASE("a chain is refused or left without stiffness where the whole one buckles",
          "[frame][condensed]") {
  std::mt19937 random(2);
  int standing = 0, between = 0, left = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::size_t count = 2 + random() % 6;
    std::vector<Matrix12> pieces = some_pieces(count, 0.0, random);
    for (Matrix12& piece : pieces)
      piece -= (random() % 2 == 0 ? 0.0 : 0.02 * static_cast<double>(random() % 60)) *
               Matrix12::Identity();
    const std::vector<bool> kept = some_kept(count, random);
    const auto least = [](const MatrixXd& of) {
      return Eigen::SelfAdjointEigenSolver<MatrixXd>(of).eigenvalues()[0];
    };
    const auto chain = CondensedChain::of(pieces, kept);
    const bool stands = chain && least(left_of(*chain, kept)) > 0.0;
    CHECK(stands == (least(whole_of(pieces)) > 0.0));
    (stands ? standing : chain ? left : between) += 1;
  }
  CAPTURE(standing, between, left);
  CHECK(std::min({standing, between, left}) > 20);
}

}  // namespace condensed_chain_test
