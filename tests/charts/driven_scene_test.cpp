// The scenes of planar experiments: two independent references agree, and cases without an answer
// say why.

#include "charts/driven_scene.hpp"

#include "catch.hpp"
#include "charts/chart_values.hpp"

namespace driven_scene_test {

using namespace boxbeam;
using namespace boxbeam::charts;

TEST_CASE(
    "closed-form dyads and Newton's method agree in long double, on every shipped mechanism") {
  for (const char* path :
       {"sledge-rig/rig.toml", "sledge-rig/published.toml", "four-bar-rocker/rocker.toml",
        "pump-jack/beam.toml", "scissor-lift/lift.toml", "slider-crank-press/press.toml"}) {
    INFO(path);
    std::string why;
    const auto scene = driven_scene_of(test::shipped_scene(path), why);
    REQUIRE(scene);
    REQUIRE(scene->dyads.failure == "");
    const ReferenceMotion dyads = reference_of(*scene, 24);
    const ReferenceMotion newton = newton_reference_of(*scene, 24);
    CHECK(dyads.name != newton.name);
    const ErrorOf error_of(scene->mechanism, newton);
    // 2^-63 is 1.1e-19; a few digits go with the conditions of these mechanisms.
    CHECK(error_of(Quantity::position, dyads.instants) < 1e-17);
    CHECK(error_of(Quantity::velocity, dyads.instants) < 1e-16);
    CHECK(error_of(Quantity::acceleration, dyads.instants) < 1e-15);
    CHECK(error_of(Quantity::reaction, dyads.instants) < 1e-15);
  }
}

TEST_CASE("cases without an answer say why") {
  std::string why;
  CHECK_FALSE(driven_scene_of(test::shipped_scene("drill-truck/truck.toml"), why));
  CHECK(why.find("elastic links") != std::string::npos);
  CHECK_FALSE(driven_scene_of(test::shipped_scene("landing-gear/gear.toml"), why));
  CHECK(why.find("chain in space") != std::string::npos);
}

TEST_CASE("an error is seen in every quantity, and none in the reference itself") {
  std::string why;
  const auto scene = driven_scene_of(reference_scenes(), why);
  REQUIRE(scene);
  const ReferenceMotion reference = reference_of(*scene, 4);
  const ErrorOf error_of(scene->mechanism, reference);
  std::vector<InstantIn<long double>> instants = reference.instants;
  CHECK(error_of(Quantity::reaction, instants) == 0.0);
  // A whole turn is no error; a quarter of the largest acceleration is one of 0.25.
  instants[1].q[2] += 2.0L * std::numbers::pi_v<long double>;
  CHECK(error_of(Quantity::position, instants) < 1e-18);
  instants[2].lambda *= std::numeric_limits<long double>::quiet_NaN();
  CHECK(std::isnan(error_of(Quantity::reaction, instants)));
}

}  // namespace driven_scene_test
