// Boxes of slender plates from the case to the verdict: against hand values, boxes that are the
// same for another reason, and stations looked at one by one.

#include "boxbeam/verification/plate_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/slender_cases.hpp"
#include "support/uniform.hpp"

namespace plate_checks_test {

using namespace boxbeam;
using namespace slender_cases;

TEST_CASE("a web of 1200 x 8 mm gets a verdict: effective section, shear and both by hand") {
  // Flanges 600 x 12 mm, clear 584; webs clear 1200. 60 kN at 10 m: M = 600 kN m at the root.
  const Verification of = verified(
      cantilever(box("a", 600.0, 1224.0, 12.0, 8.0), segment(10.0, "a"), tip(10.0, -400.0)));
  CHECK(of.verdict == Verdict::fail);
  // By hand, mm: top in tension; eps = 0.8136. Bottom flange: lambda_p = 48.67/(28.4 eps 2) =
  // 1.0532, rho = 0.7512, idle 145.3 mm. Web from the effective flange: see below.
  const double eps = std::sqrt(235.0 / 355.0);
  const double lambda_f = 584.0 / 12.0 / (28.4 * eps * 2.0);
  const double idle_f = (1.0 - (lambda_f - 0.22) / (lambda_f * lambda_f)) * 584.0;
  double A = 2 * 600.0 * 12 + 2 * 1200.0 * 8 - idle_f * 12;
  double S = idle_f * 12 * 606;  // about mid-height, of what is left, upwards
  const double axis = S / A;
  const double psi = -(600 - axis) / (600 + axis);
  const double k = 7.81 - 6.29 * psi + 9.78 * psi * psi;
  const double lambda_w = 150.0 / (28.4 * eps * std::sqrt(k));
  const double rho_w = (lambda_w - 0.055 * (3 + psi)) / (lambda_w * lambda_w);
  const double pressed = 1200 / (1 - psi), kept = rho_w * pressed;
  const double idle_w = pressed - kept, from = -600 + 0.4 * kept;
  const double at_w = from + idle_w / 2;
  A -= 2 * 8 * idle_w;
  S -= 2 * 8 * idle_w * at_w;
  const double z = S / A;
  const double I = (600.0 * std::pow(1224, 3) - 584.0 * std::pow(1200, 3)) / 12 -
                   idle_f * (12 * 606.0 * 606 + 12.0 * 12 * 12 / 12) -
                   2 * 8 * (std::pow(idle_w, 3) / 12 + idle_w * at_w * at_w) - A * z * z;
  const double W = I / (606 + z);
  const CheckResult* const section = of.governing(Criterion::effective_section);
  REQUIRE(section != nullptr);
  CHECK(section->check.id == "effective-section/0+/bottom-flange");
  CHECK(section->check.acting.value() == Approx(400e3 * 10e3 / W * 1e6).epsilon(1e-6));
  CHECK(section->check.safety_factor == Approx(355.0 * W / (400e3 * 10e3)).epsilon(1e-6));
  // Each web carries its clear depth's part of V/2; lambda_w = 150/(86.4 eps).
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  CHECK(shear->check.point == "web");
  const double chi = 0.83 / (150.0 / (37.4 * eps * std::sqrt(5.34)));
  const double V_bw = chi * 355.0 * 1200 * 8 / std::sqrt(3.0);
  CHECK(shear->check.resisting.value() == Approx(V_bw).epsilon(1e-9));
  CHECK(shear->check.acting.value() < 200e3);
  CHECK(shear->check.acting.value() > 0.97 * 200e3);
  // V below half of what the web bears: both together are the effective section alone.
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == Criterion::interaction)
      CHECK(result.check.utilisation() < section->check.utilisation());
  }
  CHECK(!has_gate(of, "class 4"));
  CHECK(!has_gate(of, "buckle in shear"));
}

