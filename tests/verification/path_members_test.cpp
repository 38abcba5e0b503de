// Members of unsymmetric thin-walled paths, and loads on paths where they are easily overlooked.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/gates.hpp"
#include "support/path_cases.hpp"

namespace path_members_test {

using namespace boxbeam;
using test::blocks;
using namespace slender_cases;
using namespace path_cases;

namespace {

/// EN 1993-1-1, 6.3.1.2, curve c, and m beside it as 6.3.3 has it: n_cr the part of the critical
/// load.
double use_by_hand(double n, double m, double n_cr, double gamma) {
  const double lambda = std::sqrt(n_cr / n);
  const double chi = test::chi_of(lambda);
  return gamma * (n / chi + m);
}

}  // namespace

TEST_CASE("N beside the centroid bends the member: a channel pressed at its web", "[member]") {
  // 200 x 100 x 10, N = 300 kN at y = 0, the web's mid-line.
  const ThinWalled channel =
      path({{100, 100}, {0, 100}, {0, -100}, {100, -100}}, {{1, 0, 10}, {1, 2, 10}, {2, 3, 10}});
  const SectionProperties p = properties_of({channel, {}});
  const double e = std::abs(p.centroid_y.value()), N = 300e3, A = p.area.value(), f_y = 355e6;
  CHECK(e == Approx(0.025).epsilon(0.01));
  const Verification of =
      verified(simple_beam(4.0, section("a", channel), segment(4.0, "a"), held(4.0, 1),
                           force("press", 4.0, "[\"-300 kN\", \"0 kN\"]")));
  // About z by hand: N e on the farther edge, grown as the secant formula has it.
  const double I_z = p.I_z.value(), L = 4.0;
  const double n_cr = N * L * L / (std::numbers::pi * std::numbers::pi * 2.1e11 * I_z);
  const double m =
      N * e / (p.W_z.value() * f_y) / std::cos(0.5 * std::numbers::pi * std::sqrt(n_cr));
  const double use = use_by_hand(N / (A * f_y), m, n_cr, 1.1);
  CHECK(use > 1.0);
  CHECK(use_of(of, "member-buckling/across") == Approx(use).epsilon(0.02));
  CHECK(of.verdict == Verdict::fail);
}

TEST_CASE("where the axis of a case lies in the section is the same to its member", "[member]") {
  // A T with N at its flange, and the same with its nodes moved and N e as couples at the ends.
  const auto tee = [](double by) {
    return path({{150, by}, {0, by}, {-150, by}, {0, by - 240}},
                {{0, 1, 20}, {1, 2, 20}, {1, 3, 20}}, 10.0, 0.0, 2);
  };
  const double e = -properties_of({tee(0), {}}).centroid_z.value();
  REQUIRE(e > 0.05);
  const std::string held_near = held(3.0, 10);
  const std::string couple = fmt::format("{:.17g} N m", 900e3 * e);
  const Verification shifted =
      verified(simple_beam(3.0, section("a", tee(0)), segment(3.0, "a"), held_near,
                           force("press", 3.0, "[\"-900 kN\", \"0 kN\"]")));
  // N at the flange, above the centroid, bends as couples about y do.
  double direct = 0.0;
  for (const char* sign : {"", "-"}) {
    const std::string other = *sign == 0 ? "-" : "";
    const Verification of =
        verified(simple_beam(3.0, section("a", tee(1e3 * e)), segment(3.0, "a"), held_near,
                             force("press", 3.0, "[\"-900 kN\", \"0 kN\"]", other + couple) +
                                 force("turn", 0.0, "[\"0 kN\", \"0 kN\"]", sign + couple)));
    if (std::abs(use_of(of, "yield") / use_of(shifted, "yield") - 1.0) < 1e-6)
      direct = use_of(of, "member-buckling/in-the-plane");
  }
  REQUIRE(direct > 0.0);
  CHECK(use_of(shifted, "member-buckling/in-the-plane") >= direct * (1.0 - 1e-3));
  CHECK(use_of(shifted, "member-buckling/in-the-plane") <= direct * 1.1);
}

TEST_CASE("which flange is compressed decides how a beam turns over", "[member]") {
  // Flanges 400 x 25 above and 160 x 16 below, web 8; forks 8 m apart, uniform moment.
  const ThinWalled mono =
      path({{200, 400}, {0, 400}, {-200, 400}, {80, -400}, {0, -400}, {-80, -400}},
           {{0, 1, 25}, {1, 2, 25}, {1, 4, 8}, {3, 4, 16}, {4, 5, 16}}, 12.5, 8.0, 2);
  // By hand, EN 1993-1-1's M_cr with 1/I_z - 1/I_y for 1/I_z:
  //     pi^2 E I/L^2 (sqrt(z_j^2 + I_w/I + L^2 G I_T/(pi^2 E I)) +- z_j)
  const double E = 2.1e11, G = 8.1e10, L = 8.0, t1 = 0.025, t2 = 0.016, b1 = 0.4, b2 = 0.16;
  const SectionProperties p = properties_of({mono, {}});
  const double I_y = p.I_y.value(), I_z = p.I_z.value();
  const double I = 1.0 / (1.0 / I_z - 1.0 / I_y);
  const double I_T = torsion_properties_of({mono, {}}).I_T->value();
  const double up = t1 * b1 * b1 * b1 / 12, down = t2 * b2 * b2 * b2 / 12;
  const double z_s = 0.4 * (up - down) / (up + down), z_c = p.centroid_z.value();
  const double I_w = up * down / (up + down) * 0.8 * 0.8;
  // z_j = int z (y^2 + z^2) dA/(2 I_y) about the shear centre, over flanges and web.
  double sum = 0.0;
  const auto add = [&](double y, double z, double area) {
    sum += area * (z - z_c) * (y * y + (z - z_s) * (z - z_s));
  };
  constexpr int parts = 4000;
  for (int i = 0; i < parts; ++i) {
    const double x = (i + 0.5) / parts - 0.5;
    add(b1 * x, 0.4, t1 * b1 / parts);
    add(b2 * x, -0.4, t2 * b2 / parts);
    add(0.0, 0.8 * x, 0.008 * 0.8 / parts);
  }
  const double z_j = sum / (2.0 * I_y);
  CHECK(std::abs(z_j) == Approx(0.332).epsilon(0.02));
  const double euler = std::numbers::pi * std::numbers::pi * E * I / (L * L);
  const auto critical = [&](double sign) {
    return euler * (std::sqrt(z_j * z_j + I_w / I + G * I_T / euler) + sign * std::abs(z_j));
  };
  const auto part = [&](double kNm) {
    const std::string M = fmt::format("{} kN m", kNm), back = fmt::format("{} kN m", -kNm);
    const Verification of =
        verified(simple_beam(8.0, section("a", mono), segment(8.0, "a"), held(8.0, 1),
                             force("m1", 0.0, "[\"0 kN\", \"0 kN\"]", back) +
                                 force("m2", 8.0, "[\"0 kN\", \"0 kN\"]", M)));
    return of.model.second_order.lateral->part;
  };
  // M_y above zero stretches what lies at +z: the small flange is compressed.
  const double a = part(100.0), b = part(-100.0);
  CHECK(std::max(a, b) == Approx(100e3 / critical(-1.0)).epsilon(2e-2));
  CHECK(std::min(a, b) == Approx(100e3 / critical(1.0)).epsilon(2e-2));
}

TEST_CASE("E I_w counts where a section goes on, and nowhere in a taper", "[member]") {
  const auto part = [&](const std::string& sections, const std::string& segments) {
    const Verification of =
        verified(simple_beam(8.0, sections, segments, held(8.0, 1),
                             force("m1", 0.0, "[\"0 kN\", \"0 kN\"]", "-100 kN m") +
                                 force("m2", 8.0, "[\"0 kN\", \"0 kN\"]", "100 kN m")));
    return of.model.second_order.lateral->part;
  };
  // Flanges 300 x 20, web 600 x 12: pi/L sqrt(E I (G I_T + pi^2 E I_w/L^2)).
  const auto i_of = [](double b) {
    return path({{b, 310}, {0, 310}, {-b, 310}, {b, -310}, {0, -310}, {-b, -310}},
                {{0, 1, 20}, {1, 2, 20}, {1, 4, 12}, {3, 4, 20}, {4, 5, 20}}, 10.0, 10.0, 2);
  };
  const SectionProperties p = properties_of({i_of(150), {}});
  const double I = 1.0 / (1.0 / p.I_z.value() - 1.0 / p.I_y.value());
  const double GI_T = 8.1e10 * torsion_properties_of({i_of(150), {}}).I_T->value();
  const double pi = std::numbers::pi, L = 8.0;
  const double EI_w = 2.1e11 * 2.0 * 0.02 * std::pow(0.3, 3) / 12.0 * 0.31 * 0.31;
  const auto critical = [&](double warping) {
    return pi / L * std::sqrt(2.1e11 * I * (GI_T + pi * pi * warping / (L * L)));
  };
  const std::string one = section("a", i_of(150));
  const double whole = part(one, segment(8.0, "a"));
  CHECK(whole == Approx(100e3 / critical(EI_w)).epsilon(2e-3));
  CHECK(critical(EI_w) > 1.5 * critical(0.0));
  // The same section in two segments goes on.
  CHECK(part(one, segment(3.0, "a") + segment(5.0, "a")) == Approx(whole).epsilon(1e-4));
  // A little wider behind the middle: free to warp there, more than with it, less than without.
  const double stepped = part(one + section("b", i_of(151)), segment(4.0, "a") + segment(4.0, "b"));
  CHECK(stepped > 1.05 * whole);
  CHECK(stepped < 100e3 / critical(0.0));
  // In a taper it does not count.
  const double tapered = part(one + section("b", i_of(150.01)), taper(8.0, "a", "b"));
  CHECK(tapered == Approx(100e3 / critical(0.0)).epsilon(3e-3));
}

TEST_CASE("shear lag that is asked for counts in the member", "[member][lag]") {
  // A stout box 1000 x 400 x 35, 12 m, pressed by 2 MN, 200 kN in the middle: L_e = 12 m, kappa =
  // 0.4825/12, the force makes the peak: beta_2 of table 3.1, beta_2^kappa of the flanges' clear
  // width.
  const auto bent = [&](bool lag) {
    Project project =
        parse_project("slender.toml", simple_beam(12.0, box("a", 1000.0, 400.0, 35.0, 35.0),
                                                  segment(12.0, "a"), held(12.0, 1),
                                                  force("press", 12.0, "[\"-2000 kN\", \"0 kN\"]") +
                                                      force("p", 6.0, "[\"0 kN\", \"-200 kN\"]")));
    project.strength.shear_lag = lag;
    const Verification of = verify(project);
    for (const CheckResult& result : of.checks)
      if (result.check.id.starts_with("member-buckling/in-the-plane")) return result.member->load;
    return MemberLoad{};
  };
  const MemberLoad without = bent(false), with = bent(true);
  REQUIRE(without.bent > 0.0);
  const double kappa = 0.4825 / 12.0;
  const double beta = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  const double works = 0.07 + std::pow(beta, kappa) * 0.93;
  const auto modulus = [](double width) {
    return 2.0 * (width * std::pow(0.035, 3) / 12.0 + width * 0.035 * 0.1825 * 0.1825) +
           0.07 * std::pow(0.33, 3) / 12.0;
  };
  const double hand = modulus(1.0) / modulus(works);
  CHECK(hand > 1.005);
  CHECK(with.bent / without.bent == Approx(hand).epsilon(1e-4));
  CHECK(with.compressed == without.compressed);
  // Of a girder of class 4, whose webs have effective widths at the mid-lines of flanges anyway.
  const ThinWalled girder =
      path({{175, 608}, {0, 608}, {-175, 608}, {175, -608}, {0, -608}, {-175, -608}},
           {{0, 1, 16}, {1, 2, 16}, {1, 4, 8}, {3, 4, 16}, {4, 5, 16}}, 8.0, 8.0, 2);
  const auto of_girder = [&](bool lag) {
    Project project =
        parse_project("slender.toml", simple_beam(6.0, section("a", girder), segment(6.0, "a"),
                                                  held(6.0, 1) + diaphragms({3.0}),
                                                  force("p", 3.0, "[\"0 kN\", \"-300 kN\"]")));
    project.strength.shear_lag = lag;
    const Verification of = verify(project);
    double use = 0.0;
    for (const CheckResult& result : of.checks)
      if (result.member && result.member->turns_over) use = result.member->load.bent;
    // No less than the effective section is used at the middle.
    CHECK(use >= use_of(of, "effective-section") * (1.0 - 1e-6));
    return use;
  };
  const double girder_without = of_girder(false), girder_with = of_girder(true);
  REQUIRE(girder_without > 0.0);
  const double k = 0.175 / 6.0;
  const double b2 = 1.0 / (1.0 + 6.0 * (k - 1.0 / (2500.0 * k)) + 1.6 * k * k);
  CHECK(girder_with > girder_without);
  CHECK(girder_with <= girder_without / std::pow(b2, k));
}

TEST_CASE("a small cell does not keep a cross from twisting", "[member]") {
  // Fins 8 mm around a cell of 20 x 20 x 4 mm, 2 m, N = 850 kN.
  const ThinWalled cross = path(
      {{10, 10}, {-10, 10}, {-10, -10}, {10, -10}, {210, 10}, {-10, 210}, {-210, -10}, {10, -210}},
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 4, 8}, {1, 5, 8}, {2, 6, 8}, {3, 7, 8}});
  const SectionProperties p = properties_of({cross, {}});
  const TorsionProperties torsion = torsion_properties_of({cross, {}});
  const double polar = (p.I_y + p.I_z).value() / p.area.value();
  const double critical = 8.1e10 * torsion.I_T->value() / polar;
  const Verification of =
      verified(simple_beam(2.0, section("a", cross), segment(2.0, "a"), held(2.0, 1),
                           force("press", 2.0, "[\"-850 kN\", \"0 kN\"]")));
  CHECK(850e3 / critical > 0.3);
  REQUIRE(use_of(of, "member-buckling/by-twisting") > 0.0);
  CHECK(use_of(of, "member-buckling/by-twisting") >=
        use_by_hand(850e3 / (p.area.value() * 355e6), 0.0, 850e3 / critical, 1.1) * (1.0 - 1e-2));
}

