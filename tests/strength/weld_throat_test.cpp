#include "boxbeam/strength/weld_throat.hpp"

#include <cmath>
#include <random>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/project/catalogue.hpp"
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

TEST_CASE("weld: with equal legs the first condition is the harder one, in every steel") {
  // sigma_perp = tau_perp = sigma_w/sqrt(2): sqrt(2) beta_w against 1/(0.9 sqrt(2)), equal at 5/9.
  const double limit = 5.0 / 9.0;
  CHECK(std::sqrt(2.0) * limit == Approx(1.0 / (0.9 * std::sqrt(2.0))).epsilon(1e-15));
  for (const std::string& name : steel_names()) {
    const Material steel = *find_steel(name);
    CAPTURE(name, steel.beta_w);
    CHECK(steel.beta_w > limit);
    const WeldStrength strength{MPa(500), steel.beta_w, 1.25};
    for (const double sigma_w : {-300.0, -1.0, 1.0, 300.0}) {
      const Stress across = MPa(sigma_w / std::sqrt(2.0));
      for (const double along : {0.0, 100.0, -1000.0}) {
        const auto use = directional_utilisation({across, across, MPa(along)}, strength);
        CHECK(use.combined > use.normal);
      }
    }
  }
}

TEST_CASE("weld: root of two fillets on a plate of 12 mm, a range of 40 MPa", "[validation]") {
  // n = 480 N/mm on two throats of 6 mm: sigma_wf = n/(2 a) = 40 MPa; N(36) = 2e6 (36/40)^3 =
  // 1.458e6; a damage of 1e6/(2e6 (36/(1.35 40))^3) = 1.6875 with gamma_Mf 1.35. By hand.
  const ThroatStress stress = throat_stress_of({N_per_mm(240), N_per_mm(0), N_per_mm(0)}, mm(6));
  const Stress range = si<Stress>(std::hypot(stress.normal.value(), stress.shear_across.value()));
  CHECK(range.value() == Approx(40e6));
  const SnCurve root = en_1993_1_9_direct(36);
  CHECK(cycles_to_failure(root, range, Loading::spectrum) == Approx(1.458e6));
  FatigueDemand demand;
  demand.gamma_Mf = 1.35;
  CHECK(damage_of({{range, {}, 1e6}}, root, demand) == Approx(1.6875));
  // Limits of 36: 26.5 and 14.6 MPa; cut-off of shear 80: 36.6 MPa.
  CHECK(knee_of(root).value() == Approx(26.5e6).margin(0.05e6));
  CHECK(cut_off_of(root).value() == Approx(14.6e6).margin(0.05e6));
  CHECK(cut_off_of(en_1993_1_9_shear(80)).value() == Approx(36.6e6).margin(0.05e6));
}

}  // namespace weld_throat_test
