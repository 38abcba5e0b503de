// Factors of symmetric matrices against their eigenvalues and their own products.

#include "boxbeam/mechanism/flexible/symmetric_factor.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <random>

#include "catch.hpp"

namespace symmetric_factor_test {

using boxbeam::flexible::SymmetricFactor;
using Complex = std::complex<double>;

namespace {

/// Of a structure and its joints: entries of one sign first, then a corner of zeros, or any.
template <class Scalar>
Eigen::Matrix<Scalar, -1, -1> random_symmetric(std::mt19937& random, Eigen::Index size) {
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::bernoulli_distribution none(std::uniform_real_distribution<double>(0.0, 0.8)(random));
  Eigen::Matrix<Scalar, -1, -1> matrix(size, size);
  const Eigen::Index corner = std::uniform_int_distribution<Eigen::Index>(0, size / 2)(random);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      Scalar of(none(random) ? 0.0 : part(random));
      if constexpr (std::is_same_v<Scalar, Complex>) of += Complex(0.0, 0.1 * part(random));
      if (j >= size - corner) of = Scalar(0.0);
      matrix(i, j) = matrix(j, i) = of;
    }
  }
  return matrix;
}

template <class Scalar>
void require_solves() {
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    const Eigen::Index size = 1 + round % 40;
    const auto matrix = random_symmetric<Scalar>(random, size);
    SymmetricFactor<Scalar> factor;
    factor.compute(matrix);
    if (factor.condition() < 1e-9) continue;  // singular, or nearly
    const Eigen::Matrix<Scalar, -1, 1> x = Eigen::Matrix<Scalar, -1, 1>::Random(size);
    const Eigen::Matrix<Scalar, -1, 1> right = matrix * x;
    const Eigen::Matrix<Scalar, -1, 1> found = factor.solve(right);
    INFO("round " << round << ", " << size << " rows");
    // Backward stable: what is left over is round-off of the matrix times the solution.
    const double left = (matrix * found - right).norm();
    CHECK(left <= 1e-13 * static_cast<double>(size) * matrix.norm() * found.norm());
  }
}

}  // namespace

TEST_CASE("Factors of symmetric matrices solve", "[flexible]") {
  require_solves<double>();
  require_solves<Complex>();
}

TEST_CASE("As many pivots are below zero as eigenvalues", "[flexible]") {
  std::mt19937 random(11);
  for (int round = 0; round < 400; ++round) {
    const Eigen::Index size = 1 + round % 40;
    Eigen::MatrixXd matrix = random_symmetric<double>(random, size);
    if (round % 3 == 0) matrix.diagonal().array() += 1.0;
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
            .eigenvalues();
    if (values.cwiseAbs().minCoeff() < 1e-10) continue;  // of either sign, by round-off
    SymmetricFactor<double> factor;
    factor.compute(matrix);
    INFO("round " << round << ", " << size << " rows");
    CHECK(factor.negative() == static_cast<std::size_t>((values.array() < 0.0).count()));
  }
}

TEST_CASE("The condition of a factor tells singular matrices", "[flexible]") {
  std::mt19937 random(13);
  SymmetricFactor<double> factor;
  factor.compute(Eigen::MatrixXd::Zero(3, 3));
  CHECK(factor.condition() == 0.0);
  CHECK(factor.negative() == 0);
  for (int round = 0; round < 100; ++round) {
    const Eigen::Index size = 2 + round % 20;
    Eigen::MatrixXd matrix = random_symmetric<double>(random, size);
    // The last row is the sum of the others.
    const Eigen::Index rest = size - 1;
    matrix.row(rest).head(rest) = matrix.topLeftCorner(rest, rest).colwise().sum();
    matrix.col(rest).head(rest) = matrix.row(rest).head(rest).transpose();
    matrix(rest, rest) = matrix.row(rest).head(rest).sum();
    factor.compute(matrix);
    CHECK(factor.condition() < 1e-13);
  }
  factor.compute(Eigen::MatrixXd(0, 0));
  CHECK(factor.condition() == 0.0);
}

}  // namespace symmetric_factor_test
