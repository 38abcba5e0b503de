// Slender plates, stiffeners, patches and fillet welds: figures that others publish, by source.

#include <algorithm>
#include <cmath>

#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/strength/plastic_box.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"
#include "boxbeam/strength/transverse_stiffener.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "catch.hpp"

namespace slender_plates_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }
ForcePerLength N_per_mm(double x) { return si<ForcePerLength>(1e3 * x); }

}  // namespace

TEST_CASE("eurocodedesign: column-like buckling of bare plates, and between both", "[validation]") {
  // domthom21/eurocodedesign, tests/standard/ec3/platebuckling: figures of its authors' by hand.
  CHECK(1e-6 * plate_column_stress(mm(10.0), mm(600.0)).value() == Approx(52.78).epsilon(2e-3));
  CHECK(std::sqrt(355.0 / 76.0) == Approx(2.16).margin(5e-3));
  CHECK(column_like_reduction(2.16, 0.21) == Approx(0.194).margin(1e-3));
  CHECK(interpolated_reduction(0.485, 0.194, 0.44) == Approx(0.394).margin(5e-4));
}

TEST_CASE("JRC, Bridge design to Eurocodes (2012): a web of 2720 x 18 mm in shear, a = 8 m",
          "[validation]") {
  // JRC, Bridge design to Eurocodes (2012), p. 130: k_tau = 5.8024, V_bw,Rd = 4.44 MN.
  ShearPanel panel{2.720 * metre, 0.018 * metre, 345e6 * pascal, 8.0 * metre, true};
  const ShearResistance of = shear_resistance_of(panel, 1.1);
  CHECK(of.k_tau == Approx(5.8024).margin(5e-5));
  CHECK(of.lambda_w == Approx(2.033).margin(1e-3));
  CHECK(of.chi_w == Approx(0.501).margin(5e-4));
  CHECK(of.resistance.value() == Approx(4.44e6).epsilon(2e-3));
}

// tau_cr = 48.23 MPa of a web 2720 x 18, a = 8 m: JRC, Bridge Design to Eurocodes, Worked examples
// (2012), p. 130; 37.4 eps stands for sqrt(f_y/(sqrt(3) sigma_E)) there and here (0.1 %).
TEST_CASE("JRC, Bridge design to Eurocodes (2012): the shear at which it buckles", "[validation]") {
  const ShearPanel panel{mm(2720), mm(18), MPa(345), mm(8000)};
  CHECK(buckling_shear_of(panel, 1.0).value() == Approx(48.23e6 * 2.72 * 0.018).epsilon(1e-3));
  CHECK(buckling_shear_of(panel, 1.1).value() ==
        Approx(buckling_shear_of(panel, 1.0).value() / 1.1));
  // Elastic: the steel is no matter.
  ShearPanel other = panel;
  other.yield_strength = MPa(235);
  CHECK(buckling_shear_of(other, 1.0).value() == Approx(buckling_shear_of(panel, 1.0).value()));
}

TEST_CASE("Steel Buildings in Europe, MSB08: an IPE 500 under a force near its end",
          "[validation]") {
  // Steel Buildings in Europe, Multi-storey steel buildings, part 8, worked example 5: S355,
  // s_s = 100 mm, c = 10 mm. Published are m_1 and m_2; k_F, l_y and F_Rd by pocket calculator:
  // k_F = 2 + 6 110/468; F_cr = 0.9 k_F 210 000 10.2^3/468; l_e = 3.410 210 000 10.2^2/(2 355 468)
  // = 224.2 > 110; l_y = 110 + 16 sqrt(19.61 + 17.11) = 207.0.
  PatchedWeb of;
  of.depth = mm(468.0);
  of.thickness = mm(10.2);
  of.yield_strength = of.flange_strength = MPa(355.0);
  of.flange_thickness = mm(16.0);
  of.flange_inside = of.flange_outside = mm(0.5 * (200.0 - 10.2));
  of.stiff_length = mm(100.0);
  of.entry = ForceEntry::near_end;
  of.to_end = mm(10.0);
  const PatchResistance found = patch_resistance_of(of, 1.0);
  CHECK(found.m_1 == Approx(19.6).margin(0.05));
  CHECK(found.m_2 == Approx(17.11).margin(0.005));
  CHECK(found.k_F == Approx(3.41).margin(0.005));
  CHECK(found.l_y.value() == Approx(0.2070).margin(5e-5));
  CHECK(found.chi_F == Approx(0.698).margin(5e-4));
  CHECK(found.resistance.value() == Approx(523e3).epsilon(1e-3));
}

