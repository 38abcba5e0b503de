#include "boxbeam/strength/patch_loading.hpp"

#include <cmath>
#include <random>

#include "boxbeam/strength/column_buckling.hpp"
#include "catch.hpp"
#include "src/strength/column_formulas.hpp"

namespace patch_loading_test {

using namespace boxbeam;

namespace {

Length mm(double x) { return si<Length>(1e-3 * x); }
Stress MPa(double x) { return si<Stress>(1e6 * x); }

/// A web of one steel with its flange.
PatchedWeb web(double h_w, double t, double b_f, double t_f, double f_y, double s_s) {
  PatchedWeb of;
  of.depth = mm(h_w);
  of.thickness = mm(t);
  of.yield_strength = of.flange_strength = MPa(f_y);
  of.flange_thickness = mm(t_f);
  of.flange_inside = of.flange_outside = mm(0.5 * (b_f - t));
  of.stiff_length = mm(s_s);
  return of;
}

class Any {
 public:
  explicit Any(unsigned seed) : engine_(seed) {}
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  PatchedWeb web() {
    const double t = in(4.0, 16.0);
    PatchedWeb of = patch_loading_test::web(t * in(20.0, 200.0), t, t + in(50.0, 500.0),
                                            in(5.0, 40.0), in(235.0, 460.0), in(0.0, 300.0));
    of.flange_strength = MPa(in(235.0, 460.0));
    if (in(0.0, 1.0) < 0.7) of.length = of.depth * in(0.5, 6.0);
    const double entry = in(0.0, 3.0);
    of.entry = entry < 1.0   ? ForceEntry::one_flange
               : entry < 2.0 ? ForceEntry::both_flanges
                             : ForceEntry::near_end;
    of.to_end = mm(in(0.0, 400.0));
    return of;
  }

