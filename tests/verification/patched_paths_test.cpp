// Forces that come into the walls of thin-walled paths: a box as a path against the box, a girder
// by hand and against all instants looked at one by one, and what must not be judged so.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/path_cases.hpp"

namespace patched_paths_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::girder;
using path_cases::held;
using path_cases::section;

namespace {

std::string introduction(double from, double to, double stiff_length) {
  return fmt::format(
      "[[beam.load_introductions]]\nfrom = \"{} m\"\nto = \"{} m\"\nstiff_length = \"{} mm\"\n",
      from, to, stiff_length);
}

std::string force(const std::string& name, double at, double kN) {
  return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"{} kN\"]\n",
                     name, at, kN);
}

/// A weightless beam of 9 m on two supports, held against buckling.
std::string beam(const std::string& sections, const std::string& more, const std::string& loads,
                 const std::string& segments = segment(9.0, "a")) {
  return "[case]\nname = \"path\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments + held(9.0, 30) + more +
         "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
         loads + steel + "[strength]\nrequired = 1.0\nshear_lag = false\ngamma_M1 = 1.1\n";
}

/// A cantilever in space of 6 m with a force at a hook beside its axis.
std::string hooked(const std::string& sections, const std::string& more, const std::string& at,
                   const std::string& of) {
  return "[case]\nname = \"path\"\nkind = \"static\"\n"
         "[frame]\nspace = true\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
         sections +
         "[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\n"
         "z = \"z\"\npoints = { hook = " +
         at + " }\n" + segment(6.0, "a") + more +
         "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.hook]\nkind = \"force\"\nat = "
         "\"beam.hook\"\nforce = " +
         of + "\n" + steel + "[strength]\nrequired = 1.0\nshear_lag = false\n";
}

/// Of those under a load the one that is used most.
const CheckResult* patch_under(const Verification& of, const std::string& name) {
  const CheckResult* worst = nullptr;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion != Criterion::patch_loading ||
        !result.check.point.ends_with(" under " + name))
      continue;
    if (worst == nullptr || result.check.utilisation() > worst->check.utilisation())
      worst = &result;
  }
  return worst;
}

bool blocks(const Verification& of, const std::string& words) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const Gate& gate) {
    return gate.blocks && gate.finding.find(words) != std::string::npos;
  });
}

/// Stout enough beside a single web to bound its panels: 197/20 (9.2.1(8)).
const std::string ends = diaphragms({0.0, 9.0}, 20.0);
const std::string plates = box("a", 600.0, 1224.0, 12.0, 8.0);
const std::string walls = section("a", box_path(600.0, 1224.0, 12.0, 8.0));

}  // namespace

TEST_CASE("forces between the walls of a path lie on the weld of one diaphragm together",
          "[patch]") {
  // 700 kN at the axis, half on each half of the diaphragm: its weld with the flange bears it on
  // 200 + 2 x 12 mm around it, halved, less no end; as one force or as two, box or path.
  const auto of = [](const std::string& sections, bool along_z, int forces) {
    std::string loads;
    const double part = -700.0 / forces;
    for (int i = 0; i < forces; ++i)
      loads += fmt::format(
          "[loads.f{}]\nkind = \"force\"\nat = [\"3 m\", \"0 m\", \"0 m\"]\n"
          "force = [\"0 kN\", \"{} kN\", \"{} kN\"]\n",
          i, along_z ? 0.0 : part, along_z ? part : 0.0);
    return use_of(
        verified("[case]\nname = \"path\"\nkind = \"static\"\n[frame]\nspace = true\n"
                 "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
                 sections + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segment(6.0, "a") +
                 diaphragms({0.0, 6.0}, 25.0) + diaphragms({3.0}, 20.0) + "throat = \"4 mm\"\n" +
                 introduction(0.0, 6.0, 200.0) +
                 "[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\nfork = true\n"
                 "[supports.z]\nkind = \"roller\"\nat = \"6 m\"\ndirection = \"z\"\nfork = "
                 "true\n[supports.y]\nkind = \"roller\"\nat = \"6 m\"\ndirection = \"y\"\n" +
                 loads + steel + "[strength]\nrequired = 1.0\nshear_lag = false\n"),
        Criterion::weld);
  };
  const std::string as_box = box("a", 500.0, 500.0, 12.0, 12.0),
                    as_path = section("a", box_path(500.0, 500.0, 12.0, 12.0));
  for (const bool along_z : {true, false}) {
    CAPTURE(along_z);
    // Two fillets of 4 mm, 0.5 x 224 mm of each: tau_perp and sigma_perp are equal under a force
    // square to the flange, sqrt(2) F/(a l) <= f_u/(beta_w gamma_M2) = 490/(0.9 x 1.25) MPa.
    const double by_hand =
        std::sqrt(2.0) * 350e3 / (2.0 * 4.0 * 0.5 * 224.0) / (490.0 / (0.9 * 1.25));
    for (const std::string& sections : {as_box, as_path}) {
      const double one = of(sections, along_z, 1);
      CHECK(one == Approx(by_hand).epsilon(0.05));
      CHECK(of(sections, along_z, 2) == Approx(one).epsilon(1e-6));
      CHECK(of(sections, along_z, 3) == Approx(one).epsilon(1e-6));
    }
  }
}

