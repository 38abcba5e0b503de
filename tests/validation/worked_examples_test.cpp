// Worked examples of textbooks, guides and other programs, each recomputed from its inputs to the
// digits that it prints. "Quoted by" stands where the source itself was not read.

#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_flow.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/strength/column_buckling.hpp"
#include "boxbeam/strength/compressed_section.hpp"
#include "boxbeam/strength/member_buckling.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/strength/shear_lag.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "catch.hpp"
#include "src/strength/column_formulas.hpp"

namespace worked_examples_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("shear lag: Hendy and Murphy, example 6.2-1, flange of a box girder in the span",
          "[validation]") {
  // Designers' Guide to EN 1993-2 (2007), worked example 6.2-1, as 1library.net has it: a span of
  // 80 m between two of 60 m, L_e = 0.7 x 80 m, stiffeners of half the plate's area.
  struct Row {
    double b_0, kappa, beta, in_service, at_limit;  // widths in mm
  };
  const Length L_e = si<Length>(0.7 * 80.0), t = mm(10.0);
  for (const Row& of :
       {Row{4000.0, 0.0875, 0.953, 3813.0, 3983.0}, Row{5000.0, 0.1094, 0.929, 4645.0, 4959.0}}) {
    CAPTURE(of.b_0);
    const Length b_0 = mm(of.b_0);
    REQUIRE(shear_lag_counts(b_0, L_e));
    const double kappa = shear_lag_kappa(b_0, t, 0.5 * b_0 * t, L_e);
    const double beta = shear_lag_factor(kappa, BendingRegion::sagging);
    CHECK(kappa == Approx(of.kappa).margin(5e-5));
    CHECK(beta == Approx(of.beta).margin(5e-4));
    CHECK(beta * of.b_0 == Approx(of.in_service).margin(0.6));
    // 3.3(1), note 3. Printed is 4959 with rounded factors, 4959.8 without.
    CHECK(std::pow(beta, kappa) * of.b_0 == Approx(of.at_limit).margin(1.0));
  }
}

TEST_CASE("torsion of tubes: Gere, problems 3.10-3 and 3.10-4", "[validation]") {
  // Gere, Mechanics of Materials, instructor's solutions (coursehero.com, file 5584203): b and h of
  // the mid-lines, T, L and G; I_T, the shear stress and the twist by Bredt, in SI here.
  constexpr double inch = 0.0254, psi = 6894.757, pound = 4.4482216;
  struct Tube {
    double b, h, t, torque, length, G;
    double I_T, stress, twist, digits;
  };
  for (const Tube& of :
       {Tube{6.0 * inch, 4.0 * inch, 0.25 * inch, 15e3 * pound * inch, 50.0 * inch, 4e6 * psi,
             28.8 * std::pow(inch, 4), 1250.0 * psi, 0.0065104, 1e-5},
        Tube{0.15, 0.1, 0.006, 1650.0, 1.2, 75e9, 10.8e-6, 9.17e6, 0.002444, 6e-4}}) {
    CAPTURE(of.b, of.torque);
    const auto node = [](double y, double z) { return SectionPlace{si<Length>(y), si<Length>(z)}; };
    const double y = 0.5 * of.b, z = 0.5 * of.h;
    const Length t = si<Length>(of.t);
    const Section tube{ThinWalled{{node(y, z), node(-y, z), node(-y, -z), node(y, -z)},
                                  {{0, 1, t}, {1, 2, t}, {2, 3, t}, {3, 0, t}}},
                       {}};
    const TorsionProperties torsion = torsion_properties_of(tube);
    REQUIRE(torsion.I_T);
    CHECK(torsion.enclosed.value() == Approx(of.b * of.h).epsilon(1e-12));
    // What the walls resist by themselves comes beside Bredt's: 0.4 % at most.
    const double walls = 2.0 * (of.b + of.h) * std::pow(of.t, 3) / 3.0;
    const double bredt = torsion.I_T->value() - walls;
    CHECK(walls < 4e-3 * bredt);
    CHECK(bredt == Approx(of.I_T).epsilon(1e-9));
    CHECK(of.torque * of.length / (of.G * bredt) == Approx(of.twist).epsilon(of.digits));
    const WallTorsion wall = wall_torsion_of(*shear_flow_of(tube, {}, {}), 0, 0.0);
    const double flow = std::abs(wall.flow) * torsion.I_T->value() / bredt;
    CHECK(of.torque * flow / of.t == Approx(of.stress).epsilon(of.digits));
  }
}

