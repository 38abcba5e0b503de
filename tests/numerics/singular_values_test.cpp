// The smallest singular values of sparse matrices: the iteration against the SVD of the whole
// matrix, and against matrices whose values and null vectors are known by their making.

#include "boxbeam/numerics/singular_values.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "catch.hpp"

namespace singular_values_test {

using namespace boxbeam;

namespace {

/// A band of random entries; `repeated` columns are sums of two others, up to `noise`.
Eigen::SparseMatrix<double> random_band(Eigen::Index rows, Eigen::Index cols, int repeated,
                                        double noise, std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows, cols);
  for (Eigen::Index c = 0; c < cols; ++c) {
    const Eigen::Index middle = c * rows / cols;
    for (Eigen::Index r = std::max<Eigen::Index>(0, middle - 3); r < std::min(rows, middle + 4);
         ++r)
      dense(r, c) = entry(random);
    dense(middle, c) += 3.0;
  }
  for (int k = 0; k < repeated; ++k) {
    const Eigen::Index c = 5 + 7 * k;
    dense.col(c) = dense.col(c - 1) + dense.col(c + 1);
    dense(c, c) += noise;
  }
  return dense.sparseView();
}

}  // namespace

TEST_CASE("small singular values and their vectors are those of the whole SVD") {
  std::mt19937 random(11);
  for (const double noise : {0.0, 1e-12, 1e-8, 1e-6, 1e-3}) {
    for (const int repeated : {0, 1, 3, 12}) {
      for (const Eigen::Index more : {-4, 0, 6}) {
        CAPTURE(noise, repeated, more);
        const Eigen::SparseMatrix<double> A = random_band(160 + more, 160, repeated, noise, random);
        const SingularValues found = smallest_singular_values(A, 1e-5, 0);
        const SingularValues whole = smallest_singular_values(A, 1e-5, 1000);
        REQUIRE(found.smallest.size() == whole.smallest.size());
        CHECK(found.largest == Approx(whole.largest).epsilon(1e-5));
        for (Eigen::Index i = 0; i < found.smallest.size(); ++i) {
          const bool next_above = i == 0 && found.smallest.size() > 1;
          CHECK(found.smallest[i] == Approx(whole.smallest[i])
                                         .epsilon(next_above ? 1e-3 : 1e-6)
                                         .margin(1e-13 * whole.largest));
        }
        // The space of those that do not count: each whole vector lies in the found ones.
        const Eigen::Index none = found.smallest.size() - 1;
        if (none == 0) continue;
        const Eigen::MatrixXd in = found.vectors.rightCols(none);
        const Eigen::MatrixXd other = whole.vectors.rightCols(none);
        CHECK((in * (in.transpose() * other) - other).norm() <= 1e-8);
        CHECK((A * in).colwise().norm().maxCoeff() <= 1e-5 * whole.largest + 1e-13);
      }
    }
  }
}

TEST_CASE("a long chain has the values of its closed form") {
  // Differences of neighbours, both ends held: singular values 2 cos(k pi/(2(n + 1))).
  const Eigen::Index n = 3000;
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1.0);
    entries.emplace_back(i + 1, i, -1.0);
  }
  Eigen::SparseMatrix<double> A(n + 1, n);
  A.setFromTriplets(entries.begin(), entries.end());
  const SingularValues of = smallest_singular_values(A, 1e-5);
  const double step = 0.5 * std::numbers::pi / static_cast<double>(n + 1);
  CHECK(of.largest == Approx(2.0 * std::cos(step)).epsilon(1e-5));
  REQUIRE(of.smallest.size() == 1);
  CHECK(of.smallest[0] == Approx(2.0 * std::sin(step)).epsilon(1e-8));
  // The first dozen as well, and the one behind them.
  const SingularValues dozen =
      smallest_singular_values(A, 2.0 * std::sin(12.5 * step) / of.largest);
  REQUIRE(dozen.smallest.size() == 13);
  for (Eigen::Index k = 0; k < 13; ++k)
    CHECK(dozen.smallest[12 - k] ==
          Approx(2.0 * std::sin(static_cast<double>(k + 1) * step)).epsilon(1e-7));
  // Neither end held: one sum that differences do not see.
  const SingularValues free = smallest_singular_values(A.transpose(), 1e-5);
  REQUIRE(free.smallest.size() == 2);
  CHECK(free.smallest[1] <= 1e-13);
  CHECK((free.vectors.col(1).cwiseAbs().array() * std::sqrt(static_cast<double>(n + 1)) - 1.0)
            .abs()
            .maxCoeff() <= 1e-8);
}