// N alone: gross up to class 3, c = 42 eps t (EN 1993-1-1, table 5.2), by A_eff beyond it, where
// rho = 0.9500 (EN 1993-1-5, 4.4(2), whole to 38.2 eps t): the jump is the code's own, and the only
// one.
TEST_CASE("class 3 meets class 4 without a jump beyond the code's own", "[plates]") {
  const double eps = std::sqrt(235.0 / 355.0), t = 10.0, end = 42.0 * eps * t;
  const auto use_at = [&](double c) {
    const Verification of = verified(cantilever(box("a", c + 40.0, 300.0, t, 20.0),
                                                segment(0.4, "a") + diaphragms({0.0, 0.4}, 30.0),
                                                tip(0.4, 0.0, -1000.0)));
    return std::max(use_of(of, Criterion::yield), use_of(of, Criterion::effective_section));
  };
  const double below = use_at(end * (1.0 - 1e-6)), above = use_at(end * (1.0 + 1e-6));
  const double gross = 2.0 * (end + 40.0) * t + 2.0 * 280.0 * 20.0;
  const double lambda = 42.0 / 56.8, rho = (lambda - 0.22) / (lambda * lambda);
  CHECK(rho == Approx(0.9500).margin(5e-5));
  CHECK(below * gross * 355.0 == Approx(1e6).epsilon(1e-5));
  CHECK(above / below == Approx(gross / (gross - 2.0 * (1.0 - rho) * end * t)).epsilon(2e-5));
  CHECK(above / below == Approx(1.0185).margin(1e-4));
  // As plates go on to get slenderer the use grows steadily.
  double before = above * (gross - 2.0 * (1.0 - rho) * end * t);
  for (int k = 1; k <= 20; ++k) {
    const double c = end * (1.0 + 0.02 * k), slenderness = c / t / (56.8 * eps);
    const double kept = (slenderness - 0.22) / (slenderness * slenderness);
    const double area = 2.0 * (kept * c + 40.0) * t + 2.0 * 280.0 * 20.0;
    const double force = use_at(c) * area;
    CHECK(force == Approx(before).epsilon(1e-4));
    before = force;
  }
}

TEST_CASE("shear above half of the resistance takes from the moment", "[plates]") {
  Project project = parse_project("slender.toml", cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                                                             segment(2.0, "a"), tip(2.0, -1000.0)));
  project.strength.shear_lag = false;
  const Verification of = verify(project);
  const CheckResult* const both = of.governing(Criterion::interaction);
  REQUIRE(both != nullptr);
  CHECK(both->check.source == "EN 1993-1-5:2006, 7.1(1), equation 7.1");
  const double eta_1 = use_of(of, Criterion::effective_section);
  const double eta_3 = use_of(of, Criterion::shear_buckling);
  CHECK(eta_3 > 0.5);
  CHECK(both->check.utilisation() > std::max(eta_1, eta_3));
  // 7.1(1): of the compressed flange 584 x 0.7512 + 16 mm work, see above; kN and m.
  const double F_c = (584.0 * 0.75124 + 16.0) * 12.0 * 0.355, F_t = 600.0 * 12.0 * 0.355;
  const double W = 2.0 * 1200.0 * 8.0 * 0.355, w = F_c - F_t;
  const double M_f = F_c * 1.212;
  const double M_pl = (F_c + F_t) * 0.606 + W * 1.2 / 4.0 * (1.0 - w * w / (W * W));
  const double f = 1.0 / both->check.utilisation();
  CHECK(f * 2000.0 / M_pl + (1.0 - M_f / M_pl) * std::pow(2.0 * f * eta_3 - 1.0, 2) ==
        Approx(1.0).epsilon(1e-4));
  // Milder than 7.1(5), in which flanges bear nothing of the moment beside the webs.
  CHECK(both->check.utilisation() < 0.98 / interaction_factor(eta_1, eta_3));
}

TEST_CASE("a flange under V counts with half of its largest shear stress", "[plates]") {
  // Under V_z its halves balance: the flow at a web is V b/2 (z t)/I, by Zhuravsky.
  const double V = 300e3;
  const Project project = parse_project(
      "slender.toml",
      cantilever(box("a", 900.0, 600.0, 8.0, 12.0), segment(4.0, "a"), tip(4.0, -1e-3 * V)));
  const auto runs = run_situations(project);
  const Station root{Length{}, Side::behind};
  const auto plates = slender_plates_at(project, bending_zones_of(project, runs), root);
  REQUIRE(plates != nullptr);
  const double I = (0.9 * std::pow(0.6, 3) - 0.876 * std::pow(0.584, 3)) / 12.0;
  const double largest = V * 0.296 * 0.438 / I;
  check_flanges_under(V, *plates, 0.5 * largest, 0.01);
}

