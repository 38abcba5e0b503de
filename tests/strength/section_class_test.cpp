#include "boxbeam/strength/section_class.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

namespace section_class_test {

using namespace boxbeam;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

void check_limits(const ClassLimits& limits, double class_1, double class_2, double class_3) {
  CHECK(limits.class_1 == Approx(class_1).epsilon(1e-12));
  CHECK(limits.class_2 == Approx(class_2).epsilon(1e-12));
  CHECK(limits.class_3 == Approx(class_3).epsilon(1e-12));
}

}  // namespace

TEST_CASE("epsilon: 1 for S235, 0.81 for S355") {
  CHECK(epsilon_of(si<Stress>(235e6)) == 1.0);
  // Printed in EN 1993-1-1:2005, table 5.2: f_y 275, 355, 420, 460 give 0.92, 0.81, 0.75, 0.71.
  CHECK(epsilon_of(si<Stress>(275e6)) == Approx(0.92).margin(0.005));
  CHECK(epsilon_of(si<Stress>(355e6)) == Approx(0.81).margin(0.005));
  CHECK(epsilon_of(si<Stress>(420e6)) == Approx(0.75).margin(0.005));
  CHECK(epsilon_of(si<Stress>(460e6)) == Approx(0.71).margin(0.005));
}

TEST_CASE(
    "internal parts: the columns for bending and for even compression, EN 1993-1-1 table 5.2") {
  check_limits(internal_part_limits(0.5, -1.0, 1.0), 72.0, 83.0, 124.0);
  check_limits(internal_part_limits(1.0, 1.0, 1.0), 33.0, 38.0, 42.0);
}

TEST_CASE("internal parts: bending with axial force, by hand") {
  // alpha = 0.51: 396/5.63, 456/5.63; psi = -0.5: 42/0.505.
  check_limits(internal_part_limits(0.51, -0.5, 1.0), 396 / 5.63, 456 / 5.63, 42 / 0.505);
  // alpha = 0.4: 36/0.4, 41.5/0.4; psi = -4: 62*5*2.
  check_limits(internal_part_limits(0.4, -4.0, 1.0), 90.0, 103.75, 620.0);
}

TEST_CASE("outstand parts: under a gradient of stress, by hand") {
  const LargestCompression tip = LargestCompression::at_tip,
                           support = LargestCompression::at_support;
  for (const LargestCompression where : {tip, support})
    check_limits(outstand_part_limits(1.0, 1.0, where, 1.0), 9.0, 10.0, 14.0);
  // Half of it pressed: k_sigma = 0.57 + 0.21 + 0.07 at the tip, 1.7 + 5 + 17.1 at the support.
  check_limits(outstand_part_limits(0.5, -1.0, tip, 0.81), 0.81 * 18.0, 0.81 * 20.0,
               0.81 * 21.0 * std::sqrt(0.85));
  check_limits(outstand_part_limits(0.5, -1.0, support, 0.81), 0.81 * 18.0 * std::sqrt(2.0),
               0.81 * 20.0 * std::sqrt(2.0), 0.81 * 21.0 * std::sqrt(23.8));
}

TEST_CASE("internal parts: a part in tension is never slender") {
  const ClassLimits limits = internal_part_limits(0.0, -infinity, 0.81);
  CHECK(limits.class_1 == infinity);
  CHECK(limits.class_2 == infinity);
  CHECK(limits.class_3 == infinity);
}

TEST_CASE("internal parts: the branches meet, as well as the standard's own numbers do") {
  const double step = 1e-7;
  const ClassLimits below = internal_part_limits(0.5, -1.0, 1.0);
  const ClassLimits above = internal_part_limits(0.5 + step, -1.0 + step, 1.0);
  CHECK(above.class_1 == Approx(below.class_1).epsilon(1e-6));
  // 456/5.5 = 82.91 against 83, 42/0.34 = 123.53 against 124.
  CHECK(above.class_2 == Approx(below.class_2).epsilon(1.2e-3));
  CHECK(above.class_3 == Approx(below.class_3).epsilon(3.9e-3));
  CHECK(above.class_2 < below.class_2);
  CHECK(above.class_3 < below.class_3);
  // Pure bending stays so when an axial force of rounding is beside it.
  const ClassLimits rounded = internal_part_limits(0.5 + 1e-13, -1.0 + 1e-13, 1.0);
  CHECK(rounded.class_2 == Approx(below.class_2).epsilon(1e-9));
  CHECK(rounded.class_3 == Approx(below.class_3).epsilon(1e-9));
}

TEST_CASE("internal parts: more compression, a lower limit; class 1 below 2 below 3") {
  ClassLimits before = internal_part_limits(0.01, -99.0, 0.81);
  for (double psi = -98.9; psi <= 1.0; psi += 0.1) {
    // The share in compression of the elastic stresses: grows with psi as any alpha does.
    const double alpha = psi < 0.0 ? 1.0 / (1.0 - psi) : 1.0;
    const ClassLimits limits = internal_part_limits(alpha, psi, 0.81);
    CAPTURE(psi);
    CHECK(limits.class_1 <= before.class_1);
    CHECK(limits.class_2 <= before.class_2);
    CHECK(limits.class_3 <= before.class_3);
    CHECK(limits.class_1 < limits.class_2);
    CHECK(limits.class_2 < limits.class_3);
    before = limits;
  }
}

TEST_CASE("outstand flanges and round tubes, EN 1993-1-1 table 5.2") {
  check_limits(outstand_flange_limits(1.0), 9.0, 10.0, 14.0);
  check_limits(outstand_flange_limits(0.5), 4.5, 5.0, 7.0);
  check_limits(round_tube_limits(1.0), 50.0, 70.0, 90.0);
  check_limits(round_tube_limits(0.5), 12.5, 17.5, 22.5);
}

TEST_CASE("a slenderness on a limit still belongs to its class") {
  const ClassLimits limits{10.0, 20.0, 30.0};
  CHECK(class_of(0.0, limits) == 1);
  CHECK(class_of(10.0, limits) == 1);
  CHECK(class_of(10.1, limits) == 2);
  CHECK(class_of(20.0, limits) == 2);
  CHECK(class_of(20.1, limits) == 3);
  CHECK(class_of(30.0, limits) == 3);
  CHECK(class_of(30.1, limits) == 4);
}

}  // namespace section_class_test
