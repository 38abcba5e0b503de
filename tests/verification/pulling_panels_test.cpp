// Diaphragms as stiffeners between panels in shear: which bound them, and what these pull at them,
// by hand and as properties.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/path_cases.hpp"

namespace pulling_panels_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::held;
using path_cases::section;

namespace {

std::string diaphragm(double at, double thickness, double opening = 0.0) {
  return diaphragms({at}, thickness, opening);
}

std::string force(const std::string& name, double at, double kN) {
  return fmt::format("[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 kN\", \"{} kN\"]\n",
                     name, at, kN);
}

/// Webs 1200 x 8 between flanges 600 x 40 of S355.
const std::string box =
    "[sections.a]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"1280 mm\"\n"
    "flange = \"40 mm\"\nweb = \"8 mm\"\n";

/// A weightless beam of 9 m on two supports, gamma_M1 = 1.
std::string beam(const std::string& sections, const std::string& more, const std::string& loads) {
  return "[case]\nname = \"panels\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         sections +
         "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"9 m\"\n"
         "section = \"a\"\n" +
         more +
         "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.right]\nkind = \"roller\"\nat = \"9 m\"\n" +
         loads + "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n" +
         "[strength]\nrequired = 1.0\nshear_lag = false\ngamma_M1 = 1.0\n";
}

const CheckResult* patch_at(const Verification& of, const std::string& under) {
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == Criterion::patch_loading &&
        result.check.point.ends_with(" under " + under))
      return &result;
  }
  return nullptr;
}

bool says(const Verification& of, const std::string& words) {
  return std::any_of(of.not_judged.begin(), of.not_judged.end(), [&](const NotJudged& at) {
    return at.reason.find(words) != std::string::npos;
  });
}

/// tau_cr h t of a web 1200 x 8, by sigma_E = 190 GPa (t/h)^2.
double buckling_shear(double a) {
  const double ratio = 1200.0 / a;
  const double k = a >= 1200.0 ? 5.34 + 4.0 * ratio * ratio : 4.0 + 5.34 * ratio * ratio;
  return k * 190e3 * std::pow(8.0 / 1200.0, 2) * 1200.0 * 8.0;
}

/// N_b,Rd of 10 mm across that box: as by hand in patch_loading_test, of another width alike, for
/// 15 eps of it are less than there is.
constexpr double column = 966e3;

}  // namespace

TEST_CASE("what webs beyond their buckling pull at a diaphragm: 9.3.3(3) by hand", "[patch]") {
  // V = 1200 kN beside the middle, 600 kN in each web; panels of 1.5 m: V_cr = 7.9 x 8.444 MPa x
  // 9600 mm^2 = 640 kN, of 3 m 485 kN.
  const std::string at = diaphragm(0.0, 10.0) + diaphragm(3.0, 10.0) + diaphragm(4.5, 10.0) +
                         diaphragm(6.0, 10.0) + diaphragm(9.0, 10.0);
  const Project project = parse_project("panels.toml", beam(box, at, force("hook", 4.5, -2400.0)));
  const Verification of = verify(project);
  const CheckResult* const bare = patch_at(of, "the shear of its panels");
  REQUIRE(bare != nullptr);
  REQUIRE(bare->patch->pulls);
  // Flanges 40 mm thick carry a little of it.
  CHECK(bare->patch->pulls->shear.value() == Approx(600e3).epsilon(4e-2));
  const double V = bare->patch->pulls->shear.value();
  // At 3 m, and at 6 m: the longer panel beside it pulls more.
  CHECK(bare->check.utilisation() == Approx(V / (column + buckling_shear(3000.0))).epsilon(2e-3));
  // Under the force 1200 kN and nothing of the panels, which do not buckle: 600 kN of 640.
  const CheckResult* const hook = patch_at(of, "hook");
  REQUIRE(hook != nullptr);
  CHECK(hook->check.utilisation() == Approx(1200e3 / column).epsilon(2e-3));
  test::sheet_to_factor(project, of, *bare, 1e-3);
}

