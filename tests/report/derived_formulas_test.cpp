// Each formula with a recorder against the same formula without, over random values; and every
// printed step against a pocket calculator.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/range_limit.hpp"
#include "boxbeam/fatigue/reduced_range.hpp"
#include "boxbeam/fatigue/sn_corners.hpp"
#include "boxbeam/section/equivalent_stress.hpp"
#include "boxbeam/section/level_shear.hpp"
#include "boxbeam/section/nominal_stress.hpp"
#include "boxbeam/section/plain_box.hpp"
#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/hole_concentration.hpp"
#include "boxbeam/strength/pin.hpp"
#include "boxbeam/strength/rod.hpp"
#include "boxbeam/strength/shear_lag.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/strength/yield.hpp"
#include "catch.hpp"
#include "support/derivation_check.hpp"

namespace derived_formulas_test {

using namespace boxbeam;

namespace {

/// Numbers between two bounds, the same in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution(low, high)(engine_);
  }
  /// Of few digits, as partial factors are.
  double factor(double low, double high) { return std::round(100.0 * (*this)(low, high)) / 100.0; }

 private:
  std::mt19937 engine_;
};

/// The value that a derivation gives a symbol; nothing where it has none.
std::optional<double> value_in(const Derivation& steps, const std::string& symbol) {
  for (const DerivationStep& step : steps.steps()) {
    if (step.symbol == symbol) return step.value.value();
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("The derivation of a pin comes to the utilisation that decides its check") {
  Random between(1);
  for (int i = 0; i < 200; ++i) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    const auto MPa = [&] { return si<Stress>(1e6 * between(200.0, 900.0)); };
    const PinJoint joint{mm(10, 200), mm(10, 200), mm(5, 80), mm(5, 80), mm(0, 10)};
    const PinStrength strength{
        MPa(), MPa(), MPa(), MPa(), between.factor(1.0, 1.2), between.factor(1.0, 1.5)};
    const Force force = si<Force>(between(1e2, 1e6));
    Derivation steps;
    derive_pin_factor(steps, steps.given("F", force), joint, strength);
    const double factor = 1.0 / governing_utilisation(pin_utilisation(force, joint, strength));
    CHECK(steps.steps().back().value.value() == factor);
    test::check_derivation(steps);
  }
}

TEST_CASE("The derivation of a replaceable pin comes to the utilisation that decides its check") {
  Random between(11);
  for (int i = 0; i < 200; ++i) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    const auto MPa = [&] { return si<Stress>(1e6 * between(200.0, 900.0)); };
    const Length d = mm(10, 200);
    const PinJoint joint{d, d + mm(0.1, 2), mm(5, 80), mm(5, 80), mm(0, 10)};
    const PinStrength strength{MPa(), MPa(), MPa(), MPa(), 1.0, 1.25, between.factor(1.0, 1.2)};
    const Force force = si<Force>(between(1e2, 1e6));
    const Stress E = 210e9 * pascal;
    Derivation steps;
    derive_replaceable_pin_factor(steps, steps.given("F", force), E, joint, strength);
    const auto use = replaceable_pin_utilisation(force, E, joint, strength);
    CHECK(steps.steps().back().value.value() ==
          Approx(1.0 / governing_utilisation(use)).epsilon(1e-14));
    test::check_derivation(steps);
    // It is a factor on the force: with it the joint is just used up.
    const Force most = force / governing_utilisation(use);
    const auto used_up = replaceable_pin_utilisation(most, E, joint, strength);
    CHECK(std::max({used_up.bearing_inner, used_up.bearing_outer, used_up.bending,
                    used_up.contact_inner, used_up.contact_outer}) == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("The derivation of a rod comes to the resistance that decides its check") {
  Random between(2);
  int of_class_4 = 0, stout = 0, no_reduction = 0;
  for (int i = 0; i < 300; ++i) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    const Stress f_y = si<Stress>(1e6 * between(200.0, 500.0));
    const Force force = si<Force>(between(1e2, 1e6));
    const PulledRod pulled{
        si<Area>(between(1e-4, 1e-2)),
        i % 2 == 0 ? std::optional(si<Area>(between(1e-4, 1e-2))) : std::nullopt,
        f_y,
        f_y * between(1.05, 1.5),
        between.factor(1.0, 1.2),
        between.factor(1.0, 1.5),
        i % 4 == 1 ? std::optional(EccentricForce{mm(0, 50), mm(0, 50),
                                                  si<SectionModulus>(between(1e-5, 1e-3)),
                                                  si<SectionModulus>(between(1e-5, 1e-3))})
                   : std::nullopt};
    Derivation tension;
    derive_tension_factor(tension, tension.given("N", force), pulled);
    CHECK(tension.steps().back().value.value() == tension_resistance_of(pulled).least / force);
    test::check_derivation(tension);

    PressedRod pressed;
    pressed.section = compressed_section_of(
        {symmetric_box(mm(100, 600), mm(100, 600), mm(2, 30), mm(2, 30)), {}}, f_y);
    pressed.inertia = si<SecondMoment>(between(1e-6, 1e-3));
    pressed.buckling_length = mm(500, 9000);
    pressed.youngs_modulus = 210e9 * pascal;
    pressed.yield_strength = f_y;
    pressed.curve = static_cast<BucklingCurve>(i % 5);
    pressed.gamma_M0 = between.factor(0.9, 1.3);
    if (i % 3 == 0) {
      const auto N = [&] { return si<Force>(between(1e5, 1e8)); };
      pressed.twisting = TwistingRod{N(), N(), N(), mm(500, 9000), between(0.0, 0.6)};
    }
    if (i % 4 == 0)
      pressed.beside = EccentricForce{mm(0, 50), mm(0, 50), si<SectionModulus>(between(1e-5, 1e-3)),
                                      si<SectionModulus>(between(1e-5, 1e-3))};
    const CompressionResistance resistance = compression_resistance_of(pressed);
    of_class_4 += pressed.section.class_4 ? 1 : 0;
    stout += resistance.least < resistance.buckling ? 1 : 0;
    no_reduction += resistance.reduction == 1.0 ? 1 : 0;
    Derivation compression;
    derive_compression_factor(compression, compression.given("N", force), pressed);
    CHECK(compression.steps().back().value.value() == resistance.least / force);
    test::check_derivation(compression);
  }
  CHECK(of_class_4 > 30);
  CHECK(stout > 10);
  CHECK(no_reduction > 10);
}

TEST_CASE("Limits of stresses are the same with a recorder as without") {
  Random between(3);
  for (int i = 0; i < 200; ++i) {
    const Stress f = si<Stress>(between(200e6, 900e6)), high = si<Stress>(between(-3e8, 3e8)),
                 low = si<Stress>(high.value() - between(1e6, 4e8));
    const double gamma = between.factor(1.0, 1.4);
    const WeldStrength weld{f, between.factor(0.8, 1.0), gamma};
    Derivation steps;
    const Traced f_y = steps.given("f_y", f);
    const Traced sigma_max = steps.given("sigma_max", high),
                 sigma_min = steps.given("sigma_min", low);
    steps.define("a", yield_resistance(steps, f_y, gamma));
    steps.define("b", range_limit(steps, f_y, StressKind::direct));
    steps.define("c", range_limit(steps, f_y, StressKind::shear));
    steps.define("d", equivalent_stress(sigma_max, sigma_min));
    steps.define("e", equal_leg_stress(sigma_max, sigma_min));
    const Traced range = steps.define("r", sigma_max - sigma_min);
    steps.define("d_sigma_red", reduced_range(sigma_max, sigma_min, range));
    CHECK(value_in(steps, "a") == yield_resistance(plainly, f, gamma).value());
    CHECK(value_in(steps, "b") == range_limit(plainly, f, StressKind::direct).value());
    CHECK(value_in(steps, "c") == range_limit(plainly, f, StressKind::shear).value());
    CHECK(value_in(steps, "d") == equivalent_stress(high.value(), low.value()));
    CHECK(value_in(steps, "e") == equal_leg_stress(high.value(), low.value()));
    CHECK(value_in(steps, "d_sigma_red") ==
          reduced_range(high.value(), low.value(), high.value() - low.value()));
    CHECK(weld_strength(steps, weld).value() == weld_strength(plainly, weld).value());
    CHECK(weld_shear_strength(steps, weld).value() == weld_shear_strength(weld).value());
    test::check_derivation(steps);
  }
}

TEST_CASE("What bears in a throat by equal legs is what the directional method leaves") {
  // EN 1993-1-8, equation 4.1, its first condition, by throat stresses of their own.
  Random between(4);
  for (int i = 0; i < 50; ++i) {
    const double sigma_w = between(-3e8, 3e8), tau = between(-3e8, 3e8);
    const Stress across = si<Stress>(sigma_w / std::numbers::sqrt2);
    const WeldStrength weld{si<Stress>(between(360e6, 600e6)), between.factor(0.8, 1.0), 1.25};
    const auto use = directional_utilisation({across, across, si<Stress>(tau)}, weld);
    CHECK(equal_leg_stress(sigma_w, tau) / weld_strength(plainly, weld).value() ==
          Approx(use.combined).epsilon(1e-12));
    const auto alone = directional_utilisation({{}, {}, si<Stress>(tau)}, weld);
    CHECK(std::abs(tau) / weld_shear_strength(weld).value() ==
          Approx(alone.combined).epsilon(1e-12));
  }
}

TEST_CASE("The stress at a hole's edge is derived as it is found, wherever on the edge") {
  Random between(5);
  int shears = 0, lags = 0;
  for (int i = 0; i < 60; ++i) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    const Section section{symmetric_box(mm(200, 500), mm(300, 700), mm(10, 60), mm(8, 40)), {}};
    Hole hole;
    hole.name = "hub";
    hole.walls = i % 3 == 2 ? HoleWalls::flanges : HoleWalls::webs;
    hole.diameter = mm(20, 120);
    hole.position = i % 3 == 0 ? Length{} : i % 3 == 1 ? mm(-40, 40) : mm(61, 80);
    const std::vector<Hole> holes{hole};
    EdgeBasis basis;
    basis.hole_case = i % 3 == 2 ? HoleCase::membrane_tension : HoleCase::in_plane_bending;
    basis.walls = hole.walls;
    basis.diameter = hole.diameter;
    basis.plate_width = plate_width_of(section, holes, hole, basis.hole_case);
    basis.position = hole.position;
    basis.gross = properties_of(section);
    basis.net = properties_of(section, holes);
    basis.effective_I = basis.net.I_y;
    if (i % 2 == 0) basis.effective_I *= 0.95;
    const double lag = basis.net.I_y / basis.effective_I;
    const std::vector<HoleEdge> edges = hole_edges_of(section, holes, {}, hole, basis.hole_case);
    const HoleEdge& edge =
        edges[static_cast<std::size_t>(between(0.0, 0.999) * static_cast<double>(edges.size()))];
    basis.angle = edge.angle;
    basis.y = edge.y;
    basis.z = edge.z;
    basis.around = edge.around;
    Derivation steps;
    derive_edge_stress(steps, basis);
    const auto& found = edge.influence.normal;
    // Where it is round-off, no step is made.
    const auto near = [&](const char* symbol, double wanted, double size) {
      return std::abs(value_in(steps, symbol).value_or(0.0) - wanted) <= 1e-9 * size;
    };
    const double A = basis.gross.area.value(), I = basis.gross.I_y.value();
    CHECK(near("k_N", found[cut_force::N], 1.0 / A));
    CHECK(near("k_M", lag * found[cut_force::M_y], basis.plate_width.value() / I));
    CHECK(near("k_V", found[cut_force::V_z], 1.0 / A));
    shears += value_in(steps, "k_V").has_value() ? 1 : 0;
    lags += value_in(steps, "k_lag").has_value() ? 1 : 0;
    test::check_derivation(steps, {"sigma_edge"});
  }
  CHECK(shears > 10);
  CHECK(lags > 10);
}

TEST_CASE("Shear lag is derived as table 3.1 has it, with stiffeners and without") {
  Random between(6);
  int reduced = 0;
  for (int i = 0; i < 200; ++i) {
    const WidePlate plate{si<Length>(between(0.05, 2.0)), si<Length>(between(0.005, 0.05)),
                          si<Area>(i % 2 == 0 ? 0.0 : between(1e-4, 2e-2)),
                          si<Length>(between(0.5, 20.0)), static_cast<BendingRegion>(i % 4)};
    Derivation steps;
    const Traced beta = derive_shear_lag(steps, plate, "flanges", "_web");
    const double kappa =
        shear_lag_kappa(plate.b_0, plate.thickness, plate.stiffeners, plate.effective_length);
    CHECK(value_in(steps, "kappa_web").value() == Approx(kappa).epsilon(1e-14));
    CHECK(beta.value() == Approx(shear_lag_factor(kappa, plate.region)).epsilon(1e-13));
    reduced += beta < 1.0 ? 1 : 0;
    test::check_derivation(steps);
  }
  CHECK(reduced > 100);
}

TEST_CASE("A plain box by formulas of a few letters is what its border encloses") {
  Random between(7);
  for (int i = 0; i < 100; ++i) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    const Section section{symmetric_box(mm(200, 500), mm(300, 700), mm(10, 60), mm(8, 40)), {}};
    const PlainBox box = plain_box_of(section).value();
    const double part = between(0.3, 1.0), web_part = i % 2 == 0 ? 1.0 : between(0.3, 1.0);
    Derivation steps;
    const TracedSection whole = derive_plain_box(steps, box, true);
    const SectionProperties gross = properties_of(section);
    CHECK(whole.A.value() == Approx(gross.area.value()).epsilon(1e-12));
    CHECK(whole.I_y.value() == Approx(gross.I_y.value()).epsilon(1e-12));
    CHECK(whole.I_z.value() == Approx(gross.I_z.value()).epsilon(1e-12));
    const Traced b_i = steps.given("b_i", Length((1.0 - part) * box.b));
    const Traced h_i =
        web_part == 1.0 ? Traced(0.0) : steps.given("h_i", Length((1.0 - web_part) * box.h));
    derive_box_less_strips(steps, box, whole, b_i, h_i, true);
    const SectionProperties net = properties_of(section, {}, part, web_part);
    CHECK(value_in(steps, "A_eff").value() == Approx(net.area.value()).epsilon(1e-12));
    CHECK(value_in(steps, "I_y,eff").value() == Approx(net.I_y.value()).epsilon(1e-12));
    CHECK(value_in(steps, "I_z,eff").value() == Approx(net.I_z.value()).epsilon(1e-12));
    test::check_derivation(steps);
  }
  CHECK_FALSE(plain_box_of({Plate{si<Length>(0.1), si<Length>(0.2)}, {}}).has_value());
}