TEST_CASE("a box as a path bears forces as the box", "[patch]") {
  const std::pair<std::string, std::string> cases[] = {
      {ends + introduction(0.2, 0.4, 200.0), force("hook", 0.3, -300.0)},
      {ends + introduction(0.2, 0.4, 200.0), force("hook", 0.3, 300.0)},
      {ends + diaphragms({3.0}), force("hook", 3.0, -300.0)},
      {ends, force("hook", 8.7, -60.0)},
      // Near an end, close together, against each other.
      {introduction(0.0, 9.0, 100.0), force("hook", 0.2, -100.0)},
      {ends + introduction(0.0, 9.0, 100.0), force("hook", 0.4, -200.0) + force("b", 0.9, -200.0)},
      {ends + introduction(0.0, 9.0, 100.0), force("hook", 0.4, -200.0) + force("b", 0.6, 200.0)}};
  for (const auto& [more, loads] : cases) {
    CAPTURE(more, loads);
    const Verification as_box = verified(beam(plates, more, loads));
    const Verification as_path = verified(beam(walls, more, loads));
    for (const std::string name : {"hook", "left", "right", "hook and b", "hook together"}) {
      CAPTURE(name);
      const CheckResult *const a = patch_under(as_box, name), *const b = patch_under(as_path, name);
      REQUIRE((a == nullptr) == (b == nullptr));
      if (a == nullptr) continue;
      CHECK(b->patch->share == Approx(a->patch->share).epsilon(1e-9));
      CHECK(b->patch->resistance.value() == Approx(a->patch->resistance.value()).epsilon(1e-9));
      // Its effective section goes on from the standard's pass.
      CHECK(b->check.utilisation() >= a->check.utilisation() * (1.0 - 1e-9));
      CHECK(b->check.utilisation() <= a->check.utilisation() * 1.03);
    }
    CHECK(patch_under(as_path, "hook") != nullptr);
    CHECK_FALSE(blocks(as_path, "walls of a path"));
  }
}

TEST_CASE("an eccentric force on a box as a path: the levers of the box", "[patch]") {
  const std::string in = introduction(2.9, 3.1, 200.0);
  for (const auto& [at, of] :
       {std::pair{"[\"3 m\", \"0.2 m\", \"0 m\"]", "[\"0 N\", \"0 N\", \"-300 kN\"]"},
        {"[\"3 m\", \"-0.1 m\", \"0 m\"]", "[\"0 N\", \"0 N\", \"300 kN\"]"},
        {"[\"3 m\", \"0 m\", \"0.3 m\"]", "[\"0 N\", \"-300 kN\", \"0 N\"]"},
        {"[\"3 m\", \"0 m\", \"-0.2 m\"]", "[\"0 N\", \"300 kN\", \"0 N\"]"}}) {
    CAPTURE(at, of);
    const Verification as_box = verified(hooked(plates, in, at, of));
    const Verification as_path = verified(hooked(walls, in, at, of));
    const CheckResult *const a = patch_under(as_box, "hook"), *const b =
                                                                  patch_under(as_path, "hook");
    REQUIRE(a != nullptr);
    REQUIRE(b != nullptr);
    CHECK(b->patch->share == Approx(a->patch->share).epsilon(1e-9));
    CHECK(b->patch->resistance.value() == Approx(a->patch->resistance.value()).epsilon(1e-9));
  }
}