TEST_CASE("patch loading: an IPE 400 between stiffeners 3 m apart", "[validation]") {
  // FrameAI, web bearing and buckling (frameai-structural.polsia.app/tools/web-bearing-buckling):
  // S355, type a. The page does not say a and s_s; k_F asks for a = 3 m and l_y for s_s = 75 mm.
  PatchedWeb web;
  web.depth = mm(373.0);
  web.thickness = mm(8.6);
  web.yield_strength = web.flange_strength = MPa(355.0);
  web.flange_thickness = mm(13.5);
  web.flange_inside = web.flange_outside = mm(0.5 * (180.0 - 8.6));
  web.stiff_length = mm(75.0);
  web.length = mm(3000.0);
  const PatchResistance found = patch_resistance_of(web, 1.0);
  CHECK(found.k_F == Approx(6.031).margin(5e-4));
  CHECK(found.F_cr.value() == Approx(1943.7e3).margin(50.0));
  CHECK(found.m_1 == Approx(20.93).margin(5e-3));
  CHECK(found.m_2 == Approx(15.268).margin(5e-4));
  CHECK(found.l_y.value() == Approx(0.2644).margin(5e-5));
  CHECK(found.lambda_F == Approx(0.644).margin(5e-4));
  CHECK(found.chi_F == Approx(0.776).margin(5e-4));
  CHECK(found.resistance.value() == Approx(626.4e3).margin(60.0));
}

TEST_CASE("a web in shear: 1200 x 12 mm, a = 2 m, rigid end posts", "[validation]") {
  // The hand calculation of case PG1 in the tests of a public plate girder service
  // (test_plate_girder.py): S355, eta = 1. It prints lambda_w = 1.263 after rounding 37.4 x 0.8136
  // x 2.604 = 79.24 to 79.19, and 2063.4 kN where its own factors multiply to 2060.1 kN.
  const ShearPanel panel{mm(1200.0), mm(12.0), MPa(355.0), mm(2000.0), true};
  const ShearResistance found = shear_resistance_of(panel, 1.0);
  CHECK(found.k_tau == Approx(6.78).margin(5e-3));
  CHECK(found.lambda_w == Approx(1.263).margin(1.0e-3));
  CHECK(found.chi_w == Approx(0.698).margin(5e-4));
  CHECK(found.resistance.value() == Approx(0.698 * 355e6 * 0.0144 / std::sqrt(3.0)).epsilon(5e-4));
  CHECK(found.resistance.value() == Approx(2063.4e3).epsilon(1.4e-3));
  // Its flanges of 400 x 25 mm: I without their own bending, 9.231e9 mm^4.
  const auto place = [](double y, double z) { return SectionPlace{mm(y), mm(z)}; };
  const Section girder{
      Polygon{{place(200, 625), place(-200, 625), place(-200, 600), place(-6, 600), place(-6, -600),
               place(-200, -600), place(-200, -625), place(200, -625), place(200, -600),
               place(6, -600), place(6, 600), place(200, 600)}},
      {}};
  const SectionProperties properties = properties_of(girder);
  CHECK(properties.area.value() == Approx(34400e-6).epsilon(1e-9));
  CHECK(properties.I_y.value() == Approx(9.231e-3).epsilon(2e-4));
  CHECK(properties.W_y.value() * 355e6 == Approx(5243.4e3).epsilon(2e-4));
}

TEST_CASE("fillet welds: both sides of the web of an IPE 360, 200 kN along them", "[validation]") {
  // FrameAI, weld sizing (frameai-engineering.com/tools/weld-sizing): 298 mm on each side (the
  // depth between the fillets; printed beside it is 360 - 2 x 12.7, which is 334.6), S355 with
  // f_u = 510 MPa. Printed: 335.6 N/mm, a = 1.28 mm suffices, 42.8 % (42.7) at 3 mm.
  const WeldStrength S355{MPa(510.0), 0.9, 1.25};
  const WeldForce force{{}, {}, si<ForcePerLength>(200e3 / (2.0 * 0.298))};
  CHECK(force.along_weld.value() == Approx(335.6e3).margin(50.0));
  const auto use = [&](double throat) {
    return directional_utilisation(throat_stress_of(force, mm(throat)), S355).largest();
  };
  CHECK(use(3.0) == Approx(0.428).margin(1e-3));
  CHECK(use(1.28) == Approx(1.0).margin(4e-3));
  // f_vw.d = 261.73 MPa, 785.2 N/mm of a throat of 3 mm.
  CHECK(weld_shear_strength(S355).value() == Approx(261.73e6).margin(5e3));
  CHECK(3e-3 * weld_shear_strength(S355).value() == Approx(785.2e3).margin(50.0));
}

