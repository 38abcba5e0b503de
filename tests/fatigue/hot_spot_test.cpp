#include "boxbeam/fatigue/hot_spot.hpp"

#include "catch.hpp"

namespace hot_spot_test {

using namespace boxbeam;

TEST_CASE("hot spot: a stress that is linear before the toe is the one at the toe") {
  for (const double at_toe : {100e6, -80e6}) {
    for (const double slope : {-40e6, 0.0, 25e6}) {
      const auto at = [&](double thicknesses) { return si<Stress>(at_toe + slope * thicknesses); };
      CHECK(hot_spot_stress_of({at(0.4), at(1.0)}).value() == Approx(at_toe).epsilon(1e-14));
    }
  }
}

TEST_CASE("hot spot: the factors as IIW prints them, 1.67 and 0.67") {
  const double near = 150e6, far = 120e6;
  CHECK(hot_spot_stress_of({si<Stress>(near), si<Stress>(far)}).value() ==
        Approx(1.67 * near - 0.67 * far).epsilon(1e-3));
}

}  // namespace hot_spot_test