TEST_CASE("a force above the web of a girder: its resistance by hand", "[patch]") {
  const Project project = parse_project(
      "path.toml",
      beam(section("a", girder), ends + introduction(4.0, 5.0, 200.0), force("hook", 4.5, -100.0)));
  const Verification of = verify(project);
  const CheckResult* const hook = patch_under(of, "hook");
  REQUIRE(hook != nullptr);
  CHECK(hook->check.point == "wall 5 under hook");
  CHECK(hook->patch->share == 1.0);
  // EN 1993-1-5, 6.4 and 6.5, panels of 9 m; of each outstand of 197 mm 15 eps t_f = 146 mm.
  const double h = 1200.0, t = 6.0, t_f = 12.0, f = 355.0;
  const double k_F = 6.0 + 2.0 * std::pow(h / 9000.0, 2);
  const double F_cr = 0.9 * k_F * 210e3 * t * t * t / h;
  const double b_f = t + 2.0 * 15.0 * std::sqrt(235.0 / f) * t_f;
  const double l_y = 200.0 + 2.0 * t_f * (1.0 + std::sqrt(b_f / t + 0.02 * std::pow(h / t_f, 2)));
  const double F_Rd = 0.5 / std::sqrt(l_y * t * f / F_cr) * f * l_y * t / 1.1;
  CHECK(hook->patch->resistance.value() == Approx(1e3 * F_Rd * 1e-3).epsilon(1e-9));
  // 7.2 with the bending in the middle, M = F L/4, of the effective section there.
  const auto path = slender_path_at(project, {}, {4.5 * metre, Side::both});
  REQUIRE(path);
  CutForces cut;
  cut.M_y = si<Moment>(-100e3 * 9.0 / 4.0);
  const double eta_1 = path->section.use(cut), eta_2 = 100e3 / F_Rd;
  CHECK(hook->check.utilisation() ==
        Approx(std::max(eta_2, (eta_2 + 0.8 * eta_1) / 1.4)).epsilon(1e-6));
  // The last step of its sheet is the factor.
  test::sheet_to_factor(project, of, *hook);
}