TEST_CASE("a force at a diaphragm and the shear of its panels add", "[patch]") {
  // 300 kN at 3 m beside 2000 kN in the middle of panels of 3 m: V before it 1200 kN.
  const auto at = [](double thickness) {
    return diaphragm(0.0, 10.0) + diaphragm(3.0, thickness) + diaphragm(6.0, 10.0) +
           diaphragm(9.0, 10.0);
  };
  const std::string loads = "[[beam.load_introductions]]\nstation = \"4.5 m\"\ninto = \"webs\"\n" +
                            force("hook", 3.0, -300.0) + force("middle", 4.5, -2000.0);
  const Verification of = verify(parse_project("panels.toml", beam(box, at(10.0), loads)));
  const CheckResult* const hook = patch_at(of, "hook");
  REQUIRE(hook != nullptr);
  REQUIRE(hook->patch->pulls);
  const double V = hook->patch->pulls->shear.value();
  CHECK(V == Approx(600e3).epsilon(4e-2));
  // 150 kN comes into each web.
  const double V_cr = buckling_shear(3000.0);
  CHECK(hook->check.utilisation() ==
        Approx(std::max(150e3 / column, (150e3 + V) / (column + V_cr))).epsilon(2e-3));
  // Two forces there count together, and more shear or a thinner diaphragm is never better.
  const Verification two = verify(
      parse_project("panels.toml", beam(box, at(10.0), loads + force("other", 3.0, -300.0))));
  REQUIRE(patch_at(two, "hook and other") != nullptr);
  CHECK(patch_at(two, "hook and other")->patch->force.value() == Approx(600e3));
  double before = 1e9;
  for (const double thickness : {4.0, 6.0, 10.0, 16.0}) {
    const Verification by = verify(parse_project("panels.toml", beam(box, at(thickness), loads)));
    REQUIRE(patch_at(by, "hook") != nullptr);
    CHECK(patch_at(by, "hook")->check.utilisation() <= before);
    before = patch_at(by, "hook")->check.utilisation();
  }
}

TEST_CASE("a diaphragm of a box bounds panels where what is beside the web is rigid", "[plates]") {
  // a = 600: I_st = 1.5 x 1200^3 x 512/600^2 = 3.686e6 mm^4. A whole plate of 10 mm works over
  // 190.8 mm (lambda_p = 1.264), with 205.3 x 8 mm^2 of the web: 10 x 190.8^3/12 + 1642 x 1908/3550
  // x 99.4^2 = 14.5e6; 12 mm beside an opening 1440 + 1642 x 120/1762 x 100 = 21e3 mm^4.
  const auto verified = [](double thickness, double opening) {
    std::string at;
    for (int k = 0; k <= 15; ++k) at += diaphragm(0.6 * k, thickness, opening);
    return verify(parse_project(
        "panels.toml",
        beam(box,
             at + "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"9 m\"\ninto = \"webs\"\n",
             force("hook", 4.5, -1800.0))));
  };
  const auto shear = [](const Verification& of) {
    const CheckResult* const at = governing_of(of.checks, Criterion::shear_buckling);
    return at == nullptr ? 0.0 : at->check.utilisation();
  };
  const Verification whole = verified(10.0, 0.0);
  CHECK_FALSE(says(whole, "9.3.3(3)"));
  // Without panels 5.34 in place of 4 + 5.34 x 4 = 25.36: chi_w goes by its root.
  const Verification open = verified(10.0, 560.0);
  CHECK(says(open, "below 3.686e+06 mm^4 (9.3.3(3))"));
  CHECK(shear(open) == Approx(shear(whole) * std::sqrt(25.36 / 5.34)).epsilon(1e-3));
  CHECK(shear(verified(0.1, 0.0)) == Approx(shear(open)));
  // A larger opening, a thinner plate: never less used.
  double used = 0.0;
  for (const double opening : {0.0, 200.0, 400.0, 500.0, 560.0}) {
    CHECK(shear(verified(10.0, opening)) >= used * (1.0 - 1e-9));
    used = shear(verified(10.0, opening));
  }
  used = 0.0;
  for (const double thickness : {20.0, 10.0, 5.0, 2.0, 0.5}) {
    CHECK(shear(verified(thickness, 0.0)) >= used * (1.0 - 1e-9));
    used = shear(verified(thickness, 0.0));
  }
}

TEST_CASE("flats beside the web of a girder bear what its panels pull", "[patch]") {
  // A girder 400 x 20, web 1200 x 6, and a channel, whose flats stand on one side alone and bend.
  const auto bare = [](const ThinWalled& path) {
    const Verification of = verify(parse_project(
        "panels.toml",
        beam(section("a", path),
             held(9.0, 30) + diaphragm(0.0, 20.0) + diaphragm(3.0, 20.0) + diaphragm(6.0, 20.0) +
                 diaphragm(9.0, 20.0) +
                 "[[beam.load_introductions]]\nstation = \"4.5 m\"\ninto = \"webs\"\n",
             force("hook", 4.5, -400.0))));
    CHECK_FALSE(says(of, "9.3.3(3)"));
    const CheckResult* const found = patch_at(of, "the shear of its panels");
    REQUIRE(found != nullptr);
    CHECK(found->patch->pulls->shear.value() == Approx(200e3).epsilon(2e-2));
    // V_cr of 1200 x 6, a = 3 m: 5.98 x 190e3 (6/1200)^2 x 7200 = 204.5 kN.
    CHECK(found->check.utilisation() ==
          Approx(found->patch->pulls->shear.value() / (found->patch->resistance.value() + 204.5e3))
              .epsilon(2e-3));
    return found->patch->resistance.value();
  };
  const double both = bare(i_section(400.0, 20.0, 1200.0, 6.0));
  const double one = bare(channel(1240.0, 203.0, 6.0, 20.0));
  CHECK(one < 0.5 * both);
}