namespace {

/// The equations of pins between bodies of the plane in a random posture, each row of length one,
/// and a few bodies held in angle: rows for x and y of each pin, columns for x, y, angle of each
/// body. `pins` of them join two bodies or a body and the ground.
Eigen::SparseMatrix<double> random_mechanism(int bodies, int pins, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  std::uniform_int_distribution<int> any(-1, bodies - 1), some(0, bodies - 1);
  std::vector<Eigen::Triplet<double>> entries;
  int row = 0;
  const auto add = [&](int body, double sign) {
    if (body < 0) return;
    entries.emplace_back(row, 3 * body, sign);
    entries.emplace_back(row, 3 * body + 2, sign * place(random));
    entries.emplace_back(row + 1, 3 * body + 1, sign);
    entries.emplace_back(row + 1, 3 * body + 2, sign * place(random));
  };
  for (int pin = 0; pin < pins; ++pin, row += 2) {
    // A tree first, so that the mechanism hangs together.
    const int b = pin < bodies ? pin : some(random);
    int a = pin < bodies ? pin - 1 : any(random);
    if (a == b) a = -1;
    add(a, -1.0);
    add(b, 1.0);
  }
  for (int held = 0; held < bodies; ++held, ++row) entries.emplace_back(row, 3 * held + 2, 1.0);
  Eigen::SparseMatrix<double> A(row, 3 * bodies);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

}  // namespace

// Independent computation: Jacobi's SVD of the whole matrix.
TEST_CASE("of random mechanisms the smallest value is within its bound of that of the SVD") {
  std::mt19937 random(29);
  std::uniform_int_distribution<int> bodies_of(8, 24), more(0, 5);
  int single = 0;
  for (int k = 0; k < 250; ++k) {
    const int bodies = bodies_of(random);
    Eigen::SparseMatrix<double> A = random_mechanism(bodies, bodies + more(random), random);
    if (k % 5 == 4) {  // a body that nothing but noise holds
      const double noise = std::pow(10.0, -3.0 - k % 7);
      for (Eigen::Index c = 0; c < 3; ++c) {
        for (Eigen::SparseMatrix<double>::InnerIterator at(A, c); at; ++at) at.valueRef() *= noise;
      }
    }
    CAPTURE(k, bodies);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd{Eigen::MatrixXd(A)};
    const Eigen::VectorXd& values = svd.singularValues();
    const SingularValues found = smallest_singular_values(A, 1e-5, 0);
    CHECK(found.largest == Approx(values[0]).epsilon(5e-6));
    const double last = values[values.size() - 1];
    CHECK(found.smallest[found.smallest.size() - 1] ==
          Approx(last).epsilon(1e-8).margin(1e-13 * values[0]));
    const Eigen::Index counted =
        (values.array() > 1e-5 * values[0]).count() - 1;  // those above but the last of them
    CHECK(found.smallest.size() == values.size() - counted);
    single += found.smallest.size() == 1 ? 1 : 0;
    const Eigen::VectorXd vector = found.vectors.rightCols<1>();
    CHECK(vector.norm() == Approx(1.0));
    CHECK((A * vector).norm() == Approx(last).epsilon(1e-6).margin(1e-12 * values[0]));
  }
  CHECK(single > 150);
}

}  // namespace singular_values_test
