#include "project/small_case.hpp"

namespace read_bodies_test {

using namespace small_case;
using namespace boxbeam;

TEST_CASE("a sketch gives the origin of the body's axes, the body its centre of mass") {
  const planar::Mechanism mechanism = planar_of(read(pivot + for_a_second));
  // The rod stands upright on (1, 0) m, its centre 0.5 m above; it turns at 4 rad/s about its foot,
  // which moves at (1, 2) m/s: v = v_foot + omega x (0, 0.5) = (1 - 2, 2) m/s.
  const Body& upright = mechanism.bodies[rod];
  CHECK(upright.sketch.centre.x() == Approx(1.0).epsilon(1e-14));
  CHECK(upright.sketch.centre.y() == Approx(0.5).epsilon(1e-14));
  CHECK(upright.start_velocity.x() == Approx(-1.0).epsilon(1e-14));
  CHECK(upright.start_velocity.y() == Approx(2.0).epsilon(1e-14));
  CHECK(upright.start_velocity.z() == 4.0);
  // Without a velocity a body starts at rest; the beam's centre follows from its sections.
  CHECK(mechanism.bodies[arm].start_velocity.isZero(0.0));
  CHECK(mechanism.bodies[arm].sketch.centre.x() == Approx(0.5).epsilon(1e-14));
}

}  // namespace read_bodies_test
