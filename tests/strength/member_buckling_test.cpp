#include "boxbeam/strength/member_buckling.hpp"

#include <cmath>
#include <random>

#include "boxbeam/core/derivation.hpp"
#include "catch.hpp"

namespace member_buckling_test {

using namespace boxbeam;

TEST_CASE("a member under compression and bending, by hand") {
  // N = 0.2 A f_y = 0.16 N_cr, M = 0.3 W f_y: lambda = sqrt(0.8) = 0.8944, curve c: phi = 0.5 (1 +
  // 0.49 0.6944 + 0.8) = 1.0701, chi = 1/(1.0701 + sqrt(1.1451 - 0.8)) = 0.6033; 0.2/0.6033 =
  // 0.3315.
  const MemberLoad load{0.2, 0.3, 0.16};
  CHECK(flexural_use(load, BucklingCurve::c, 1.0) == Approx(0.6315).margin(1e-4));
  CHECK(flexural_use(load, BucklingCurve::c, 1.1) == Approx(1.1 * 0.6315).margin(1e-4));
  // Turning over: alpha_ult = 2, lambda = sqrt(2 0.16) = 0.5657, curve d: phi = 0.5 (1 + 0.76
  // 0.3657 + 0.32) = 0.7990, chi = 1/(0.7990 + sqrt(0.6383 - 0.32)) = 0.7335: 0.5/0.7335 = 0.6817.
  CHECK(lateral_use(load, BucklingCurve::d, 1.0) == Approx(0.6817).margin(2e-4));
}

TEST_CASE("a published column: chi = 0.878, 2297 kN") {
  // xcfem/xc, verif/tests/materials/ec3/test_buckling_resistance_02.py: CHS 244.5 x 10, S355, 4 m,
  // curve a. A = 73.67 cm^2, I = 5073 cm^4: N_cr = 6571 kN.
  const double pi = 3.14159265358979323846;
  const double A = pi / 4.0 * (0.2445 * 0.2445 - 0.2245 * 0.2245);
  const double I = pi / 64.0 * (std::pow(0.2445, 4) - std::pow(0.2245, 4));
  const double N_cr = pi * pi * 210e9 * I / 16.0, N = 2297e3;
  const MemberLoad load{N / (A * 355e6), 0.0, N / N_cr};
  CHECK(flexural_use(load, BucklingCurve::a, 1.0) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("where other bodies are compressed the beam's bending counts, and its sheet is finite") {
  // N/N_cr of the mechanism, none of it in the beam.
  const MemberLoad load{0.0, 0.3, 0.16};
  CHECK(flexural_use(load, BucklingCurve::c, 1.1) == Approx(1.1 * 0.3));
  Derivation steps;
  CHECK(derive_flexural_use(steps, load, BucklingCurve::c, 1.1).value() == Approx(1.1 * 0.3));
  for (const DerivationStep& step : steps.steps()) CHECK(std::isfinite(step.value.value()));
}

TEST_CASE("properties of members that hold for every load") {
  std::mt19937 engine(11);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  for (int i = 0; i < 2000; ++i) {
    const MemberLoad load{in(0.0, 1.0), in(0.0, 1.0), in(0.001, 0.99)};
    CAPTURE(i, load.compressed, load.bent, load.critical);
    const double f = in(0.1, 5.0);
    const MemberLoad more{f * load.compressed, f * load.bent, f * load.critical};
    for (const auto& use : {flexural_use, lateral_use}) {
      const double of = use(load, BucklingCurve::c, 1.0);
      // Linear where all grow alike; never less than yielding; never less for more of anything.
      CHECK(use(more, BucklingCurve::c, 1.0) == Approx(f * of).epsilon(1e-12));
      CHECK(of >= (load.compressed + load.bent) * (1.0 - 1e-12));
      MemberLoad other = load;
      other.compressed *= 1.05;
      CHECK(use(other, BucklingCurve::c, 1.0) >= of);
      other = load;
      other.bent *= 1.05;
      CHECK(use(other, BucklingCurve::c, 1.0) >= of);
      other = load;
      other.critical *= 1.05;
      CHECK(use(other, BucklingCurve::c, 1.0) >= of);
      CHECK(use(load, BucklingCurve::d, 1.0) >= of);
    }
  }
  // What does not compress bends only.
  CHECK(flexural_use({0.0, 0.4, 0.0}, BucklingCurve::c, 1.1) == Approx(0.44));
  CHECK(lateral_use({0.0, 0.0, 0.0}, BucklingCurve::d, 1.0) == 0.0);
}

}  // namespace member_buckling_test