namespace {

const ThinWalled thin_web =
    path({{150, 400}, {0, 400}, {-150, 400}, {150, -400}, {0, -400}, {-150, -400}},
         {{0, 1, 20}, {1, 2, 20}, {1, 4, 4}, {3, 4, 20}, {4, 5, 20}}, 10.0, 10.0, 2);
const ThinWalled thick_web =
    path({{150, 400}, {0, 400}, {-150, 400}, {150, -400}, {0, -400}, {-150, -400}},
         {{0, 1, 20}, {1, 2, 20}, {1, 4, 14}, {3, 4, 20}, {4, 5, 20}}, 10.0, 10.0, 2);

double patch_use(const Verification& of) { return use_of(of, "patch-loading"); }

std::string line(const std::string& name, double from, double to, double kN_per_m) {
  return fmt::format(
      "[loads.{}]\nkind = \"line\"\nfrom = \"{} m\"\nto = \"{} m\"\nforce_per_length = [\"0 "
      "kN/m\", \"{} "
      "kN/m\"]\n",
      name, from, to, kN_per_m);
}

}  // namespace

TEST_CASE("a load along the whole beam comes into its thinnest web, too", "[patch]") {
  const std::string sections = section("thin", thin_web) + section("thick", thick_web);
  const std::string segments = segment(2.5, "thick") + segment(1.0, "thin") + segment(2.5, "thick");
  const std::string more = held(6.0, 30) + diaphragms({0.0, 6.0});
  const double part =
      patch_use(verified(simple_beam(6.0, sections, segments, more, line("a", 2.5, 3.5, -235.0))));
  const double whole =
      patch_use(verified(simple_beam(6.0, sections, segments, more, line("a", 0.0, 6.0, -235.0))));
  CHECK(part > 0.9);
  // With the moment of the whole load, more.
  CHECK(whole >= part);
}