TEST_CASE("webs under V_y count as flanges under V_z do: the box turned by 90 degrees",
          "[plates]") {
  const auto plates = [](double width, double height, double flange, double web) {
    const Section section{
        symmetric_box(si<Length>(width), si<Length>(height), si<Length>(flange), si<Length>(web)),
        {}};
    const Project project = parse_project(
        "slender.toml", cantilever(box("a", 1e3 * width, 1e3 * height, 1e3 * flange, 1e3 * web),
                                   segment(1.0, "a"), tip(1.0, -1.0)));
    const auto walls = four_walls_of(section.outer, materials_of(project, 0));
    REQUIRE(walls);
    return sheared_plates_of(section, *walls, {}, false, 1.0);
  };
  const auto most = [](const std::vector<ShearedPlate>& of, bool flange, const CutForces& cut) {
    double force = 0.0;
    for (const ShearedPlate& plate : of)
      if (is_flange(plate.plate) == flange) force = std::max(force, plate.force_of(cut).value());
    return force;
  };
  CutForces along_z{}, along_y{};
  along_z.V_z = along_y.V_y = si<Force>(1750e3);
  const auto upright = plates(1.5, 0.6, 0.006, 0.025), lying = plates(0.6, 1.5, 0.025, 0.006);
  const double force = most(upright, true, along_z);
  CHECK(most(lying, false, along_y) == Approx(force).epsilon(1e-9));
  // By hand: q = V S/I = 1.75e6 x 1.292e6/2.435e9 = 928 N/mm beside a web, half of it counts.
  CHECK(force == Approx(0.5 * 928e3 * 1.45).epsilon(0.01));
}

TEST_CASE("torsion puts shear into all four plates: q = T/(2 A_m)", "[plates]") {
  const double T = 500e3;
  const Verification of = verified(cantilever(
      box("a", 600.0, 1224.0, 6.0, 8.0), segment(4.0, "a"),
      fmt::format("[loads.twist]\nkind = \"force\"\nat = \"4 m\"\nmoment = [\"{} N m\", \"0 N m\", "
                  "\"0 N m\"]\n",
                  T),
      "space = true\n"));
  const double A_m = (600.0 - 8.0) * (1224.0 - 6.0) * 1e-6;
  const double q = T / (2.0 * A_m);
  int plates = 0;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion != Criterion::shear_buckling) continue;
    const bool web = result.check.point.find("web") != std::string::npos;
    const double clear = web ? 1.212 : 0.584;
    // The walls' own torsion, sum of s t^3/3 of I_T, takes a little.
    CHECK(result.check.acting.value() == Approx(q * clear).epsilon(5e-4));
    plates += result.check.station.s.value() == 0.0 ? 1 : 0;
  }
  CHECK(plates == 4);
}

TEST_CASE("a weaker right web is judged as a weaker left one", "[plates]") {
  const auto factors = [](const std::string& plate, double web, double force) {
    const Verification of = verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, web), segment(1.0, "a"), tip(1.0, -force)) +
        "[[part_materials]]\nplates = [\"" + plate + "\"]\nsteel = \"S235\"\n");
    std::map<Criterion, double> found;
    for (const Criterion criterion :
         {Criterion::yield, Criterion::shear_buckling, Criterion::interaction})
      found[criterion] = use_of(of, criterion);
    return found;
  };
  for (const auto& [web, force] : {std::pair{8.0, 1200.0}, {25.0, 9000.0}}) {
    const auto left = factors("left web", web, force), right = factors("right web", web, force);
    for (const auto& [criterion, use] : left) {
      CAPTURE(to_text(criterion), web);
      CHECK(right.at(criterion) == Approx(use).epsilon(1e-9));
    }
  }
}

TEST_CASE("a column of strong flanges and weak webs does not bear what all strong would",
          "[plates]") {
  // A_eff = 16 427 mm^2, of which the webs 2 (1200 - 855.4) 8 = 5514: 10 913 x 355 + 5514 x 235 =
  // 5170 kN.
  const Verification of = verified(
      cantilever(box("a", 600.0, 1224.0, 12.0, 8.0), segment(1.0, "a"), tip(1.0, 0.0, -5500.0)) +
      "[[part_materials]]\nplates = [\"left web\", \"right web\"]\nsteel = \"S235\"\n");
  CHECK(use_of(of, Criterion::effective_section) > 5500.0 / 5170.0);
}

