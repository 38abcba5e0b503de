// Functions kept as polynomials on pieces, against the functions themselves.

#include "boxbeam/numerics/chebyshev_curve.hpp"

#include <cmath>

#include "catch.hpp"

namespace chebyshev_curve_test {

using boxbeam::ChebyshevCurve;

namespace {

ChebyshevCurve::Accuracy everywhere(double allowed) {
  return [allowed](const Eigen::VectorXd& largest) -> Eigen::VectorXd { return allowed * largest; };
}

}  // namespace

// Nine points determine a polynomial of eighth degree.
TEST_CASE("a polynomial of eighth degree needs one piece", "[numerics]") {
  const auto f = [](double x) {
    return Eigen::Vector2d(std::pow(x, 8) - 3.0 * x * x, 1.0 - std::pow(x, 7));
  };
  const ChebyshevCurve curve(f, {{-1.0, 2.0}, 3.0, 0.01}, [](const Eigen::VectorXd& largest) {
    return Eigen::VectorXd::Constant(largest.size(), 1e9);
  });
  CHECK(curve.pieces() == 1);
  for (const double x : {-1.0, -0.37, 0.0, 0.5, 1.99, 2.0}) {
    CHECK((curve.at(x) - f(x)).norm() < 1e-11 * 256.0);
  }
}

TEST_CASE("pieces are halved until waves are followed, where they are", "[numerics]") {
  // Fast on the left only.
  const auto f = [](double x) {
    return Eigen::VectorXd::Constant(1, std::sin(40.0 * std::exp(-x) * x));
  };
  const ChebyshevCurve curve(f, {{0.0, 8.0}, 8.0, 1e-3}, everywhere(1e-6));
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i)
    worst = std::max(worst, std::abs(curve.at(0.008 * i)[0] - f(0.008 * i)[0]));
  CHECK(worst < 1e-5);
  CHECK(curve.pieces() > 4);
  CHECK(curve.shortest_piece() < 0.6);
}

TEST_CASE("jumps and bends at borders cost nothing, and no border is asked", "[numerics]") {
  int asked = 0;
  const auto f = [&](double x) {
    ++asked;
    CHECK(x != 0.0);
    CHECK(x != 0.3);
    CHECK(x != 1.0);
    return Eigen::Vector2d(x < 0.3 ? 1.0 : 7.0, std::abs(x - 0.3));
  };
  const ChebyshevCurve curve(f, {{0.0, 0.3, 1.0}, 1.0, 1e-3}, everywhere(1e-9));
  CHECK(curve.pieces() == 2);
  CHECK(asked == 18);
  CHECK(curve.at(0.3)[0] == Approx(7.0));
  CHECK(curve.at(0.3 - 1e-9)[0] == Approx(1.0));
  CHECK(curve.at(0.8)[1] == Approx(0.5));
  CHECK(curve.largest()[0] == Approx(7.0));
}

// Of a jump between borders the shortest piece is the end.
TEST_CASE("what no polynomial describes is divided down to the shortest piece", "[numerics]") {
  const auto f = [](double x) { return Eigen::VectorXd::Constant(1, x < 0.313 ? 0.0 : 1.0); };
  const ChebyshevCurve curve(f, {{0.0, 1.0}, 1.0, 0.01}, everywhere(1e-6));
  CHECK(curve.shortest_piece() < 0.02);
  CHECK(curve.pieces() < 20);
  CHECK(curve.at(0.2)[0] == Approx(0.0).margin(1e-12));
  CHECK(curve.at(0.6)[0] == Approx(1.0));
}

TEST_CASE("a mapped curve is the map of the curve, at points and between", "[numerics]") {
  const auto f = [](double x) { return Eigen::Vector2d(std::sin(x), std::exp(-x)); };
  const ChebyshevCurve curve(f, {{0.0, 1.0, 4.0}, 1.0, 0.1}, everywhere(1e-9));
  Eigen::Matrix<double, 3, 2> by;
  by << 2.0, 0.0, 1.0, -3.0, 0.0, 0.5;
  const ChebyshevCurve mapped = curve.mapped(by);
  CHECK(mapped.pieces() == curve.pieces());
  CHECK(mapped.largest().size() == 3);
  for (int i = 0; i <= 400; ++i)
    CHECK((mapped.at(0.01 * i) - by * curve.at(0.01 * i)).norm() < 1e-14);
}

}  // namespace chebyshev_curve_test
