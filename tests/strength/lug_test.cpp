#include "boxbeam/strength/lug.hpp"

#include <cmath>

#include "catch.hpp"

namespace lug_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

Lug lug_of(double width, double hole, double thickness = 20.0) {
  return {mm(width), mm(hole), mm(thickness), {}};
}

}  // namespace

TEST_CASE("lug: K_t on the net section by hand, and beside a digitised chart") {
  // x = 0.5: 12.882 - 26.357 + 22.4405 - 6.458375.
  CHECK(lug_concentration(lug_of(100.0, 50.0)) == Approx(2.507125).epsilon(1e-12));
  // K_tb of bearing stress F/(d t), as a public program has digitised it from a chart of pins in
  // plates; of the net section it is K_tb (1 - x)/x.
  const double chart[][2] = {{0.2002, 1.2821}, {0.2490, 1.4037}, {0.3048, 1.5746},
                             {0.3467, 1.7326}, {0.3975, 1.9587}, {0.4485, 2.2534}};
  for (const auto& [x, K_tb] : chart) {
    const double ratio = lug_concentration(lug_of(100.0, 100.0 * x)) / (K_tb * (1.0 - x) / x);
    CAPTURE(x, ratio);
    CHECK(ratio > 0.94);
    CHECK(ratio < 1.09);
  }
  // The wider the plate beside its hole, the more unevenly it is stressed.
  for (double x = narrowest_hole; x < widest_hole; x += 0.01)
    CHECK(lug_concentration(lug_of(100.0, 100.0 * x)) >
          lug_concentration(lug_of(100.0, 100.0 * (x + 0.01))));
}

TEST_CASE("lug: of a plate wider than is known no more counts") {
  CHECK(lug_net_area(lug_of(120.0, 50.0)).value() == Approx(0.07 * 0.02));
  const Lug wide = lug_of(1000.0, 30.0), widest = lug_of(200.0, 30.0);
  CHECK(lug_net_area(wide).value() == Approx(lug_net_area(widest).value()));
  CHECK(lug_concentration(wide) == Approx(lug_concentration(widest)));
}

TEST_CASE("lug: a pin's plate by table 3.9, its two types beside each other") {
  // c = 35 mm, a = 45 mm, d_0 = 50 mm, t = 20 mm, f_y = 345 MPa, gamma_M0 = 1.05.
  Lug lug = lug_of(120.0, 50.0);
  const double by_width = 2.0 * 0.02 * 345e6 * (0.035 - 0.05 / 3.0) / 1.05;
  CHECK(lug_resistance_of(lug, si<Stress>(345e6), 1.05).value() == Approx(by_width));
  lug.end = mm(45.0);
  const double by_end = 2.0 * 0.02 * 345e6 * (0.045 - 0.1 / 3.0) / 1.05;
  CHECK(by_end < by_width);
  CHECK(lug_resistance_of(lug, si<Stress>(345e6), 1.05).value() == Approx(by_end));
  // Type B has its own geometry, 0.75 d_0 beside the hole, 1.1 d_0 before it and d_0 = 2.5 t, and
  // asks t >= 0.7 sqrt(F/f_y): nearly what type A asks of the same plate.
  const Lug b{mm(2.5 * 50.0), mm(50.0), mm(20.0), mm(1.1 * 50.0)};
  const double by_b = std::pow(0.02 / 0.7, 2) * 345e6;
  CHECK(lug_resistance_of(b, si<Stress>(345e6), 1.0).value() == Approx(by_b).epsilon(0.03));
  // Nothing is left before the hole.
  lug.end = mm(30.0);
  CHECK(lug_resistance_of(lug, si<Stress>(345e6), 1.0) == Force{});
}

}  // namespace lug_test