TEST_CASE("Strengths and lives are derived as the curve has them") {
  Random between(8);
  SnCurve endless = en_1993_1_9_direct(90);
  endless.branches = {{3.0, 1e7}, {5.0, std::numeric_limits<double>::infinity()}};
  endless.constant_amplitude_limit.reset();
  endless.cut_off.reset();
  for (int i = 0; i < 300; ++i) {
    const SnCurve curve = scaled(i % 3 == 0   ? en_1993_1_9_direct(71)
                                 : i % 3 == 1 ? en_1993_1_9_shear(80)
                                              : endless,
                                 between(0.7, 1.0));
    const Loading loading = i % 2 == 0 ? Loading::spectrum : Loading::constant_amplitude;
    const double cycles = std::pow(10.0, i % 5 + 4) * between.factor(1.0, 9.99);
    Derivation steps;
    steps.given({symbol_of(curve), "_C"}, curve.reference);
    derive_corners(steps, curve);
    const Traced strength = derive_strength(steps, curve, cycles, loading);
    CHECK(strength.value() == Approx(strength_at(curve, cycles, loading).value()).epsilon(1e-13));
    if (curve.cut_off)
      CHECK(value_in(steps, symbol_of(curve) + "_L").value() ==
            Approx(cut_off_of(curve).value()).epsilon(1e-13));
    const Stress range = si<Stress>(between(1.01, 4.0) * strength_at(curve, 9e7, loading).value());
    const double N = cycles_to_failure(curve, range, loading);
    if (std::isfinite(N)) {
      const Traced endured = derive_endurance(steps, curve, "N_1", steps.given("d", range), N);
      CHECK(endured.value() == Approx(N).epsilon(1e-12));
    }
    const double damage = between(1e-4, 2.0);
    const Traced gamma = steps.known("gamma_Mf", between.factor(1.0, 1.4), {ValueKind::factor});
    steps.given("D", damage, {ValueKind::share});
    derive_equivalent_range(steps, curve, damage, gamma);
    const FatigueDemand demand{Loading::spectrum, 1.0, gamma.value()};
    CHECK(steps.steps().back().value.value() ==
          Approx(equivalent_range(damage, curve, demand).value()).epsilon(1e-13));
    test::check_derivation(steps);
  }
}

