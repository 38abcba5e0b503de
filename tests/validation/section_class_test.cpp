// Classes of internal parts: a web of a published calculation that six independent programs
// reproduce, and the limits of S355 as design tables print them.

#include "boxbeam/strength/section_class.hpp"

#include "catch.hpp"

namespace section_class_test {

using namespace boxbeam;

TEST_CASE("section class: web with eps = 0.8375, c = 799.9 mm, t = 25.9 mm", "[validation]") {
  const ClassLimits limits = internal_part_limits(0.5, -1.0, 0.8375);
  CHECK(limits.class_1 == Approx(60.3).margin(0.05));
  CHECK(limits.class_2 == Approx(69.5).margin(0.05));
  // 103.85, printed as 103.9.
  CHECK(limits.class_3 == Approx(103.9).margin(0.051));
  CHECK(799.9 / 25.9 == Approx(30.9).margin(0.05));
  CHECK(class_of(799.9 / 25.9, limits) == 1);
}

TEST_CASE("section class: S355, flange of a box and web in bending", "[validation]") {
  const double epsilon = epsilon_of(si<Stress>(355e6));
  const ClassLimits flange = internal_part_limits(1.0, 1.0, epsilon);
  const ClassLimits web = internal_part_limits(0.5, -1.0, epsilon);
  CHECK(epsilon == Approx(0.8136).margin(5e-5));
  // Printed 26.8, 30.9, 34.2 and 58.6, 67.5, 100.9.
  CHECK(flange.class_1 == Approx(26.85).margin(0.05));
  CHECK(flange.class_2 == Approx(30.9).margin(0.05));
  CHECK(flange.class_3 == Approx(34.2).margin(0.05));
  CHECK(web.class_1 == Approx(58.6).margin(0.05));
  CHECK(web.class_2 == Approx(67.5).margin(0.05));
  CHECK(web.class_3 == Approx(100.9).margin(0.05));
}

}  // namespace section_class_test
