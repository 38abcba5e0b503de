// Shivakumar and Newman, Stress Concentrations for Straight-Shank and Countersunk Holes in Plates
// Subjected to Tension, Bending, and Pin Loading, NASA TP-3192 (1992): three-dimensional
// finite-element results as fitted there, straight holes, hole radius a fifth of the half-width;
// factors on the remote (gross) stress.

#include "boxbeam/strength/hole_concentration.hpp"
#include "catch.hpp"

namespace nasa_tp_3192_test {

using namespace boxbeam;

namespace {

struct Row {
  double radius_to_thickness;
  double tension;  ///< at mid-plane
  double bending;  ///< at the surface
};
constexpr Row table[] = {{0.25, 3.21, 2.280}, {0.5, 3.22, 2.124}, {1.0, 3.20, 1.966},
                         {1.5, 3.15, 1.934},  {2.0, 3.11, 1.936}, {2.5, 3.12, 1.878}};

}  // namespace

TEST_CASE("NASA TP-3192, tension: the plane-stress factor within 2.5 %", "[validation]") {
  const double gross = membrane_concentration(0.2) / (1 - 0.2);
  for (const Row& row : table) {
    CAPTURE(row.radius_to_thickness);
    CHECK(gross == Approx(row.tension).epsilon(0.025));
  }
}

TEST_CASE("NASA TP-3192, bending: the wide plate's factor 9.2 % above to 2.4 % below",
          "[validation]") {
  for (const Row& row : table) {
    const double wide = *plate_bending_concentration(2 * row.radius_to_thickness, 0.0);
    CAPTURE(row.radius_to_thickness);
    CHECK(wide < 1.092 * row.bending);
    CHECK(wide > 0.976 * row.bending);
  }
}

TEST_CASE("NASA TP-3192, bending: with its width, d/w = 0.2, on the safe side by 2 to 15 %",
          "[validation]") {
  for (const Row& row : table) {
    const double gross = *plate_bending_concentration(2 * row.radius_to_thickness, 0.2) / (1 - 0.2);
    CAPTURE(row.radius_to_thickness);
    CHECK(gross > 1.02 * row.bending);
    CHECK(gross < 1.15 * row.bending);
  }
}

}  // namespace nasa_tp_3192_test
