// What modes add to what strains a body once, against the closed forms of one oscillator.

#include "src/verification/strained_once.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace strained_once_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

Eigen::VectorXd allowed(const Eigen::VectorXd& largest) { return 1e-9 * largest; }

/// Two cut forces, of which the work on the mode is that of one.
Eigen::VectorXd straining(double size) { return Eigen::Vector2d(size, 2.0 * size); }
const Eigen::MatrixXd work = Eigen::RowVector2d(0.5, 0.25);

}  // namespace

// eta - p/omega^2 = -cos(omega t)/omega^2 of a load that acts at once.
TEST_CASE("a sudden straining adds as much again", "[transient]") {
  const double f = 1.9, square = std::pow(2.0 * pi * f, 2);
  const StrainedOnce of(
      {0.0, 1.0, 64, {0.0, 1.0}, true, true},
      [](double time) { return straining(time < 0.0 ? 0.0 : 1.0); }, allowed);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(1),
                        frequency = Eigen::VectorXd::Constant(1, f);
  const Eigen::MatrixXd parts = of.dynamic_parts(work, frequency, none);
  CHECK(parts(0, 0) == Approx(-1.0 / square));
  CHECK(parts.cwiseAbs().maxCoeff() == Approx(1.0 / square).epsilon(1e-6));
  // A period and a half behind it as well.
  CHECK(parts(parts.rows() - 1, 0) ==
        Approx(-std::cos(2.0 * pi * f * (1.0 + 1.5 / f)) / square).epsilon(1e-5));
}

TEST_CASE("what grows evenly and has done so before adds nothing", "[transient]") {
  const StrainedOnce of(
      {1.0, 2.0, 64, {1.0, 3.0}, false, false},
      [](double time) { return straining(0.2 + 0.7 * time); }, allowed);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(1),
                        frequency = Eigen::VectorXd::Constant(1, 1.3);
  CHECK(of.dynamic_parts(work, frequency, none).cwiseAbs().maxCoeff() < 1e-9);
}

}  // namespace strained_once_test