TEST_CASE("columns: critical forces, slenderness and resistances of four sources", "[validation]") {
  const Stress E = MPa(210e3);
  SECTION("HEB 340, S355, 4.335 m: 6067 kN, 0.39 and 0.75, 0.69, 4186.2 kN") {
    // Simões in Eurocodes: Design of steel buildings with worked examples (JRC, 2014), example 1,
    // quoted by the benchmarks of Alpaca4d; A, I_y and I_z of the profile's table. The last is with
    // chi rounded to 0.69.
    const Area A = si<Area>(170.9e-4);
    const auto slenderness = [&](double cm4) {
      return column::slenderness(plainly, A, MPa(355.0),
                                 euler_force(E, si<SecondMoment>(1e-8 * cm4), mm(4335.0)));
    };
    CHECK((A * MPa(355.0)).value() == Approx(6067e3).margin(500.0));
    CHECK(slenderness(36660.0) == Approx(0.39).margin(5e-3));
    const double chi = column::reduction(plainly, slenderness(9690.0), BucklingCurve::c);
    CHECK(slenderness(9690.0) == Approx(0.75).margin(5e-3));
    CHECK(chi == Approx(0.69).margin(5e-3));
    // Under 4186.2 kN, used up.
    const MemberLoad load{4186.2 / 6067.0, 0.0, std::pow(slenderness(9690.0), 2) * 4186.2 / 6067.0};
    CHECK(chi / 0.69 * flexural_use(load, BucklingCurve::c, 1.0) == Approx(1.0).epsilon(1e-4));
  }
  SECTION("CHS 244.5 x 10, S275, 4 m: 2026.8 kN, 0.56, 1836.5 kN") {
    // Autodesk Robot, Verification Manual Eurocodes, example 3 (after Gardner and Nethercot,
    // example 6.7), quoted by the validation of a public skill for steel supports.
    const Section tube{RoundTube{mm(244.5), mm(10.0)}, {}};
    const SectionProperties of = properties_of(tube);
    const Force critical = euler_force(E, of.I_y, mm(4000.0));
    CHECK((of.area * MPa(275.0)).value() == Approx(2026.8e3).epsilon(5e-4));
    CHECK(column::slenderness(plainly, of.area, MPa(275.0), critical) == Approx(0.56).margin(5e-3));
    const Force N = si<Force>(1836.5e3);
    const MemberLoad load{N / (of.area * MPa(275.0)), 0.0, N / critical};
    CHECK(flexural_use(load, BucklingCurve::a, 1.0) == Approx(1.0).epsilon(5e-4));
  }
  SECTION("IPE 500, 3.75 m: N_cr,z = 3156.6 kN") {
    // BuildSoft, DS EC 07 (support.buildsoft.eu), I_z = 21417007 mm^4.
    CHECK(euler_force(E, si<SecondMoment>(21417007e-12), mm(3750.0)).value() ==
          Approx(3156.6e3).margin(50.0));
  }
  SECTION("cantilever of 20 x 20 mm, 1 m: 6.90 kN") {
    // Altair SimSolid, verification manual, test VS16; its solid model has 6.904 kN.
    const SectionProperties of = properties_of({Plate{mm(20.0), mm(20.0)}, {}});
    CHECK(euler_force(E, of.I_y, mm(2000.0)).value() == Approx(6.90e3).epsilon(2e-3));
  }
}

TEST_CASE("SHS 150 x 6.3 of S355: class 1, 1271 kN", "[validation]") {
  // SCI P374, Worked Examples, Hollow Sections (2008), example 5, quoted by the tests of xcfem/xc.
  // A is 35.8 cm^2 there.
  const Section tube{RectangularTube{mm(150.0), mm(150.0), mm(6.3), mm(9.45), mm(6.3)}, {}};
  CHECK(class_of((150.0 - 3.0 * 6.3) / 6.3,
                 internal_part_limits(1.0, 1.0, epsilon_of(MPa(355.0)))) == 1);
  const CompressedSection pressed = compressed_section_of(tube, MPa(355.0));
  CHECK_FALSE(pressed.class_4);
  CHECK((pressed.effective * MPa(355.0)).value() == Approx(1271e3).epsilon(1e-3));
}

TEST_CASE("Miner's rule on a line with a bend: ball bearings at three loads", "[validation]") {
  // Modarres, Amiri, Jackson, Probabilistic Physics of Failure Approach to Reliability (2017), pp.
  // 33 to 37, as the manual of the Python package reliability recomputes it: lives of 50 000, 6500
  // and 1000 h at 1, 2 and 4 kN; 40, 15 and 5 min of each hour. Printed are 7400.37951 h and the
  // shares 9.86717, 28.463 and 61.66983 %. Hours stand for cycles here, kN for stress.
  SnCurve curve;
  curve.reference = MPa(4.0);
  curve.reference_cycles = 1000.0;
  curve.branches = {{std::log2(6500.0 / 1000.0), 6500.0},
                    {std::log2(50000.0 / 6500.0), std::numeric_limits<double>::infinity()}};
  const auto share = [&](double load, double minutes) {
    return damage_of({{MPa(load), {}, minutes / 60.0}}, curve, {});
  };
  const double all = damage_of(
      {{MPa(1.0), {}, 40.0 / 60.0}, {MPa(2.0), {}, 0.25}, {MPa(4.0), {}, 5.0 / 60.0}}, curve, {});
  CHECK(1.0 / all == Approx(7400.37951).epsilon(1e-9));
  CHECK(100.0 * share(1.0, 40.0) / all == Approx(9.86717).margin(5e-6));
  CHECK(100.0 * share(2.0, 15.0) / all == Approx(28.463).margin(5e-5));
  CHECK(100.0 * share(4.0, 5.0) / all == Approx(61.66983).margin(5e-6));
}

}  // namespace worked_examples_test
