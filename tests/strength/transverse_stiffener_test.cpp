// Stiffeners across a web: published least second moments, and those of flats.

#include "boxbeam/strength/transverse_stiffener.hpp"

#include <cmath>

#include "catch.hpp"

namespace transverse_stiffener_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }

}  // namespace

TEST_CASE("flats beside a web, with 15 eps t of it, about the centroid of both") {
  // Web 10, flats 100 x 12, S235: 2 x 150 + 12 = 312 mm of the web.
  BearingStiffener flats{mm(1000),          mm(10), mm(3000), mm(3000), mm(12), mm(100),
                         si<Stress>(235e6), true,   true};
  // Both: 12 x (210^3 - 10^3)/12 + 312 x 10^3/12 = 9.286e6.
  CHECK(stiffener_inertia(flats).value() == Approx(9.286e-6).epsilon(1e-9));
  // One: A = 3120 and 1200, 55 apart: 26e3 + 12 x 100^3/12 + 3120 x 1200/4320 x 55^2 = 3.6477e6;
  // about the web's middle it would be 4.63e6 without the web.
  flats.both_sides = false;
  CHECK(stiffener_inertia(flats).value() == Approx(3.64766667e-6).epsilon(1e-8));
  // At the end of the beam there is web on one side alone.
  flats.web_before = Length{};
  CHECK(stiffener_inertia(flats).value() ==
        Approx(1e-12 * (162e3 / 12.0 + 1e6 + 1620.0 * 1200.0 / 2820.0 * 3025.0)).epsilon(1e-9));
}

TEST_CASE("what of a plate across a box works beside a web") {
  const Stress S355 = si<Stress>(355e6);
  // Whole, 584 between the webs, 10 mm: lambda_p = 58.4/(28.4 x 0.81362 x 2) = 1.2637, rho =
  // (1.2637 - 0.22)/1.2637^2 = 0.65357: 190.8 of 292 mm.
  CHECK(working_width_of(mm(292), mm(10), S355, true).value() == Approx(0.19084).epsilon(1e-4));
  // To an opening 142 mm: lambda_p = 14.2/(28.4 x 0.81362 x 0.65574) = 0.93718, rho = (0.93718 -
  // 0.188)/0.93718^2 = 0.85299.
  CHECK(working_width_of(mm(142), mm(10), S355, false).value() == Approx(0.12113).epsilon(1e-4));
  // A stout one works whole, none by more than it is; a thinner or narrower one never more.
  CHECK(working_width_of(mm(50), mm(10), S355, false).value() == Approx(0.05));
  for (const bool whole : {true, false}) {
    double thinner = 0.0;
    for (double t = 0.1; t < 30.0; t *= 1.1) {
      const double width = working_width_of(mm(292), mm(t), S355, whole).value();
      CHECK(width >= thinner);
      CHECK(width <= 0.292 * (1.0 + 1e-12));
      thinner = width;
    }
  }
}

TEST_CASE("a stiffener is rigid for panels from some length on") {
  for (const double b : {10.0, 30.0, 60.0, 120.0, 300.0}) {
    const BearingStiffener of{mm(1000),          mm(8), mm(3000), mm(3000), mm(10), mm(b),
                              si<Stress>(355e6), true,  true};
    const auto least = least_panel_length_of(of);
    // sqrt(2) h_w and more ask for the same.
    CHECK(least.has_value() == rigidity_obstacle(of, mm(5000)).empty());
    if (!least) continue;
    CHECK(rigidity_obstacle(of, *least * (1.0 + 1e-9)).empty());
    if (least->value() < 1.414) CHECK_FALSE(rigidity_obstacle(of, *least * (1.0 - 1e-6)).empty());
  }
}

}  // namespace transverse_stiffener_test
