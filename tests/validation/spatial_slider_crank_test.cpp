// The spatial slider-crank of the IFToMM library of computational benchmark problems.

#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "catch.hpp"
#include "support/spatial_slider_crank.hpp"

namespace spatial_slider_crank_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;
using test::check_balance;

TEST_CASE("A spatial slider-crank begins with the rates of its closed form") {
  const Mechanism mechanism = test::spatial_slider_crank();
  const Chain chain(mechanism);
  const State state = chain.at(0.0);
  CHECK(state.bodies[1].position.x() == Approx(std::sqrt(0.09 - 0.01 - 0.04)).epsilon(1e-13));
  CHECK(state.bodies[1].velocity.x() == Approx(0.24).epsilon(1e-12));
  CHECK((state.bodies[3].omega - Vector3d(1.92, -0.96, 0.48)).norm() < 1e-12);
  const Vector3d middle = velocity_of(state, {3, mechanism.bodies[3].centre});
  CHECK((middle - Vector3d(0.12, -0.24, 0.0)).norm() < 1e-12);
  CHECK(chain.loops()->repeating() == 0);
  for (int i = 0; i < 40; ++i) check_balance(chain, 0.03 * i);
}

}  // namespace spatial_slider_crank_test