TEST_CASE("Stresses in a few letters are those of the influences that are verified") {
  Random between(9);
  for (int i = 0; i < 60; ++i) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    const Section section{symmetric_box(mm(200, 500), mm(300, 700), mm(10, 60), mm(8, 40)), {}};
    const SectionProperties of = properties_of(section);
    const StressField field = stress_field_of(section, {}, {});
    CutForces cut;
    cut.N = si<Force>(between(-1e5, 1e5));
    cut.M_y = si<Moment>(between(-1e5, 1e5));
    cut.M_z = si<Moment>(between(-1e5, 1e5));
    int walls = 0;
    for (const SectionPoint& place : points_of(field, PointSet::in_space)) {
      Derivation steps;
      const Traced sigma = steps.define(
          "sigma", bending_stress(steps.given("N", cut.N), steps.given("A", of.area),
                                  steps.given("M_y", cut.M_y), steps.given("z", place.z),
                                  steps.given("I_y", of.I_y), steps.given("M_z", cut.M_z),
                                  steps.given("y", place.y), steps.given("I_z", of.I_z)));
      CHECK(sigma.value() == Approx(stress_at(place.influence, cut).normal.value()).epsilon(1e-9));
      if (place.torsion) {
        const WallTorsion& torsion = *place.torsion;
        const Length t = si<Length>(torsion.thickness);
        const SecondMoment I_T = si<SecondMoment>(torsion.I_T), I_w = si<SecondMoment>(torsion.I_w);
        const double bredt = cell_shear(I_w, I_T, si<Area>(torsion.enclosed), t).value();
        CHECK(bredt == Approx(std::abs(torsion.flow) / torsion.thickness).epsilon(1e-9));
        CHECK(face_shear(t, I_T).value() == Approx(std::abs(torsion.face)).epsilon(1e-9));
        steps.define("c_TB", cell_shear(steps.given("I_w", I_w), steps.given("I_T", I_T),
                                        steps.given("A_m", si<Area>(torsion.enclosed)),
                                        steps.given("t", t)));
        ++walls;
      }
      test::check_derivation(steps);
    }
    CHECK(walls > 0);
    const Length level = mm(-100, 100);
    const LevelMoment beyond = moment_beyond_level(section, {}, level);
    CHECK(level_shear_stress(1.0 * newton, beyond.S, of.I_y, beyond.b).value() ==
          Approx(level_shear_of(section, {}, {}, level.value())[cut_force::V_z]).epsilon(1e-9));
  }
}

}  // namespace derived_formulas_test