TEST_CASE("a flange between two webs leads a force in by its own width alone", "[patch]") {
  // Above 800 mm wide, below only between the webs.
  const ThinWalled hat =
      path({{400, 400}, {50, 400}, {-50, 400}, {-400, 400}, {50, -400}, {-50, -400}},
           {{1, 2, 40}, {0, 1, 40}, {2, 3, 40}, {1, 4, 8}, {2, 5, 8}, {4, 5, 40}});
  const ThinWalled without = path({{50, 400}, {-50, 400}, {50, -400}, {-50, -400}},
                                  {{0, 1, 40}, {0, 2, 8}, {1, 3, 8}, {2, 3, 40}});
  const auto resistance = [&](const ThinWalled& of, double kN) {
    const Verification found =
        verified(simple_beam(3.0, section("a", of), segment(3.0, "a"),
                             held(3.0, 10) + diaphragms({0.0, 3.0}) +
                                 "[[beam.load_introductions]]\nfrom = \"1 m\"\nto = \"2 "
                                 "m\"\nstiff_length = \"100 mm\"\n",
                             force("hook", 1.5, fmt::format("[\"0 kN\", \"{} kN\"]", kN))));
    for (const CheckResult& result : found.checks)
      if (result.check.criterion == Criterion::patch_loading &&
          result.check.point.ends_with(" under hook"))
        return result.patch->resistance.value();
    return 0.0;
  };
  // From below, the flange above is of no account.
  REQUIRE(resistance(without, 400.0) > 0.0);
  CHECK(resistance(hat, 400.0) == Approx(resistance(without, 400.0)).epsilon(1e-9));
  CHECK(resistance(hat, -400.0) > 1.01 * resistance(without, -400.0));
}