TEST_CASE("wheels on a girder: no instant between those looked at is worse", "[patch]") {
  std::mt19937 engine(11);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const std::string two = section("a", girder) + section("b", i_section(400.0, 12.0, 900.0, 6.0));
  for (int i = 0; i < 3; ++i) {
    const double P = in(30.0, 120.0), at = in(2.0, 7.0), stiff = in(50.0, 250.0);
    const std::string wheel = fmt::format(
        "[loads.crab]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 kN\", \"{} kN\"] }}]\nfrom = "
        "\"0 m\"\nto = \"9 m\"\nspeed = \"1 m/s\"\n",
        -P);
    const Project project = parse_project(
        "path.toml", beam(two, diaphragms({0.0, at, 9.0}, 20.0) + introduction(0.0, 9.0, stiff),
                          wheel, taper(5.0, "a", "b") + segment(4.0, "b")));
    const Verification of = verify(project);
    // A diaphragm takes it when it is near enough.
    const auto in_web = [](const CheckResult& one) {
      return one.check.criterion == Criterion::patch_loading &&
             one.check.point.find("diaphragm") == std::string::npos &&
             one.check.point.ends_with("under crab");
    };
    const auto crab = std::find_if(of.checks.begin(), of.checks.end(), in_web);
    REQUIRE(crab != of.checks.end());
    double most = 0.0;
    for (int k = 1; k < 2000; ++k) {
      const double s = 9.0 * k / 2000.0;
      if (std::abs(s - at) < 1e-3) continue;
      const auto path = slender_path_at(project, {}, {si<Length>(s), Side::both});
      REQUIRE(path);
      CutForces cut;
      cut.M_y = si<Moment>(-1e3 * P * s * (9.0 - s) / 9.0);
      const double h = s < 5.0 ? 1.2 - 0.3 * s / 5.0 : 0.9, t = 0.006, t_f = 0.012, f = 355e6;
      const double a = s < at ? at : 9.0 - at, s_s = 1e-3 * stiff;
      const double F_cr = 0.9 * (6.0 + 2.0 * h * h / a / a) * 210e9 * t * t * t / h;
      const double b_f = t + 30.0 * std::sqrt(235.0 / 355.0) * t_f;
      const double l_y =
          std::min(a, s_s + 2.0 * t_f * (1.0 + std::sqrt(b_f / t + 0.02 * std::pow(h / t_f, 2))));
      const double F_Rd = 0.5 / std::sqrt(l_y * t * f / F_cr) * f * l_y * t / 1.1;
      const double eta_1 = path->section.use(cut), eta_2 = 1e3 * P / F_Rd;
      most = std::max({most, eta_2, (eta_2 + 0.8 * eta_1) / 1.4});
    }
    CAPTURE(i, P, at, stiff);
    CHECK(most > 0.1);
    CHECK(most <= crab->check.utilisation() * (1.0 + 1e-6));
    CHECK(crab->check.utilisation() <= most * (1.0 + 2e-3));
  }
}

TEST_CASE("what walls of a path bear of a force is not judged beside them, or shared by three",
          "[patch]") {
  const std::string in = introduction(2.9, 3.1, 200.0);
  const std::string down = "[\"0 N\", \"0 N\", \"-30 kN\"]",
                    across = "[\"0 N\", \"-3 kN\", \"0 N\"]";
  const std::string above = "[\"3 m\", \"0 m\", \"0 m\"]";
  const std::string of_girder = section("a", girder);
  CHECK_FALSE(blocks(verified(hooked(of_girder, in, above, down)), "walls of a path"));
  // 100 mm beside the middle of a web of 6 mm.
  CHECK(blocks(verified(hooked(of_girder, in, "[\"3 m\", \"0.1 m\", \"0 m\"]", down)),
               "97 mm beside wall 5"));
  CHECK(blocks(verified(hooked(of_girder, in, above, across)), "no wall along y"));
  // At a diaphragm it is said, but does not keep the verdict back: no wall has to bear it.
  const Verification at = verified(hooked(of_girder, diaphragms({3.0}), above, across));
  CHECK(has_gate(at, "a diaphragm is taken to bear it"));
  CHECK_FALSE(blocks(at, "walls of a path"));
  // A third wall in the middle of a box; a wall that stands on the flange above the web.
  ThinWalled three = box_path(600.0, 1224.0, 12.0, 8.0);
  three = split(split(three, 0, 0.5), 1, 0.5);
  const std::size_t low = three.nodes.size() - 1, high = low - 1;
  add_wall(three, high, low, 8.0, 6.0, 6.0);
  CHECK(blocks(verified(hooked(section("a", three), in, above, down)), "3 walls share it"));
  ThinWalled railed = i_section(800.0, 12.0, 1200.0, 6.0);
  add_wall(railed, railed.walls[0].to, add_node(railed, mm_place(0.0, 680.0)), 12.0, 6.0);
  CHECK(blocks(verified(hooked(section("a", railed), in, above, down)), "is no flange square to"));
}