TEST_CASE("a flange that kinks presses its webs, as a force does", "[patch]") {
  // From 600 x 624 in 0.8 m to 600 x 1224, flanges 25, webs 10 mm, under 800 kN m: sigma of the
  // flange's middle times 600 x 25 mm^2 times 0.375, half for each web.
  const auto of = [](const std::string& more) {
    return verify(parse_project(
        "panels.toml",
        "[case]\nname = \"kink\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
        "m/s^2\"]\n"
        "[sections.a]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"624 mm\"\nflange = \"25 "
        "mm\"\n"
        "web = \"10 mm\"\n[sections.b]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"1224 mm\"\n"
        "flange = \"25 mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n" +
            segment(2.0, "a") + taper(0.8, "a", "b") + segment(2.0, "b") + diaphragms({0.0, 4.8}) +
            more +
            "[supports.left]\nkind = \"fixed\"\nat = \"0 m\"\n"
            "[loads.end]\nkind = \"force\"\nat = \"4.8 m\"\nforce = [\"0 kN\", \"0 kN\"]\n"
            "moment = \"-800 kN m\"\n"
            "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
            "[strength]\nrequired = 1.0\nshear_lag = false\n"));
  };
  const double I = (600.0 * std::pow(624.0, 3) - 580.0 * std::pow(574.0, 3)) / 12.0;
  const double F = 800e6 / I * 299.5 * 600.0 * 25.0 * 0.375;
  const auto kink_in = [](const Verification& at) -> const CheckResult* {
    const CheckResult* most = nullptr;
    for (const CheckResult& result : at.checks) {
      const bool kink =
          result.patch && result.check.point.find(" under the kink") != std::string::npos;
      if (kink && (most == nullptr || result.check.utilisation() > most->check.utilisation()))
        most = &result;
    }
    return most;
  };
  // With diaphragms there as columns.
  const Verification held = of(diaphragms({2.0, 2.8}));
  REQUIRE(kink_in(held) != nullptr);
  CHECK(kink_in(held)->patch->force.value() == Approx(F).epsilon(1e-6));
  CHECK(kink_in(held)->check.station.s.value() == Approx(2.0));
  CHECK_FALSE(says(held, "where it turns off"));
  // Without them more than the webs bear under an edge, and the flange is bent across beyond yield.
  const Verification bare = of("");
  CHECK(bare.verdict == Verdict::not_applicable);
  CHECK(has_gate(bare, "of \"the kink of the top flange\""));
  CHECK(has_gate(bare, "bent across where it turns off"));
}

TEST_CASE("wheels on a flange between webs, and what they press at every cycle, are said",
          "[patch]") {
  const auto of = [](double y, double kN) {
    return verify(parse_project(
        "panels.toml",
        "[case]\nname = \"wheel\"\nkind = \"static\"\n[frame]\nspace = true\n"
        "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" +
            box +
            "[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\n"
            "z = \"z\"\n" +
            fmt::format("points = {{ hook = [\"3 m\", \"{} m\", \"0.64 m\"] }}\n", y) +
            segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}) +
            "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"6 m\"\nstiff_length = \"50 mm\"\n"
            "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
            "[loads.hook]\nkind = \"force\"\nat = \"beam.hook\"\n" +
            fmt::format("force = [\"0 N\", \"0 N\", \"-{} kN\"]\n", kN) +
            "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
            "[strength]\nrequired = 1.0\nshear_lag = false\n"));
  };
  // Between the webs: 6/pi x 150e3/40^2 = 179 MPa across, 0.50 f_y; above a web nothing.
  CHECK(says(of(0.0, 150.0), "bends it across, by about 0.5"));
  CHECK_FALSE(says(of(0.296, 150.0), "bends it across"));
  // 335/355.
  CHECK_FALSE(has_gate(of(0.0, 280.0), "bends it across"));
  CHECK(has_gate(of(0.0, 310.0), "bends it across, by about 1"));
}

