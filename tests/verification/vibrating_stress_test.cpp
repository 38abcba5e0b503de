// What modes left out miss, by the places that may be the worst, against all places at all times.

#include "boxbeam/verification/vibrating_stress.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "support/property.hpp"
#include "support/random_frame.hpp"

namespace vibrating_stress_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::MatrixXd;

// Exhaustive: the stresses of all places at all times, added up mode by mode.
TEST_CASE("no place is worse than what modes are said to miss", "[vibration]") {
  test::holds([] {
    const test::Dice dice;
    const auto random = [&](Index rows, Index columns, double size) -> MatrixXd {
      MatrixXd of(rows, columns);
      for (double& value : of.reshaped()) value = dice.between(-size, size);
      return of;
    };
    const Index modes = 1 + dice.upto(5), times = 2 + dice.upto(40), places = 1 + dice.upto(60);
    MatrixXd parts = random(times, modes, 1.0);
    for (Index j = 0; j < modes; ++j) parts.col(j) *= std::pow(dice.between(0.01, 3.0), 2);
    if (dice.one_in(3)) parts.array() += 5.0;
    const MatrixXd stresses = random(modes, places, 1e6);
    const double peak = dice.between(1e5, 1e7), range = dice.one_in(4) ? 0.0 : 0.7 * peak;
    const std::vector<double> missed = missed_without(parts, stresses, peak, range);
    RC_ASSERT(missed.size() == static_cast<std::size_t>(modes) + 1);
    RC_ASSERT(missed.back() == 0.0);
    MatrixXd beside = MatrixXd::Zero(times, places);
    for (Index j = modes; j-- > 0;) {
      beside += parts.col(j) * stresses.row(j);
      const double by_range = range > 0.0 ? largest_range(beside) / range : 0.0;
      const double most = std::max(beside.cwiseAbs().maxCoeff() / peak, by_range);
      RC_ASSERT(std::abs(missed[static_cast<std::size_t>(j)] - most) <= 1e-12 * most);
    }
  });
}

TEST_CASE("modes without bound miss without bound, with all that are counted before them",
          "[vibration]") {
  MatrixXd parts = MatrixXd::Constant(4, 3, 1e-3);
  parts(2, 1) = std::numeric_limits<double>::infinity();
  const MatrixXd stresses = MatrixXd::Identity(3, 3);
  CHECK(missed_without(parts, stresses, 1.0, 1.0) == std::vector<double>{1e6, 1e6, 1e-3, 0.0});
}

}  // namespace vibrating_stress_test