TEST_CASE("stout walls of a path under forces: looked at where the case says how they come in",
          "[patch]") {
  // Web 400/8 = 50, below 72 eps/eta = 49 of S355 only with eta = 1.2: 72 0.814/1.2 = 48.8; of 10
  // mm 40.
  const std::string stout = section("a", i_section(200.0, 12.0, 400.0, 10.0));
  const Verification asked =
      verified(beam(stout, ends + introduction(4.0, 5.0, 100.0), force("hook", 4.5, -50.0)));
  CHECK(patch_under(asked, "hook") != nullptr);
  CHECK(asked.not_judged.empty());
  CHECK(patch_under(verified(beam(stout, ends, force("hook", 4.5, -50.0))), "hook") == nullptr);
  // With flanges of class 4 (194/6 = 32) the web is as stout.
  const Verification wide = verified(
      beam(section("a", i_section(398.0, 6.0, 400.0, 10.0)), ends, force("hook", 4.5, -20.0)));
  CHECK(patch_under(wide, "hook") == nullptr);
  CHECK_FALSE(blocks(wide, "clause 6"));
}

namespace {

/// The bearing of the force at the hook, or nullptr.
const CheckResult* bearing_in(const Verification& of) {
  for (const CheckResult& result : of.checks)
    if (result.patch && result.check.point.ends_with(" with diaphragm under hook")) return &result;
  return nullptr;
}

}  // namespace

TEST_CASE("flats on both sides of a girder's web bear a force: 9.4 by hand", "[patch]") {
  // Flats 197 x 20 on both sides within flanges 400 wide (13 eps = 10.6 thicknesses), 15 eps t =
  // 73.2 mm of web on both sides; held sideways there: 0.75 h_w.
  const std::string loads = force("hook", 3.0, -300.0);
  const auto flats_of = [](double thickness) { return diaphragms({0.0, 3.0, 9.0}, thickness); };
  const Project project =
      parse_project("path.toml", beam(section("a", girder), flats_of(20.0), loads));
  const Verification of = verify(project);
  const CheckResult* const found = bearing_in(of);
  REQUIRE(found != nullptr);
  const auto by_hand = [](double length, double strip) {
    const double A = strip * 6.0 + 2.0 * 197.0 * 20.0;
    const double I = strip * 216.0 / 12.0 + 20.0 * (std::pow(400.0, 3) - 216.0) / 12.0;
    const double N_cr = std::pow(3.14159265358979 / length, 2) * 210e3 * I;
    const double lambda = std::sqrt(A * 355.0 / N_cr);
    const double chi = test::chi_of(lambda);
    return chi * A * 355.0 / 1.1;
  };
  const double strip = 2.0 * 15.0 * std::sqrt(235.0 / 355.0) * 6.0 + 20.0;
  CHECK(found->patch->resistance.value() == Approx(by_hand(900.0, strip)).epsilon(1e-6));
  // With V = 200 kN of the panel before it, beyond V_cr = 5.98 x 190 GPa (6/1200)^2 x 7200 mm^2 of
  // a = 3 m as all loads grow (9.3.3(3)): F + V <= N_b,Rd + V_cr.
  REQUIRE(found->patch->pulls);
  const double V = found->patch->pulls->shear.value();
  CHECK(V == Approx(200e3).epsilon(2e-2));
  CHECK(found->check.utilisation() ==
        Approx((300e3 + V) / (by_hand(900.0, strip) + 204.5e3 / 1.1)).epsilon(1e-3));
  CHECK_FALSE(has_gate(of, "a diaphragm is taken to bear it"));
  test::sheet_to_factor(project, of, *found, 1e-3);
  // Held elsewhere the flanges may give way.
  std::string loose =
      beam(section("a", girder), diaphragms({0.0, 3.1, 9.0}, 20.0), force("hook", 3.1, -300.0));
  const Verification by_length = verified(loose);
  REQUIRE(bearing_in(by_length) != nullptr);
  CHECK(bearing_in(by_length)->patch->resistance.value() ==
        Approx(by_hand(1200.0, strip)).epsilon(1e-6));
  // Flats that twist, 197/10 = 19.7, are not judged: no verdict.
  const Verification thin = verified(beam(section("a", girder), flats_of(10.0), loads));
  CHECK(bearing_in(thin) == nullptr);
  CHECK(blocks(thin, "twist"));
  CHECK(thin.verdict == Verdict::not_applicable);
  // A channel has flanges on one side of its web alone: flats that bend as they are pressed.
  const Verification one_side =
      verified(beam(section("a", channel(1200.0, 200.0, 6.0, 20.0)), flats_of(20.0), loads));
  REQUIRE(bearing_in(one_side) != nullptr);
  CHECK(std::get<BearingStiffener>(bearing_in(one_side)->patch->bears).bows);
  CHECK(bearing_in(one_side)->patch->resistance < 0.5 * found->patch->resistance);
}