// kappa = 0.1: beta_1 = 1/(1 + 6.4 x 0.01) = 0.9398, 0.9398^0.1 = 0.9938; beta_2 = 0.6281,
// 0.6281^0.1 = 0.9546.
TEST_CASE("beta^kappa of both regions of a beam", "[plates]") {
  ShearLag lag;
  lag.kappa = 0.1;
  lag.beta = shear_lag_factor(0.1, BendingRegion::sagging);
  CHECK(ultimate_share_of(lag) == Approx(0.9938).margin(5e-5));
  lag.beta = shear_lag_factor(0.1, BendingRegion::hogging);
  CHECK(lag.beta == Approx(0.6281).margin(5e-5));
  CHECK(ultimate_share_of(lag) == Approx(0.9546).margin(5e-5));
}

TEST_CASE("sheets of plates that buckle end at the factor of the check", "[plates]") {
  const std::string plain = box("a", 600.0, 1224.0, 12.0, 8.0);
  const std::string webs = flats("a", "left web", {-350.0, -100.0}, 80.0, 8.0) +
                           flats("a", "right web", {-350.0, -100.0}, 80.0, 8.0);
  const std::string wide = box("a", 1400.0, 1224.0, 10.0, 8.0) + webs;
  for (const std::string& section :
       {plain, plain + webs, wide + flats("a", "bottom flange", {-250.0, 200.0}, 100.0, 10.0),
        wide + flats("a", "bottom flange", {-345.0, 0.0, 345.0}, 120.0, 12.0),
        wide + flats("a", "bottom flange", {-445.0, 0.0, 345.0}, 120.0, 12.0)}) {
    for (const double apart : {0.4, 2.0}) {
      std::vector<double> at;
      for (double s = 0.0; s < 2.0 + 1e-9; s += apart) at.push_back(s);
      const Project project = parse_project(
          "slender.toml",
          cantilever(section, segment(2.0, "a") + diaphragms(at), tip(2.0, -1000.0, -500.0)));
      const Verification of = verify(project);
      for (const Criterion criterion : plate_criteria) {
        const CheckResult* const result = of.governing(criterion);
        if (result == nullptr) continue;
        INFO(section);
        const report::Sheet sheet = test::sheet_to_factor(project, of, *result);
        // What is worked out of a plate is what its check has.
        for (const report::Step& step : sheet.steps) {
          if (step.symbol != "rho_c" || step.formulas.empty()) continue;
          const double rho_c = std::stod(step.formulas.back());
          bool known = false;
          for (int k = 0; k < 5; ++k) {
            for (const WallAlone& wall :
                 result->plates->plates->box.alone(static_cast<ActingAlone>(k)).walls) {
              const double has = wall.stiffened ? wall.stiffened->buckling.rho_c : wall.width.rho;
              known = known || std::abs(rho_c - has) < 1e-3 * has;
            }
          }
          CHECK(known);
        }
      }
    }
  }
}

TEST_CASE("no place between the stations is used more than what is reported", "[plates]") {
  test::Uniform in(5);
  int judged = 0;
  for (int i = 0; i < 25; ++i) {
    const double width = in(300.0, 700.0), web = in(5.0, 9.0), flange = in(8.0, 16.0);
    const double first = in(600.0, 1300.0), last = in(250.0, 600.0);
    const std::string text = cantilever(
        box("a", width, first, flange, web) + box("b", width, last, flange, web),
        segment(in(0.5, 2.0), "a") + taper(in(4.5, 8.0), "a", "b") + segment(1.0, "b") +
            (i % 3 == 0 ? diaphragms({0.0, in(1.0, 2.5), in(2.6, 4.0), in(4.1, 6.5)}) : ""),
        fmt::format("[loads.a]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"{} kN\", \"{} kN\"]\n"
                    "[loads.l]\nkind = \"line\"\nforce_per_length = [\"0 kN/m\", \"{} kN/m\"]\n",
                    in(1.0, 6.0), in(-200.0, 200.0), in(-200.0, 200.0), in(-60.0, 60.0)));
    // Every other one with webs of a weaker steel.
    const std::string webs =
        "[[part_materials]]\nplates = [\"left web\", \"right web\"]\nsteel = \"S235\"\n";
    CAPTURE(i);
    Project project = parse_project("slender.toml", i % 2 == 0 ? text : text + webs);
    judged += look_along(project, 1500);
    if (i % 6 != 1) continue;
    project.strength.effective_widths = i % 4 == 1 ? WidthRule::below_yield : WidthRule::annex_E;
    judged += look_along(project, 300);
  }
  CHECK(judged > 10'000);
}

}  // namespace plate_checks_test
