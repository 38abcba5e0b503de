#include "boxbeam/strength/weld_throat.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

namespace weld_throat_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }
ForcePerLength N_per_mm(double x) { return si<ForcePerLength>(1e3 * x); }

const WeldStrength S355{MPa(470), 0.9, 1.25};

}  // namespace

TEST_CASE("weld: the throat stresses carry the force, whatever its direction") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> force(-500.0, 500.0);
  for (int k = 0; k < 200; ++k) {
    const WeldForce q{N_per_mm(force(random)), N_per_mm(force(random)), N_per_mm(force(random))};
    const ThroatStress stress = throat_stress_of(q, mm(5));
    const double carried =
        std::hypot(stress.normal.value(), stress.shear_across.value(), stress.shear_along.value());
    CHECK(carried * 5e-3 ==
          Approx(std::hypot(q.off_plate.value(), q.along_plate.value(), q.along_weld.value()))
              .epsilon(1e-12));
    // What is across the weld is the fatigue's direct stress, the rest its shear.
    const WeldFatigueStress fatigue = weld_fatigue_stress_of(stress);
    CHECK(fatigue.normal.value() * 5e-3 ==
          Approx(std::hypot(q.off_plate.value(), q.along_plate.value())).epsilon(1e-12));
    CHECK(fatigue.shear == stress.shear_along);
  }
}

TEST_CASE("weld: a force that bisects the legs is all direct stress, across it all shear") {
  const ThroatStress across = throat_stress_of({N_per_mm(100), N_per_mm(100), N_per_mm(0)}, mm(5));
  CHECK(across.normal.value() == Approx(1e6 * std::sqrt(2.0) * 20).epsilon(1e-14));
  CHECK(across.shear_across.value() == 0.0);
  const ThroatStress in_plane =
      throat_stress_of({N_per_mm(100), N_per_mm(-100), N_per_mm(0)}, mm(5));
  CHECK(in_plane.normal.value() == 0.0);
  CHECK(in_plane.shear_across.value() == Approx(1e6 * std::sqrt(2.0) * 20).epsilon(1e-14));
}

TEST_CASE("weld: along the weld both methods agree, across it the directional gives sqrt(3/2)") {
  const WeldForce along{N_per_mm(0), N_per_mm(0), N_per_mm(400)};
  const WeldForce across{N_per_mm(400), N_per_mm(0), N_per_mm(0)};
  const auto directional = [](const WeldForce& q) {
    return directional_utilisation(throat_stress_of(q, mm(5)), S355).combined;
  };
  CHECK(simplified_utilisation(along, mm(5), S355) == Approx(directional(along)).epsilon(1e-14));
  CHECK(simplified_utilisation(across, mm(5), S355) / directional(across) ==
        Approx(std::sqrt(1.5)).epsilon(1e-14));
}

TEST_CASE("weld: the simplified method is never the less strict one") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> force(-500.0, 500.0);
  for (int k = 0; k < 1000; ++k) {
    const WeldForce q{N_per_mm(force(random)), N_per_mm(force(random)), N_per_mm(force(random))};
    for (const double beta_w : {0.8, 0.85, 0.9, 1.0}) {
      const WeldStrength strength{MPa(470), beta_w, 1.25};
      const auto directional = directional_utilisation(throat_stress_of(q, mm(5)), strength);
      CHECK(directional.largest() <= simplified_utilisation(q, mm(5), strength) * (1 + 1e-12));
    }
  }
}

TEST_CASE("weld: the second condition governs where the direct stress is almost alone") {
  // beta_w = 0.8: 0.8 against 1/0.9.
  const WeldStrength S235{MPa(360), 0.8, 1.25};
  const auto pulled = directional_utilisation({MPa(100), MPa(0), MPa(0)}, S235);
  CHECK(pulled.combined == Approx(100 * 0.8 * 1.25 / 360).epsilon(1e-14));
  CHECK(pulled.normal == Approx(100 * 1.25 / (0.9 * 360)).epsilon(1e-14));
  CHECK(pulled.largest() == pulled.normal);
  CHECK(directional_utilisation({MPa(-100), MPa(0), MPa(0)}, S235).normal == pulled.normal);
  const auto sheared = directional_utilisation({MPa(0), MPa(100), MPa(0)}, S235);
  CHECK(sheared.largest() == sheared.combined);
}

}  // namespace weld_throat_test