TEST_CASE("a weaker diaphragm beside a web never gives a better verdict", "[patch]") {
  // The utilisation; above 1 where there is no verdict.
  const auto use = [](const ThinWalled& path, double thickness, double opening) {
    const Verification of =
        verified(beam(section("a", path), diaphragms({0.0, 3.0, 9.0}, thickness, opening),
                      force("hook", 3.0, -300.0)));
    double most = of.verdict == Verdict::not_applicable ? 1e3 : 0.0;
    for (const CheckResult& result : of.checks) most = std::max(most, result.check.utilisation());
    return most;
  };
  // 9.2.1(8): b/t up to sqrt(E/(5.3 f_y)) = 10.56, less round-off of 1/4 in I_p: 10.55.
  CHECK(use(girder, 20.0, 0.0) < 1.0);   // 197/20 = 9.85
  CHECK(use(girder, 16.0, 0.0) > 1.0);   // 197/16 = 12.3
  CHECK(use(girder, 16.0, 60.0) < 1.0);  // 167/16 = 10.4
  CHECK(use(girder, 1.0, 0.0) > 1.0);
  CHECK(use(girder, 1.0, 380.0) > 1.0);
}

TEST_CASE("flanges that lean by less than a degree change nothing of what flats bear", "[patch]") {
  const auto leaning = [](double by) {
    // Tips lower by so many mm of 200.
    ThinWalled path = girder;
    for (SectionPlace& node : path.nodes)
      if (std::abs(node.y.value()) > 0.1)
        node.z =
            node.z > Length{} ? node.z - si<Length>(1e-3 * by) : node.z + si<Length>(1e-3 * by);
    return verified(beam(section("a", path), diaphragms({0.0, 3.0, 9.0}, 10.0, 340.0),
                         force("hook", 3.0, -300.0)));
  };
  // 0.14 and 2.9 degrees: what the web's face takes of the flange is measured along it, 3 cos
  // for 3.
  REQUIRE(bearing_in(leaning(0.0)) != nullptr);
  const double square = bearing_in(leaning(0.0))->patch->resistance.value();
  for (const double by : {0.5, 10.0}) {
    const Verification of = leaning(by);
    CAPTURE(by);
    REQUIRE(bearing_in(of) != nullptr);
    CHECK(bearing_in(of)->patch->resistance.value() == Approx(square).epsilon(1e-4));
    CHECK(of.verdict == leaning(0.0).verdict);
  }
  // 11.3 degrees are too many.
  CHECK(blocks(leaning(40.0), "is no flange square to"));
}

TEST_CASE("thicker and wider flats of a girder bear more", "[patch]") {
  double before = 0.0;
  for (const double thickness : {20.0, 25.0, 30.0, 40.0}) {
    const Verification of = verified(beam(
        section("a", girder), diaphragms({0.0, 3.0, 9.0}, thickness), force("hook", 3.0, -300.0)));
    REQUIRE(bearing_in(of) != nullptr);
    CHECK(bearing_in(of)->patch->resistance.value() > before);
    before = bearing_in(of)->patch->resistance.value();
  }
  const auto with_hole = verified(beam(
      section("a", girder), diaphragms({0.0, 3.0, 9.0}, 20.0, 100.0), force("hook", 3.0, -300.0)));
  const auto without = verified(
      beam(section("a", girder), diaphragms({0.0, 3.0, 9.0}, 20.0), force("hook", 3.0, -300.0)));
  REQUIRE(bearing_in(with_hole) != nullptr);
  CHECK(bearing_in(with_hole)->patch->resistance < bearing_in(without)->patch->resistance);
}

}  // namespace patched_paths_test
