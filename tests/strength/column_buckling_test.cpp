#include "boxbeam/strength/column_buckling.hpp"

#include <cmath>

#include "boxbeam/strength/member_buckling.hpp"
#include "catch.hpp"
#include "src/strength/column_formulas.hpp"

namespace column_buckling_test {

using namespace boxbeam;

namespace {

constexpr BucklingCurve curves[] = {BucklingCurve::a0, BucklingCurve::a, BucklingCurve::b,
                                    BucklingCurve::c, BucklingCurve::d};

/// chi by halving an interval on Ayrton and Perry's condition of first yield in a bar of initial
/// bow, chi + chi eta/(1 - chi lambda^2) = 1, eta = alpha (lambda - 0.2).
double ayrton_perry(double lambda, double alpha) {
  double low = 0.0, high = std::fmin(1.0, 1.0 / (lambda * lambda));
  for (int k = 0; k < 100; ++k) {
    const double chi = 0.5 * (low + high);
    const double stress = chi + chi * alpha * (lambda - 0.2) / (1.0 - chi * lambda * lambda);
    (stress < 1.0 ? low : high) = chi;
  }
  return 0.5 * (low + high);
}

}  // namespace

TEST_CASE("column: a stout one does not buckle, chi = 1 up to lambda = 0.2, steadily") {
  for (const BucklingCurve curve : curves) {
    CHECK(column::reduction(plainly, 0.0, curve) == 1.0);
    CHECK(column::reduction(plainly, 0.2, curve) == 1.0);
    CHECK(column::reduction(plainly, 0.2 + 1e-12, curve) == Approx(1.0).epsilon(1e-11));
    CHECK(column::reduction(plainly, 0.201, curve) < 1.0);
  }
}

TEST_CASE("column: a slender one nears Euler's force from below") {
  for (const BucklingCurve curve : curves) {
    double before = 0.0;
    for (double lambda = 2.0; lambda < 1e4; lambda *= 2.0) {
      const double of_euler = column::reduction(plainly, lambda, curve) * lambda * lambda;
      CHECK(of_euler < 1.0);
      CHECK(of_euler > before);
      before = of_euler;
    }
    // 1 - chi lambda^2 falls as alpha/lambda.
    CHECK(before == Approx(1.0).margin(2e-4));
  }
}

TEST_CASE("column: chi solves Ayrton and Perry's equation") {
  const double alphas[] = {0.13, 0.21, 0.34, 0.49, 0.76};
  for (int k = 0; k < 5; ++k) {
    CHECK(imperfection_factor(curves[k]) == alphas[k]);
    for (double lambda = 0.25; lambda < 4.0; lambda += 0.05) {
      CAPTURE(alphas[k], lambda);
      CHECK(column::reduction(plainly, lambda, curves[k]) ==
            Approx(ayrton_perry(lambda, alphas[k])).epsilon(1e-10));
    }
  }
}

TEST_CASE("column: chi falls with slenderness and from curve a0 to d") {
  for (double lambda = 0.2; lambda < 3.0; lambda += 0.01) {
    CAPTURE(lambda);
    for (int k = 0; k < 5; ++k) {
      CHECK(column::reduction(plainly, lambda + 0.01, curves[k]) <
            column::reduction(plainly, lambda, curves[k]));
      if (k > 0) {
        CHECK(column::reduction(plainly, lambda + 0.01, curves[k]) <
              column::reduction(plainly, lambda + 0.01, curves[k - 1]));
      }
    }
  }
}

TEST_CASE("column: Euler's force, slenderness and use of a bar by hand") {
  // Square bar 40 x 40 mm, 1 m between pins, E = 210 GPa, f_y = 235 MPa: I = 2.1333e-7 m4,
  // N_cr = pi^2 210e9 2.1333e-7/1 = 442.2 kN, lambda = sqrt(376/442.2) = 0.9222.
  const Area area = si<Area>(1.6e-3);
  const Stress yield = si<Stress>(235e6);
  const Force critical =
      euler_force(si<Stress>(210e9), si<SecondMoment>(0.04 * 0.04 * 0.04 * 0.04 / 12), 1.0 * metre);
  CHECK(critical.value() == Approx(442.2e3).epsilon(2e-4));
  CHECK(column::slenderness(plainly, area, yield, critical) == Approx(0.9222).epsilon(2e-4));
  // Curve c, Phi = [1 + 0.49*0.7222 + 0.8504]/2 = 1.1021, chi = 1/(1.1021 + 0.6034) = 0.5863.
  // As a member under A f_y, which is used by 1/chi.
  const MemberLoad squashed{1.0, 0.0, area * yield / critical};
  CHECK(flexural_use(squashed, BucklingCurve::c, 1.0) == Approx(1.0 / 0.5863).epsilon(3e-4));
  CHECK(flexural_use(squashed, BucklingCurve::c, 1.1) == Approx(1.1 / 0.5863).epsilon(3e-4));
}

}  // namespace column_buckling_test
