#include "boxbeam/strength/taper.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace taper_test {

using namespace boxbeam;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// sigma_r r/P of a wedge of unit thickness, P across its tip.
double radial_stress(double alpha, double theta) {
  return 2.0 * std::sin(theta) / (2.0 * alpha - std::sin(2.0 * alpha));
}

}  // namespace

TEST_CASE("wedge: the exact radial stresses balance the force and leave no thrust") {
  for (const double alpha : {2 * degree, 10 * degree, 30 * degree}) {
    double across = 0.0, along = 0.0;
    constexpr int steps = 2000;
    for (int k = 0; k < steps; ++k) {
      const double theta = alpha * (2.0 * (k + 0.5) / steps - 1.0);
      const double width = 2.0 * alpha / steps;
      across += radial_stress(alpha, theta) * std::sin(theta) * width;
      along += radial_stress(alpha, theta) * std::cos(theta) * width;
    }
    CHECK(across == Approx(1.0).epsilon(1e-6));
    CHECK(std::abs(along) < 1e-12);
  }
}

TEST_CASE("wedge: M/W over the exact edge stress, by its parts") {
  for (double alpha = 0.5 * degree; alpha < 45 * degree; alpha += 0.5 * degree) {
    // At x = 1: depth 2 tan(alpha), M = P, the edge at r = 1/cos(alpha).
    const double depth = 2.0 * std::tan(alpha);
    const double beam = 6.0 / (depth * depth);
    const double exact = radial_stress(alpha, alpha) * std::cos(alpha);
    CAPTURE(alpha);
    CHECK(wedge_bending_ratio(alpha) == Approx(beam / exact).epsilon(1e-9));
    CHECK(wedge_bending_ratio(alpha) < 1.0);
  }
}

TEST_CASE("wedge: 0.9998, 0.9985, 0.9939 and 0.9861 at 2, 5, 10 and 15 degrees") {
  // An independent evaluation of Timoshenko and Goodier's solution.
  const double table[][2] = {{2, 0.9998}, {5, 0.9985}, {10, 0.9939}, {15, 0.9861}};
  for (const auto& [angle, ratio] : table) {
    CHECK(wedge_bending_ratio(angle * degree) == Approx(ratio).margin(5.1e-5));
  }
}

TEST_CASE("wedge: without taper the beam formula is exact, and the series joins steadily") {
  CHECK(wedge_bending_ratio(0.0) == 1.0);
  CHECK(wedge_bending_ratio(4.999e-3) == Approx(wedge_bending_ratio(5e-3)).epsilon(1e-8));
}

}  // namespace taper_test
