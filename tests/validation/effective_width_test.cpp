// Effective widths of S355 plates, calculated by hand from EN 1993-1-5, 4.4.

#include "boxbeam/strength/effective_width.hpp"

#include <cmath>

#include "catch.hpp"

namespace effective_width_test {

using namespace boxbeam;

TEST_CASE("effective width: b/t = 60 in even compression, b/t = 150 in bending", "[validation]") {
  const double epsilon = std::sqrt(235.0 / 355.0);
  const auto flange = *internal_effective_width(0.6 * metre, 0.01 * metre, 1.0, epsilon);
  CHECK(flange.k_sigma == 4.0);
  CHECK(flange.lambda_p == Approx(1.2983).margin(5e-5));
  CHECK(flange.rho == Approx(0.6397).margin(5e-5));
  CHECK(flange.b_eff.value() == Approx(0.6 * 0.6397).epsilon(1e-4));

  const auto web = *internal_effective_width(1.5 * metre, 0.01 * metre, -1.0, epsilon);
  CHECK(web.k_sigma == 23.9);
  CHECK(web.lambda_p == Approx(1.3279).margin(5e-5));
  CHECK(web.rho == Approx(0.6907).margin(5e-5));
  CHECK(web.b_eff.value() == Approx(0.75 * 0.6907).epsilon(1e-4));
  CHECK(web.b_e1.value() == Approx(0.4 * 0.75 * 0.6907).epsilon(1e-4));
}

}  // namespace effective_width_test
