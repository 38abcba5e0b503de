#include "src/mechanism/frame/lowest_modes.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "catch.hpp"

namespace lowest_modes_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// A stiffness, and a mass with these mu of M x = mu K x.
struct Problem {
  MatrixXd K, M;
  VectorXd scale;
  double mu_of_first;

  Problem(const VectorXd& mu, unsigned seed) : mu_of_first(mu[0]) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const Index size = mu.size();
    const auto matrix = [&] {
      return MatrixXd::NullaryExpr(size, size, [&](Index, Index) { return any(random); }).eval();
    };
    const MatrixXd root = 0.2 * matrix() + 3.0 * MatrixXd::Identity(size, size);
    const MatrixXd turn = Eigen::HouseholderQR<MatrixXd>(matrix()).householderQ();
    K = root * root.transpose();
    M = root * turn * mu.asDiagonal() * turn.transpose() * root.transpose();
    scale = VectorXd::NullaryExpr(size, [&](Index) { return std::exp(any(random)); });
  }

  /// What rounding of the entries of K and M may do to mu, by Weyl's theorem.
  double by_rounding() const {
    const double least = Eigen::SelfAdjointEigenSolver<MatrixXd>(K).eigenvalues()[0];
    return std::numeric_limits<double>::epsilon() * (M.norm() + mu_of_first * K.norm()) / least;
  }

  frame::LowestModes lowest(Index count) const {
    const Eigen::LLT<MatrixXd> factor(K);
    return frame::lowest_modes_of({[&](const MatrixXd& f) -> MatrixXd { return factor.solve(f); },
                                   [&](const MatrixXd& x) -> MatrixXd { return M * x; }},
                                  count, scale);
  }
};

/// Against all modes, of which the problem was made to round-off.
void check(const VectorXd& mu, Index count, Index expected) {
  const Problem of(mu, 7);
  const frame::LowestModes found = of.lowest(count);
  REQUIRE(found.mu.size() == expected);
  for (Index k = 0; k < expected; ++k) {
    CAPTURE(k, mu.size());
    CHECK(std::abs(found.mu[k] - mu[k]) <= 1e-11 * mu[k] + of.by_rounding());
    const VectorXd x = found.modes.col(k);
    CHECK((of.M * x - mu[k] * of.K * x).norm() <=
          (1e-9 * mu[k] + of.by_rounding()) * (of.K * x).norm());
    for (Index i = 0; i <= k; ++i)
      CHECK(found.modes.col(i).dot(of.K * x) == Approx(i == k ? 1.0 : 0.0).margin(1e-10));
  }
}

}  // namespace

TEST_CASE("the lowest modes are those of all modes", "[frame][modes]") {
  // As of beams, as 1/n^4 and, stiffer, as 1/n^2.
  VectorXd mu(60);
  for (Index n = 0; n < 60; ++n) {
    const auto number = static_cast<double>(n + 1);
    mu[n] = n < 30 ? std::pow(number, -4) : 1e-7 / number;
  }
  for (const Index count : {1, 3, 6, 12}) check(mu, count, count);
  // All there are.
  check(mu.head(5), 5, 5);
  check(mu.head(5), 9, 5);
}

TEST_CASE("modes of one frequency are all found", "[frame][modes]") {
  VectorXd mu(40);
  for (Index n = 0; n < 40; ++n)
    mu[n] = n < 12 ? 1.0 : n < 26 ? 0.98 : 0.5 / static_cast<double>(n + 1);
  for (const Index count : {1, 4, 13, 20}) check(mu, count, count);
}

TEST_CASE("what has no mass has no modes", "[frame][modes]") {
  VectorXd mu = VectorXd::Zero(30);
  mu.head<4>() << 3.0, 1e-3, 1e-6, 1e-8;
  check(mu, 2, 2);
  check(mu, 8, 4);
  check(VectorXd::Zero(10), 3, 0);
}

}  // namespace lowest_modes_test