TEST_CASE("a force with a couple at a free end is no clamp", "[patch]") {
  const ThinWalled web =
      path({{150, 400}, {0, 400}, {-150, 400}, {150, -400}, {0, -400}, {-150, -400}},
           {{0, 1, 20}, {1, 2, 20}, {1, 4, 6}, {3, 4, 20}, {4, 5, 20}}, 10.0, 10.0, 2);
  const auto cantilever = [&](const std::string& moment) {
    return verified(
        "[case]\nname = \"path\"\nkind = \"static\"\n[frame]\n"
        "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
        section("a", web) + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segment(4.0, "a") +
        held(4.0, 20) + "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n" +
        force("h", 4.0, "[\"0 kN\", \"-200 kN\"]", moment) + steel +
        "[strength]\nrequired = 1.0\nshear_lag = false\ngamma_M1 = 1.1\n");
  };
  for (const char* moment : {"", "100 kN m", "-500 kN m"}) {
    CAPTURE(moment);
    CHECK(blocks(cantilever(moment), "it takes 200 kN of \"h\""));
  }
}

TEST_CASE("shear lag that is asked for stops a path that does not count it", "[lag]") {
  const ThinWalled box = path({{500, 250}, {-500, 250}, {-500, -250}, {500, -250}},
                              {{0, 1, 40}, {1, 2, 20}, {2, 3, 40}, {3, 0, 20}});
  std::string text = simple_beam(5.0, section("a", box), segment(5.0, "a"), held(5.0, 1),
                                 force("p", 2.5, "[\"0 kN\", \"-500 kN\"]"));
  CHECK_FALSE(blocks(verified(text), "shear lag"));
  text.replace(text.find("shear_lag = false"), 17, "shear_lag = true");
  CHECK(blocks(verified(text), "shear lag counts"));
}

}  // namespace path_members_test
