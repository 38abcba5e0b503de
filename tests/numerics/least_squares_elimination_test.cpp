// Least squares and shortest solutions of sparse systems against Eigen's QR, and the estimate of
// the smallest singular value against its SVD.

#include "boxbeam/numerics/least_squares_elimination.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <random>

#include "catch.hpp"

namespace least_squares_elimination_test {

using namespace boxbeam;

namespace {

struct Tall {
  SparsePattern pattern;
  std::vector<double> values;
  Eigen::VectorXd row_scale, col_scale;

  Eigen::MatrixXd scaled() const {
    return row_scale.asDiagonal() * pattern.dense(values) * col_scale.asDiagonal();
  }
};

/// A random matrix of rank `cols` with `more` rows, a third of its entries and uneven scales.
Tall random_tall(Eigen::Index cols, Eigen::Index more, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Tall tall;
  tall.pattern.rows = cols + more;
  tall.pattern.cols = cols;
  tall.row_scale =
      Eigen::VectorXd::NullaryExpr(cols + more, [&] { return std::exp(3.0 * uniform(random)); });
  tall.col_scale =
      Eigen::VectorXd::NullaryExpr(cols, [&] { return std::exp(3.0 * uniform(random)); });
  for (Eigen::Index r = 0; r < cols + more; ++r) {
    tall.pattern.row_start.push_back(static_cast<int>(tall.pattern.col.size()));
    for (Eigen::Index c = 0; c < cols; ++c) {
      if (c != r && uniform(random) < 0.4) continue;
      const double entry = uniform(random) + (c == r ? 2.0 : 0.0);
      tall.pattern.col.push_back(static_cast<int>(c));
      tall.values.push_back(entry / (tall.row_scale[r] * tall.col_scale[c]));
    }
  }
  tall.pattern.row_start.push_back(static_cast<int>(tall.pattern.col.size()));
  return tall;
}

}  // namespace

TEST_CASE("least squares and shortest solutions equal those of QR") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Tall tall = random_tall(4 + trial % 9, 1 + trial % 5, random);
    const Eigen::Index rows = tall.pattern.rows;
    const Eigen::Index cols = tall.pattern.cols;
    LeastSquaresElimination elimination(tall.pattern, tall.row_scale, tall.col_scale);
    REQUIRE(elimination.factor(tall.values));
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> qr(tall.scaled());
    const Eigen::VectorXd b = Eigen::VectorXd::Random(rows).cwiseQuotient(tall.row_scale);
    const Eigen::VectorXd f = Eigen::VectorXd::Random(cols).cwiseQuotient(tall.col_scale);
    Eigen::VectorXd x(cols), y(rows);
    elimination.solve(b, x);
    elimination.solve_transposed(f, y);
    const Eigen::VectorXd by_qr = qr.solve(tall.row_scale.cwiseProduct(b));
    CHECK((x.cwiseQuotient(tall.col_scale) - by_qr).norm() < 1e-11 * (1.0 + by_qr.norm()));
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> wide(tall.scaled().transpose());
    const Eigen::VectorXd shortest = wide.solve(tall.col_scale.cwiseProduct(f));
    CHECK((y.cwiseQuotient(tall.row_scale) - shortest).norm() < 1e-11 * (1.0 + shortest.norm()));
    const double smallest =
        Eigen::JacobiSVD<Eigen::MatrixXd>(tall.scaled()).singularValues().minCoeff();
    CHECK(elimination.smallest_singular_value() >= 0.99 * smallest);
    CHECK(elimination.smallest_singular_value() < 30.0 * smallest);
  }
}

TEST_CASE("columns that depend on each other are refused, and the next matrix is not affected") {
  std::mt19937 random(8);
  const Tall tall = random_tall(5, 3, random);
  LeastSquaresElimination elimination(tall.pattern, tall.row_scale, tall.col_scale);
  Tall dependent = tall;
  for (std::size_t e = 0; e < dependent.values.size(); ++e) {
    if (dependent.pattern.col[e] == 3) dependent.values[e] = 0.0;
  }
  CHECK_FALSE(elimination.factor(dependent.values));
  CHECK_FALSE(elimination.factor(dependent.values));  // nor does it get used to it
  CHECK(elimination.factor(tall.values));
}

}  // namespace least_squares_elimination_test