 private:
  std::mt19937 engine_;
};

double F_Rd(const PatchedWeb& of) { return patch_resistance_of(of, 1.0).resistance.value(); }

}  // namespace

TEST_CASE("patch loading: an IPE 400 under a wheel", "[validation]") {
  // Published by an open calculator (FrameAI, web bearing and buckling): S355, a = 3 m, s_s = 75
  // mm, h_w = 373 mm, t = 8.6 mm.
  PatchedWeb of = web(373.0, 8.6, 180.0, 13.5, 355.0, 75.0);
  of.length = mm(3000.0);
  const PatchResistance found = patch_resistance_of(of, 1.0);
  CHECK(found.k_F == Approx(6.031).margin(5e-4));
  CHECK(found.F_cr.value() == Approx(1943.7e3).epsilon(1e-4));
  CHECK(found.m_1 == Approx(20.93).margin(0.005));
  CHECK(found.m_2 == Approx(15.268).margin(5e-4));
  CHECK(found.l_y.value() == Approx(0.2644).margin(5e-5));
  CHECK(found.lambda_F == Approx(0.644).margin(5e-4));
  CHECK(found.chi_F == Approx(0.776).margin(5e-4));
  CHECK(found.resistance.value() == Approx(626.4e3).epsilon(2e-4));
}

TEST_CASE("patch loading: a box web of 1200 x 8 mm under a wheel") {
  // By pocket calculator: k_F = 6 + 2 0.16 = 6.32, F_cr = 0.9 6.32 210 000 512/1200 = 509.6 kN, b_f
  // = 26 + 8 + 15 0.8136 10 = 156.0 mm, m_1 = 19.5, m_2 = 288, l_y = 200 + 20 (1 + 17.54) = 570.7
  // mm, lambda_F = 1.783, F_Rd = 0.2804 355 570.7 8 = 454.5 kN.
  PatchedWeb of = web(1200.0, 8.0, 8.0, 10.0, 355.0, 200.0);
  of.flange_inside = mm(296.0);
  of.flange_outside = mm(26.0);
  of.length = mm(3000.0);
  CHECK(F_Rd(of) == Approx(454.5e3).epsilon(3e-4));
  CHECK(patch_resistance_of(of, 1.1).resistance.value() == Approx(454.5e3 / 1.1).epsilon(3e-4));
}

TEST_CASE("patch loading: a stout web is crushed, without m_2") {
  // chi_F = 1: f_y t l_y, l_y = 50 + 2 20 (1 + sqrt(200/20)).
  const PatchedWeb of = web(200.0, 20.0, 200.0, 20.0, 235.0, 50.0);
  const PatchResistance found = patch_resistance_of(of, 1.0);
  CHECK(found.chi_F == 1.0);
  CHECK(found.m_2 == 0.0);
  CHECK(found.resistance.value() ==
        Approx(235.0 * 20.0 * (50.0 + 40.0 * (1.0 + std::sqrt(10.0)))).epsilon(1e-12));
}

TEST_CASE("patch loading: properties that hold for every web") {
  Any any(7);
  for (int i = 0; i < 5000; ++i) {
    CAPTURE(i);
    const PatchedWeb of = any.web();
    const PatchResistance found = patch_resistance_of(of, 1.0);
    const double before = found.resistance.value();
    REQUIRE(before > 0.0);
    CHECK(found.chi_F <= 1.0);
    CHECK(found.k_F <=
          (of.length ? 6.0 + 2.0 * std::pow((of.depth / *of.length).value(), 2) : 6.0));

    // Size: all lengths so many times, the force the square of it.
    PatchedWeb scaled = of;
    for (Length* of_it :
         {&scaled.depth, &scaled.thickness, &scaled.flange_thickness, &scaled.flange_inside,
          &scaled.flange_outside, &scaled.stiff_length, &scaled.to_end})
      *of_it *= 3.0;
    if (scaled.length) *scaled.length *= 3.0;
    CHECK(F_Rd(scaled) == Approx(9.0 * before).epsilon(1e-12));

    // The beam's end is never better than no end, and a force that goes on through the web never
    // better than one that shear takes.
    PatchedWeb other = of;
    other.entry = ForceEntry::one_flange;
    if (of.entry == ForceEntry::both_flanges || !of.length) {
      // m_2 ends at lambda_F = 0.5, where the standard's resistance jumps.
      const bool same_side = (patch_resistance_of(other, 1.0).m_2 > 0.0) == (found.m_2 > 0.0);
      if (same_side) CHECK(before <= F_Rd(other) * (1.0 + 1e-12));
    }
    // Longer stiff lengths, shorter panels, wider flanges never take.
    const auto never_less = [&](const PatchedWeb& better) {
      const PatchResistance now = patch_resistance_of(better, 1.0);
      if ((now.m_2 > 0.0) == (found.m_2 > 0.0))
        CHECK(now.resistance.value() >= before * (1.0 - 1e-12));
    };
    other = of;
    other.stiff_length *= 1.1;
    never_less(other);
    other = of;
    other.flange_inside *= 1.2;
    never_less(other);
    // Thinner webs always do.
    other = of;
    other.thickness *= 0.95;
    const PatchResistance thinner = patch_resistance_of(other, 1.0);
    if ((thinner.m_2 > 0.0) == (found.m_2 > 0.0)) CHECK(thinner.resistance < found.resistance);
    other = of;
    if (other.length) *other.length *= 0.9;
    // Of a panel shorter than l_y that is all there is.
    if (of.length && found.l_y < *other.length) never_less(other);
  }
}

TEST_CASE("patch loading with the beam's own stress: 7.2") {
  CHECK(patch_factor(0.5, 0.0) == 2.0);
  // 1.4/(0.5 + 0.8) = 1.077 where both are whole and half.
  CHECK(patch_factor(0.5, 1.0) == Approx(1.4 / 1.3));
  // Up to eta_1 = 0.5 eta_2 the force alone decides.
  CHECK(patch_factor(0.8, 0.4) == Approx(1.25));
  CHECK(patch_factor(0.8, 0.41) < 1.25);
  CHECK(std::isinf(patch_factor(0.0, 0.9)));
}

TEST_CASE("a diaphragm bears a force with strips of the web as a column") {
  // By hand: S355, web 1200 x 8, diaphragm 10 mm, half of it 296 mm wide. 15 eps = 12.20: strips
  // 2 97.6 + 10 = 205.3 mm of the web, 122.0 mm of the diaphragm. A = 1642.2 + 1220.5 = 2862.6
  // mm^2, e = 1220.5 65.02/2862.6 = 27.72 mm from the web's middle; I = 205.3 8^3/12 +
  // 1642.2 27.72^2 + 10 122.0^3/12 + 1220.5 37.30^2 = 4.483e6 mm^4. N_cr = pi^2 210
  // 000 4.483e6/900^2 = 11.47 MN, lambda = sqrt(2862.6 355/11.47e6) = 0.2976, phi = 0.5682, chi =
  // 0.9505: 966 kN.
  BearingStiffener of;
  of.web_depth = mm(1200.0);
  of.web_thickness = mm(8.0);
  of.web_before = of.web_behind = mm(3000.0);
  of.thickness = mm(10.0);
  of.width = mm(296.0);
  of.yield_strength = MPa(355.0);
  CHECK(bearing_resistance_of(of, 1.0).value() == Approx(966e3).epsilon(1e-3));
  CHECK(bearing_resistance_of(of, 1.1).value() == Approx(966e3 / 1.1).epsilon(1e-3));
  // At the end of the beam one strip is missing: less area, never more force.
  of.web_before = {};
  CHECK(bearing_resistance_of(of, 1.0).value() < 0.9 * 966e3);
  // Without anything of the diaphragm beside the web the strip alone is a slender plate.
  of.width = {};
  const double slender = bearing_resistance_of(of, 1.0).value();
  const double strip = 15.0 * std::sqrt(235.0 / 355.0) * 8.0 + 10.0;
  const double N_cr = 9.8696044 * 210e3 * strip * 512.0 / 12.0 / (900.0 * 900.0);
  const double area = strip * 8.0;
  CHECK(slender ==
        Approx(area * 355.0 *
               column::reduction(plainly, std::sqrt(area * 355.0 / N_cr), BucklingCurve::c))
            .epsilon(1e-6));
}

TEST_CASE("flats on one side of a web bend as they are pressed: 6.61 by hand") {
  // S355, web 1200 x 6, a flat 150 x 16 on one side, flanges that may give way: 2 x 73.2 + 16 of
  // the web. n of N_b,Rd is where n + k_yy M/(W f_y) = 1 with M = N e, found by halving.
  BearingStiffener of;
  of.web_depth = mm(1200.0);
  of.web_thickness = mm(6.0);
  of.web_before = of.web_behind = mm(3000.0);
  of.thickness = mm(16.0);
  of.width = mm(150.0);
  of.yield_strength = MPa(355.0);
  of.ends_clamped = false;
  const double centric = bearing_resistance_of(of, 1.0).value();
  of.bows = true;
  const double strip = 30.0 * std::sqrt(235.0 / 355.0) * 6.0 + 16.0;
  const double web = strip * 6.0, flat = 150.0 * 16.0, A = web + flat;
  const double e = flat * 78.0 / A;
  const double I =
      strip * 18.0 + web * e * e + 16.0 * std::pow(150.0, 3) / 12.0 + flat * std::pow(78.0 - e, 2);
  const double W = I / std::max(e + 3.0, 153.0 - e);
  const double lambda = std::sqrt(A * 355.0 / (9.8696044 * 210e3 * I / 1.44e6));
  const double chi = column::reduction(plainly, lambda, BucklingCurve::c);
  CHECK(centric == Approx(chi * A * 355.0).epsilon(1e-6));
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double n = 0.5 * (low + high), N = n * chi * A * 355.0;
    const double k_yy = 1.0 + 0.6 * std::min(lambda, 1.0) * n;
    (n + k_yy * N * e / (W * 355.0) <= 1.0 ? low : high) = n;
  }
  CHECK(bearing_resistance_of(of, 1.0).value() == Approx(low * centric).epsilon(1e-6));
  // gamma_M1 stands in front of all of it.
  CHECK(bearing_resistance_of(of, 1.1).value() == Approx(low * centric / 1.1).epsilon(1e-6));
  CHECK(low < 0.6);
}

TEST_CASE("a stiffener under a force and what a web pulls at it: exactly used up") {
  const auto kN = [](double x) { return si<Force>(1e3 * x); };
  for (const double F : {0.0, 20.0, 300.0}) {
    for (const double V : {50.0, 400.0, 900.0}) {
      for (const double V_cr : {10.0, 300.0, 2000.0}) {
        const double f = stiffener_factor(kN(F), kN(V), kN(V_cr), kN(500.0));
        CHECK(f * F + std::max(0.0, f * V - V_cr) == Approx(500.0));
      }
    }
  }
  CHECK(stiffener_factor(kN(100.0), kN(0.0), kN(50.0), kN(500.0)) == Approx(5.0));
}

}  // namespace patch_loading_test
