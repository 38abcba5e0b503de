// Half-spaces of failure together, by closed forms.

#include "boxbeam/study/series_system.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/study/distribution.hpp"
#include "catch.hpp"

namespace series_system_test {

using namespace boxbeam;
using Eigen::VectorXd;
using std::sqrt;

TEST_CASE("two half-spaces: bivariate normal probabilities and Ditlevsen's bounds", "[study]") {
  // Closed forms: at the origin 1/4 + arcsin(rho)/(2 pi); independent; the same; opposite.
  for (const double rho : {-0.99, -0.5, 0.0, 0.3, 0.9, 0.9999}) {
    CAPTURE(rho);
    CHECK(both_below(0.0, 0.0, rho) ==
          Approx(0.25 + std::asin(rho) / (2.0 * std::numbers::pi)).epsilon(1e-12));
    // By Simpson's rule over the first variable.
    const double a = 1.5, b = 2.0;
    constexpr int parts = 200000;
    const double width = 10.0 / parts;
    double sum = 0.0;
    for (int i = 0; i <= parts; ++i) {
      const double z = a + i * width, weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += weight * std::exp(-0.5 * z * z) *
             normal_share_below((rho * z - b) / sqrt(1.0 - rho * rho));
    }
    CHECK(both_below(a, b, rho) ==
          Approx(sum * width / 3.0 / sqrt(2.0 * std::numbers::pi)).epsilon(1e-6).margin(1e-12));
  }
  CHECK(both_below(2.0, 3.0, 1.0) == Approx(normal_share_below(-3.0)));
  CHECK(both_below(2.0, 3.0, -1.0) == 0.0);
  const VectorXd right = VectorXd::Unit(2, 0), up = VectorXd::Unit(2, 1);
  const double p = normal_share_below(-2.0), q = normal_share_below(-2.5);
  const Bounds two = probability_of_any({{2.5, up}, {2.0, right}});
  CHECK(two.low == Approx(p + q - p * q).epsilon(1e-12));
  CHECK(two.high == Approx(p + q - p * q).epsilon(1e-12));
  const Bounds same = probability_of_any({{2.0, right}, {2.0, right}});
  CHECK(same.high == Approx(p).epsilon(1e-12));
  const Bounds three = probability_of_any(
      {{0.0, right}, {0.0, 0.5 * right + sqrt(0.75) * up}, {0.0, -0.5 * right + sqrt(0.75) * up}});
  CHECK(three.low < three.high);
  // Half-planes through the origin, turned by 0, 60 and 120 degrees: 300 of 360 degrees.
  CHECK(three.low <= 5.0 / 6.0 + 1e-12);
  CHECK(three.high >= 5.0 / 6.0 - 1e-12);
}

}  // namespace series_system_test