TEST_CASE("a pin at a lug far below a beam is no clamp: its force comes into the webs", "[patch]") {
  // z = -0.9 m, N = -900 kN and 500 kN across: 900 x 0.9 kN m and 500/2 +- 900 x 0.9/8 kN.
  const auto of = [](const std::string& kind) {
    return verify(parse_project(
        "panels.toml",
        "[case]\nname = \"lug\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
        "m/s^2\"]\n" +
            box + "[beam]\ndensity = \"7850 kg/m^3\"\npoints = { lug = [\"0 m\", \"-0.9 m\"] }\n" +
            segment(8.0, "a") + "[supports.l]\nkind = \"" + kind +
            "\"\nat = \"beam.lug\"\n"
            "[supports.r]\nkind = \"roller\"\nat = \"8 m\"\n"
            "[[beam.load_introductions]]\nfrom = \"3 m\"\nto = \"8 m\"\ninto = \"webs\"\n"
            "[loads.p]\nkind = \"force\"\nat = \"4 m\"\nforce = [\"0 kN\", \"-500 kN\"]\n"
            "[loads.n]\nkind = \"force\"\nat = \"8 m\"\nforce = [\"-900 kN\", \"0 kN\"]\n"
            "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n"
            "[strength]\nrequired = 1.0\nshear_lag = false\n"));
  };
  CHECK(has_gate(of("pinned"), "of \"l\""));
  CHECK_FALSE(has_gate(of("fixed"), "of \"l\""));
}

TEST_CASE("in space a hinge at a lug far below a beam is no clamp, one that is driven is",
          "[patch]") {
  // About the heel, 0.8 m below the axis: strut (6 m) = tip's -F_x 0.8 m + F_z 8 m, with F = 900 kN
  // along (-0.97, 0, -0.24): 171.8 kN of 216.2 kN, so that the heel holds 44.4 kN down.
  const std::string tail =
      "[forces.tip]\nkind = \"force\"\npoint = \"boom.tip\"\n"
      "direction = [-0.97, 0, -0.24]\nsize = \"900 kN\"\n"
      "[sections.box]\nkind = \"box\"\nwidth = \"600 mm\"\nheight = \"1224 mm\"\n"
      "flange = \"12 mm\"\nweb = \"8 mm\"\n[beam]\nbody = \"boom\"\nstart = \"axis\"\n"
      "axis = \"x\"\nz = \"z\"\ndensity = \"7850 kg/m^3\"\n"
      "[[beam.segments]]\nlength = \"8 m\"\nsection = \"box\"\n"
      "[[beam.diaphragms]]\nstation = \"6 m\"\nthickness = \"16 mm\"\n"
      "[[beam.diaphragms]]\nstation = \"8 m\"\nthickness = \"16 mm\"\n"
      "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n";
  const std::string head =
      "[case]\nname = \"boom\"\nkind = \"spatial\"\n[mechanism]\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n[bodies.boom]\n"
      "points = { axis = [\"0 m\", \"0 m\", \"0 m\"], heel = [\"0 m\", \"0 m\", \"-0.8 m\"], "
      "lug = [\"6 m\", \"0 m\", \"0 m\"], tip = [\"8 m\", \"0 m\", \"0 m\"] }\n"
      "[joints.heel]\nkind = \"revolute\"\nconnect = [\"ground\", \"boom.heel\"]\naxis = \"y\"\n";
  const std::string swing =
      "kind = \"harmonic\"\namplitude = \"0.001 {}\"\nfrequency = \"0.1 Hz\"\n";
  const std::string strut =
      "[bodies.ram]\nmass = \"1 kg\"\npoints = { foot = [\"0 m\", \"0 m\", \"0 m\"] }\n"
      "[joints.foot]\nkind = \"fixed\"\nconnect = [\"ground\", \"ram.foot\"]\n"
      "at = [\"6 m\", \"0 m\", \"-5 m\"]\n"
      "[joints.strut]\nkind = \"distance\"\nconnect = [\"ram.foot\", \"boom.lug\"]\n"
      "[drivers.strut]\njoint = \"strut\"\nmean = \"5.8 m\"\n";
  struct Uses {
    double heel = 0.0, effective = 0.0;
  };
  const auto uses_of = [&](const std::string& moved) {
    const Verification of = verify(parse_project("boom.toml", head + moved + tail));
    Uses uses;
    for (const CheckResult& result : of.checks) {
      const Check& check = result.check;
      const bool at_heel = check.point.find("heel") != std::string::npos;
      double& use = check.criterion == Criterion::effective_section ? uses.effective : uses.heel;
      if (check.criterion == Criterion::effective_section || at_heel)
        use = std::max(use, check.utilisation());
    }
    return uses;
  };
  // 7.2: F/F_Rd + 0.8 eta_1 of 1.4, in each web half of the force; F_Rd = 141 kN: type c, k_F = 2,
  // F_cr = 161 kN, l_y = 12 sqrt(156/16 + 200) = 174 mm.
  const Uses hinged = uses_of(strut + fmt::format(fmt::runtime(swing), "m"));
  CHECK(hinged.heel == Approx((0.5 * 44.4 / 141.1 + 0.8 * hinged.effective) / 1.4).epsilon(0.02));
  CHECK(uses_of("[drivers.heel]\njoint = \"heel\"\nmean = \"0 deg\"\n" +
                fmt::format(fmt::runtime(swing), "deg"))
            .heel == 0.0);
}

}  // namespace pulling_panels_test
