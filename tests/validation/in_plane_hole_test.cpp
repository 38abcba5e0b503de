// In-plane bending of a plate with a hole at mid-depth: the same finite-element run as of the
// strip in tension, factors on the nominal stress M r/I_net at the top of the hole.

#include "boxbeam/strength/hole_factors.hpp"
#include "catch.hpp"

namespace in_plane_hole_test {

using namespace boxbeam;

namespace {

struct Row {
  double a, factor;
};
constexpr Row finite_elements[] = {{0.05, 2.003}, {0.1, 2.000}, {0.2, 1.990}, {0.3, 1.972},
                                   {0.4, 1.949},  {0.5, 1.929}, {0.6, 1.921}, {0.7, 1.926}};

/// t = 20 mm, D = 1 m, M = 1 N m.
InPlaneBendingStress stress_at(double a) {
  return *in_plane_bending_stress(si<Moment>(1.0), 1.0 * metre, 0.02 * metre, a * metre);
}

}  // namespace

TEST_CASE("in-plane bending: the factor 2 is right to 0.2 % or conservative by 4.2 % at most",
          "[validation]") {
  for (const Row& row : finite_elements) {
    const double I_net = 0.02 * (1 - row.a * row.a * row.a) / 12;
    const double factor = stress_at(row.a).at_hole.value() * I_net / (0.5 * row.a);
    CAPTURE(row.a);
    CHECK(factor / row.factor > 0.998);
    CHECK(factor / row.factor < 1.042);
  }
}

TEST_CASE("in-plane bending: the hole governs from d/D = 0.5, by finite elements from 0.52",
          "[validation]") {
  for (const Row& row : finite_elements) {
    const bool governs_here = stress_at(row.a).at_hole > stress_at(row.a).at_edges * 1.0000001;
    const bool governs_there = row.a * row.factor > 1.0;
    CAPTURE(row.a);
    CHECK(governs_here == governs_there);
  }
}

}  // namespace in_plane_hole_test