// Source: ITEC-GPA/Checker, tests of the interaction: M_pl = 100, M_f = 40, V_bw = 100: M = 80 with
// V = 75 gives 0.95, M = 100 with V = 100 gives 1.6.
TEST_CASE("ITEC-GPA/Checker: sums of 7.1(1)", "[validation]") {
  const auto sum = [](double f, double m, double v) {
    return f * m + 0.6 * std::pow(2.0 * f * v - 1.0, 2);
  };
  CHECK(sum(1.0, 0.8, 0.75) == Approx(0.95));
  CHECK(sum(1.0, 1.0, 1.0) == Approx(1.6));
  const double within = interaction_factor(0.8, 0.75, 0.6);
  const double beyond = interaction_factor(1.0, 1.0, 0.6);
  CHECK(within > 1.0);
  CHECK(sum(within, 0.8, 0.75) == Approx(1.0));
  CHECK(beyond < 1.0);
  CHECK(sum(beyond, 1.0, 1.0) == Approx(1.0));
  // With all of the moment in the webs it is 7.1(5).
  CHECK(interaction_factor(0.8, 0.75, 1.0 - 1e-12) == Approx(interaction_factor(0.8, 0.75)));
}

// h_w = 1800, t = 14 mm: 24.00e6 mm^4 with a = 1000 mm, 3.704e6 mm^4 with a = 3000 mm. Source:
// EN 1993-1-5, 9.3.3(3), in muellvin/BA, proofs_and_stress_calculation.
TEST_CASE("muellvin/BA, EN 1993-1-5, 9.3.3(3): rigid stiffeners of a web of 1800 x 14 mm",
          "[validation]") {
  CHECK(rigid_stiffener_inertia(mm(1800), mm(14), mm(1000)).value() ==
        Approx(24.00e-6).epsilon(5e-4));
  CHECK(rigid_stiffener_inertia(mm(1800), mm(14), mm(3000)).value() ==
        Approx(3.704e-6).epsilon(5e-4));
  // The laws meet at a = sqrt(2) h_w, and a longer panel never asks for more.
  const double meet = 1800.0 * std::sqrt(2.0);
  CHECK(rigid_stiffener_inertia(mm(1800), mm(14), mm(meet * (1.0 - 1e-9))).value() ==
        Approx(rigid_stiffener_inertia(mm(1800), mm(14), mm(meet * (1.0 + 1e-9))).value()));
  double before = 1.0;
  for (double a = 500.0; a < 4000.0; a += 100.0) {
    const double least = rigid_stiffener_inertia(mm(1800), mm(14), mm(a)).value();
    CHECK(least <= before);
    before = least;
  }
}

TEST_CASE(
    "textbooks of welds: two transverse fillets as strong as their plate, a/t = f_y beta_w "
    "gamma_M2/(sqrt(2) f_u)",
    "[validation]") {
  // 0.46, 0.48 and 0.55 (f_u 510 MPa) for S235, S275 and S355 stand in textbooks; 0.60 for 470 MPa.
  struct Steel {
    double f_y, f_u, beta_w, ratio;
  };
  for (const Steel& steel : {Steel{235, 360, 0.8, 0.46}, Steel{275, 430, 0.85, 0.48},
                             Steel{355, 510, 0.9, 0.55}, Steel{355, 470, 0.9, 0.60}}) {
    const WeldStrength strength{MPa(steel.f_u), steel.beta_w, 1.25};
    const double t = 12.0;
    const WeldForce half{N_per_mm(0.5 * steel.f_y * t), N_per_mm(0), N_per_mm(0)};
    const double needed =
        5.0 * directional_utilisation(throat_stress_of(half, mm(5)), strength).largest();
    CHECK(needed / t == Approx(steel.ratio).margin(0.005));
  }
}

TEST_CASE("eurocodecalculations.com: 10 kN across 100 mm of 5 mm throat, 28.3 <= 417.8 MPa",
          "[validation]") {
  const WeldStrength S355{MPa(470), 0.9, 1.25};
  // S355, f_u 470 MPa, the throat at 45 degrees to the force.
  const ThroatStress stress = throat_stress_of({N_per_mm(100), N_per_mm(0), N_per_mm(0)}, mm(5));
  CHECK(equal_leg_stress(20.0, 0.0) == Approx(28.3).margin(0.05));
  CHECK(weld_strength(plainly, S355).value() == Approx(417.8e6).margin(0.05e6));
  CHECK(directional_utilisation(stress, S355).combined == Approx(28.3 / 417.8).epsilon(1e-3));
}

}  // namespace slender_plates_test
