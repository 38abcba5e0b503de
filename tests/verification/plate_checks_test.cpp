// Boxes of slender plates from the case to the verdict: against hand values, against stations
// looked at one by one, and what must not be judged so.

#include "boxbeam/verification/plate_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/slender_cases.hpp"

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

TEST_CASE("webs breathe under shear alone, and under tension with it", "[plates]") {
  // tau = 1e6/(2 x 1200 x 8) = 52 MPa; sigma_E = 190e9/150^2 = 8.44 MPa: 1.1 tau/(5.34 sigma_E) =
  // 1.27, above 1.1.
  const std::string cycles =
      "[[situations]]\nname = \"on\"\nloads = { tip = 1.0 }\n"
      "[[situations]]\nname = \"off\"\nloads = { tip = 0.0 }\n"
      "[[situations]]\nname = \"lift\"\nbetween = [\"on\", \"off\"]\ncycles = 1000\n";
  for (const double N : {0.0, 3000.0}) {
    const Verification of = verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, 8.0), segment(1.0, "a"), tip(1.0, -1000.0, N)) +
        fatigue + cycles);
    CAPTURE(N);
    CHECK(has_gate(of, "breathes"));
  }
}

TEST_CASE("slender webs along which a load runs have a verdict where they bear it under an edge",
          "[plates]") {
  const auto of = [&](double web, double force) {
    return verified(cantilever(
        box("a", 600.0, 1224.0, 20.0, web), segment(4.0, "a"),
        fmt::format(
            "[loads.trolley]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 kN\", \"{} kN\"] "
            "}}]\n",
            -force)));
  };
  // At the free end k_F = 2, l_e = 0: l_y = 20 sqrt(31.5/2 + 70.1) = 185 mm, F_Rd = 147 kN.
  CHECK(of(8.0, 400.0).verdict == Verdict::not_applicable);
  CHECK(has_gate(of(8.0, 400.0), "clause 6"));
  CHECK(of(8.0, 280.0).verdict == Verdict::pass);
  CHECK(of(8.0, 300.0).verdict == Verdict::not_applicable);
  CHECK(of(30.0, 400.0).verdict == Verdict::pass);
}

TEST_CASE("holes side by side count together", "[plates]") {
  const auto of = [](const std::string& levels) {
    return verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                   segment(4.0, "a") +
                       "[[beam.holes]]\nname = \"h\"\nstation = \"2 m\"\ndiameter = \"40 mm\"\n"
                       "through = \"webs\"\nlevels = [" +
                       levels + "]\nconcentration = \"in-plane bending\"\n",
                   tip(4.0, -10.0)));
  };
  // 0.05 x 1200 = 60 mm.
  CHECK(!has_gate(of("\"0 mm\""), "wider than 0.05"));
  CHECK(has_gate(of("\"-100 mm\", \"100 mm\""), "wider than 0.05"));
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
  int flanges = 0;
  for (const ShearedPlate& plate : plates->sheared) {
    if (plate.name.find("flange") == std::string::npos) continue;
    CutForces cut{};
    cut.V_z = si<Force>(V);
    CHECK((plate.force_of(cut) / (plate.panel.depth * plate.panel.thickness)).value() ==
          Approx(0.5 * largest).epsilon(0.01));
    ++flanges;
  }
  CHECK(flanges == 2);
}

namespace {

double shear_resistance_in(const Verification& of) {
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  return shear->check.resisting.value();
}

/// The web at a station of a case.
ShearedPlate web_at(const std::string& text, const Station& station) {
  const Project project = parse_project("slender.toml", text);
  const auto plates = slender_plates_at(project, {}, station);
  REQUIRE(plates != nullptr);
  for (const ShearedPlate& plate : plates->sheared)
    if (!is_flange(plate.plate)) return plate;
  FAIL("no web");
  return {};
}

}  // namespace

TEST_CASE("a flange of a box may buckle into its slender web: no verdict (clause 8)", "[plates]") {
  // Webs 1200 x t, flanges 600 x 40, which work whole (592/40 = 14.8): 0.55 x 210e3/355 sqrt(1200
  // t/ 12000) = 205.8 of t = 4 mm, where h_w/t = 300, and 230.1 of 5 mm, where it is 240; 252.0
  // of 6.
  const auto stops = [](double web) {
    const Verification of = verified(
        cantilever(box("a", 600.0, 1280.0, 40.0, web),
                   segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}, 20.0), tip(6.0, -50.0)));
    return of.verdict == Verdict::not_applicable && has_gate(of, "may buckle into");
  };
  CHECK(stops(4.0));
  CHECK(stops(5.0));
  CHECK_FALSE(stops(6.0));
}

TEST_CASE("a flat that ends inside a panel holds nothing of it: no verdict", "[plates]") {
  const auto with = [](const std::vector<double>& at) {
    const std::string more = flats("a", "top flange", {0.0}, 100.0, 12.0) +
                             flats("a", "bottom flange", {0.0}, 100.0, 12.0);
    return verified(
        cantilever(box("a", 900.0, 1000.0, 10.0, 20.0, more) + box("b", 900.0, 1000.0, 10.0, 20.0),
                   segment(2.0, "a") + segment(4.0, "b") + diaphragms(at), tip(6.0, -50.0)));
  };
  CHECK(has_gate(with({0.0, 6.0}), "ends at s = 2 m, inside its panel"));
  CHECK_FALSE(has_gate(with({0.0, 2.0, 6.0}), "inside its panel"));
}

TEST_CASE("diaphragms make panels of a web, and two at each end rigid end posts", "[plates]") {
  const auto resistance = [](const std::vector<double>& at, double thickness, double opening) {
    return shear_resistance_in(verified(
        cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                   segment(9.6, "a") + diaphragms(at, thickness, opening), tip(9.6, -400.0))));
  };
  // Web 1200 x 8, S355, a = 3 m: k_tau = 5.34 + 4 (1.2/3)^2 = 5.98, lambda_w = 2.016; 810 kN, with
  // rigid end posts 993 kN, by hand.
  CHECK(resistance({0.0, 3.0, 6.0, 9.0, 9.6}, 10.0, 0.0) == Approx(810e3).epsilon(1e-3));
  const std::vector<double> posts{0.0, 0.3, 3.3, 6.3, 9.3, 9.6};
  CHECK(resistance(posts, 10.0, 0.0) == Approx(993e3).epsilon(1e-3));
  // 4 h_w t^2/e = 1024 mm^2; 15 eps t_d^2 = 1220 mm^2 of 10 mm, 781 mm^2 of 8 mm; beside an access
  // hole of 460 mm 62 mm are left.
  CHECK(resistance(posts, 8.0, 0.0) == Approx(810e3).epsilon(1e-3));
  CHECK(resistance(posts, 10.0, 460.0) == Approx(810e3).epsilon(1e-3));
  // 42 mm beside one of 500 mm are too weak to bound panels: 10 x 42^3/12 + 1642 x 420/2062 x 25^2
  // = 271e3 mm^4, 0.75 x 1200 x 512 = 461e3 are asked for.
  CHECK(resistance(posts, 10.0, 500.0) == Approx(810e3 * std::sqrt(5.34 / 5.98)).epsilon(1e-3));
  // Only at one end.
  CHECK(resistance({0.0, 0.3, 3.3, 6.3, 9.3}, 10.0, 0.0) < 811e3);
  // Beyond the last diaphragm nothing shortens the panel: k_tau = 5.34.
  CHECK(resistance({0.0, 3.0, 6.0}, 10.0, 0.0) ==
        Approx(810e3 * std::sqrt(5.34 / 5.98)).epsilon(1e-3));
}

TEST_CASE("a panel that tapers is judged by the depth at each place, on both sides of a diaphragm",
          "[plates]") {
  const std::string text =
      cantilever(box("a", 600.0, 1224.0, 12.0, 8.0) + box("b", 600.0, 824.0, 12.0, 8.0),
                 taper(6.0, "a", "b") + diaphragms({0.0, 4.0, 6.0}), tip(6.0, -400.0));
  const auto slenderness = [](double depth, double length) {
    const double ratio = depth / length;
    const double k = ratio <= 1.0 ? 5.34 + 4.0 * ratio * ratio : 4.0 + 5.34 * ratio * ratio;
    return depth / 8.0 / (37.4 * std::sqrt(235.0 / 355.0) * std::sqrt(k));
  };
  const ShearedPlate shallow = web_at(text, {4.5 * metre});
  CHECK(shallow.panel.depth.value() == Approx(0.9));
  CHECK(shallow.resists.lambda_w == Approx(slenderness(900.0, 2000.0)).epsilon(1e-9));
  CHECK(shallow.resists.resistance.value() ==
        Approx(0.83 / slenderness(900.0, 2000.0) * 355e6 / std::sqrt(3.0) * 0.9 * 0.008)
            .epsilon(1e-9));
  const double deep = 1200.0 - 400.0 * 4.0 / 6.0;
  CHECK(web_at(text, {0.0 * metre}).resists.lambda_w ==
        Approx(slenderness(1200.0, 4000.0)).epsilon(1e-9));
  CHECK(web_at(text, {4.0 * metre, Side::before}).resists.lambda_w ==
        Approx(slenderness(deep, 4000.0)).epsilon(1e-9));
  CHECK(web_at(text, {4.0 * metre, Side::behind}).resists.lambda_w ==
        Approx(slenderness(deep, 2000.0)).epsilon(1e-9));
  // Without a side that of both together.
  CHECK(web_at(text, {4.0 * metre}).resists.lambda_w ==
        Approx(slenderness(deep, 6000.0)).epsilon(1e-9));
}

TEST_CASE("one more diaphragm never takes from a beam, a panel that is longer gives nothing",
          "[plates]") {
  std::mt19937 random(11);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int i = 0; i < 10; ++i) {
    const std::string sections =
        box("a", 600.0, in(900.0, 1300.0), 12.0, 8.0) + box("b", 600.0, 700.0, 12.0, 8.0);
    const double force = -in(200.0, 500.0);
    std::vector<double> at;
    double before = 1e9;
    for (int k = 0; k < 4; ++k) {
      const double use = use_of(
          verified(cantilever(sections, taper(8.0, "a", "b") + diaphragms(at), tip(8.0, force))),
          Criterion::shear_buckling);
      CHECK(use <= before * (1.0 + 1e-9));
      before = use;
      at.push_back(in(0.5, 7.5));
    }
  }
}

TEST_CASE("diaphragms that cannot be are refused", "[plates]") {
  const auto said = [](const std::string& more) -> std::string {
    try {
      parse_project("slender.toml", cantilever(box("a", 600.0, 1224.0, 12.0, 8.0),
                                               segment(6.0, "a") + more, tip(6.0, -400.0)));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(said(diaphragms({0.0, 6.0})).empty());
  CHECK(said(diaphragms({3.0, 3.0})).find("there is already a diaphragm at this station") !=
        std::string::npos);
  CHECK(said(diaphragms({3.0}, 10.0, 600.0)).find("the access hole is as wide as the beam") !=
        std::string::npos);
  CHECK(said(diaphragms({6.5})).find("lies behind the end of the beam") != std::string::npos);
}

TEST_CASE("no place between the stations is used more than what is reported", "[plates]") {
  std::mt19937 random(5);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
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

TEST_CASE("a flange of 1000 x 10 mm with a flat, compressed: by hand", "[plates]") {
  // Box 1024 x 820 mm, webs 800 x 12, diaphragms every 2 m; flat 120 x 12 in the middle of the
  // bottom flange. Its rho 0.74296 and rho_c 0.71932 by hand in stiffened_plate_test. Of the flange
  // work 2 x 0.74296 x 247 mm at the edges wholly, 0.74296 x 494 + 12 mm and the flat by rho_c. The
  // webs: psi near -0.7, lambda_p = 66.7/(28.4 x 0.8136 sqrt(17)) = 0.70: whole.
  const std::string steel_box = box("a", 1024.0, 820.0, 10.0, 12.0);
  const Verification of = verified(
      cantilever(steel_box + flats("a", "bottom flange", {0.0}, 120.0, 12.0),
                 segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}), tip(8.0, -200.0)));
  const double rho = 0.742961, rho_c = 0.719325;
  const double wide = 24.0 + 2.0 * rho * 247.0 + rho_c * (rho * 494.0 + 12.0);
  struct Part {
    double area, z, own;
  };
  const std::vector<Part> parts{{10240.0, 405.0, 1024.0 * 1000.0 / 12.0},
                                {10.0 * wide, -405.0, wide * 1000.0 / 12.0},
                                {19200.0, 0.0, 24.0 * std::pow(800.0, 3) / 12.0},
                                {rho_c * 1440.0, -340.0, rho_c * 12.0 * std::pow(120.0, 3) / 12.0}};
  double A = 0.0, S = 0.0, I = 0.0;
  for (const Part& part : parts) {
    A += part.area;
    S += part.area * part.z;
    I += part.own + part.area * part.z * part.z;
  }
  const double z = S / A;
  I -= A * z * z;
  const CheckResult* const section = of.governing(Criterion::effective_section);
  REQUIRE(section != nullptr);
  CHECK(section->check.id == "effective-section/0+/bottom-flange");
  CHECK(section->check.acting.value() == Approx(200e3 * 8e3 * (405.0 + z) / I * 1e6).epsilon(1e-5));
  // Without the flat: lambda_p = 100/(28.4 x 0.8136 x 2) = 2.164, rho = 0.415.
  const double bare = use_of(
      verified(cantilever(steel_box, segment(8.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0, 8.0}),
                          tip(8.0, -200.0))),
      Criterion::effective_section);
  CHECK(bare > 1.1 * section->check.utilisation());
}

TEST_CASE("webs with stiffeners bear more shear, by hand", "[plates]") {
  // Web 1200 x 8, flat 90 x 9 at mid-height, diaphragms every 3 m: plate 2 x 15 x 0.8136 x 8 + 9 =
  // 204.3 mm = 1634 mm^2, A = 810, I = 810 x 90^2/12 + 204.3 x 8^3/12 + 1634 x 810/2444 x 49^2 =
  // 1.8557e6; theta = 1.8557e6/(8^3 x 1200) = 3.0203. k_tau = 4.1 + (6.3 + 0.5437) x 0.16 + 2.2 x
  // 1.4455 = 8.3751; lambda_w = 150/(37.4 x 0.8136 sqrt(8.3751)) = 1.7034, subpanel 595.5 x 8:
  // 74.44/(37.4 x 0.8136 x 2.3428) = 1.044.
  const Verification of = verified(
      cantilever(box("a", 600.0, 1224.0, 12.0, 8.0) + flats("a", "left web", {0.0}, 90.0, 9.0) +
                     flats("a", "right web", {0.0}, 90.0, 9.0),
                 segment(9.0, "a") + diaphragms({0.0, 3.0, 6.0, 9.0}), tip(9.0, -400.0)));
  CHECK(shear_resistance_in(of) ==
        Approx(0.83 / 1.7034 * 355.0 * 1200.0 * 8.0 / std::sqrt(3.0)).epsilon(1e-3));
  // The shear flow passes the foot of the stiffener: both webs carry V less what is in the flanges.
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  CHECK(shear->check.acting.value() > 0.97 * 200e3);
  CHECK(shear->check.acting.value() < 200e3);
}

TEST_CASE("short panels between diaphragms buckle like columns, bare ones too", "[plates]") {
  // Flange 876 x 8 mm, clear, of S355: from a = 0.707 b on as a long plate; below, less.
  const auto use = [](double apart) {
    std::vector<double> at;
    for (double s = 0.0; s < 6.0 + 1e-9; s += apart) at.push_back(s);
    return use_of(verified(cantilever(box("a", 900.0, 600.0, 8.0, 12.0),
                                      segment(6.0, "a") + diaphragms(at), tip(6.0, -50.0))),
                  Criterion::effective_section);
  };
  CHECK(use(1.0) == Approx(use(3.0)).epsilon(1e-9));
  CHECK(use(0.5) > 1.1 * use(3.0));
}

TEST_CASE("stiffened boxes: no place between the stations is used more than what is reported",
          "[plates]") {
  std::mt19937 random(45);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  int judged = 0;
  for (int i = 0; i < 20; ++i) {
    const double width = in(500.0, 1200.0), web = in(6.0, 9.0), flange = in(8.0, 12.0);
    const double first = in(900.0, 1500.0), last = in(600.0, 900.0);
    const auto stiffened = [&](const std::string& name, double height) {
      const double d = 100.0, t = 10.0, b = width - 2.0 * web;
      std::string text = box(name, width, height, flange, web);
      if (i % 4 == 0) text += flats(name, "bottom flange", {0.0}, d, t);
      if (i % 4 == 1) text += flats(name, "top flange", {-b / 6.0, b / 6.0}, d, t);
      if (i % 4 == 2) text += flats(name, "bottom flange", {-b / 4.0, 0.0, b / 4.0}, d, t);
      if (i % 4 != 2) {
        for (const char* on : {"left web", "right web"})
          text += flats(name, on, {-0.2 * height, 0.15 * height}, d, t);
      }
      return text;
    };
    std::vector<double> at;
    if (i % 3 != 0) at = {0.0, in(1.0, 2.5), in(2.6, 4.0), in(4.1, 6.5)};
    const std::string text = cantilever(
        stiffened("a", first) + stiffened("b", last),
        segment(in(0.5, 2.0), "a") + taper(in(4.5, 8.0), "a", "b") + segment(1.0, "b") +
            diaphragms(at),
        fmt::format("[loads.a]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"{} kN\", \"{} kN\"]\n"
                    "[loads.l]\nkind = \"line\"\nforce_per_length = [\"0 kN/m\", \"{} kN/m\"]\n",
                    in(1.0, 6.0), in(-200.0, 200.0), in(-200.0, 200.0), in(-60.0, 60.0)));
    CAPTURE(i);
    judged += look_along(parse_project("slender.toml", text), 1000);
  }
  CHECK(judged > 10'000);
}

TEST_CASE("a flange with stiffeners counts in shear with its subpanel that is sheared most",
          "[plates]") {
  // Of its shear under V_z, V z y/I without flats, the outer third has 2/3 of that at the web,
  // mean.
  const double V = 300e3;
  const Project project = parse_project(
      "slender.toml", cantilever(box("a", 924.0, 600.0, 8.0, 12.0) +
                                     flats("a", "top flange", {-150.0, 150.0}, 80.0, 8.0) +
                                     flats("a", "bottom flange", {-150.0, 150.0}, 80.0, 8.0),
                                 segment(4.0, "a"), tip(4.0, -1e-3 * V)));
  const auto plates = slender_plates_at(project, {}, {Length{}, Side::behind});
  REQUIRE(plates != nullptr);
  // Flats of 640 mm^2, centroid 252 mm from the middle: the flow at y is V (8 y 296 + what hangs on
  // the way in)/I; from 150 mm on one flat is on the way.
  const double I = (0.924 * std::pow(0.6, 3) - 0.9 * std::pow(0.584, 3)) / 12.0 +
                   4.0 * (0.008 * std::pow(0.08, 3) / 12.0 + 640e-6 * 0.252 * 0.252);
  const double mean = V * (0.008 * 0.296 * 0.5 * (0.150 + 0.450) + 640e-6 * 0.252) / (I * 0.008);
  int flanges = 0;
  for (const ShearedPlate& plate : plates->sheared) {
    if (!is_flange(plate.plate)) continue;
    CutForces cut{};
    cut.V_z = si<Force>(V);
    CHECK((plate.force_of(cut) / (plate.panel.depth * plate.panel.thickness)).value() ==
          Approx(mean).epsilon(0.02));
    ++flanges;
  }
  CHECK(flanges == 2);
}

TEST_CASE("where A.3 changes its formula, at a = 3 h_w, the search finds the worse side",
          "[plates]") {
  // Webs 1400 to 800 mm deep with one flat, a = 3.003 m: h_w is 1001 mm at s = 1.997 m, where k_tau
  // falls from that of A.5 to that of A.6. V only between 1.9 and 2.05 m.
  std::string sections;
  for (const auto& [name, height] : {std::pair{"a", 1424.0}, {"b", 824.0}}) {
    sections += box(name, 600.0, height, 12.0, 8.0) + flats(name, "left web", {0.0}, 90.0, 9.0) +
                flats(name, "right web", {0.0}, 90.0, 9.0);
  }
  const Verification of = verified(cantilever(
      sections, taper(3.003, "a", "b") + diaphragms({0.0, 3.003}),
      "[loads.down]\nkind = \"force\"\nat = \"2.05 m\"\nforce = [\"0 kN\", \"-400 kN\"]\n"
      "[loads.up]\nkind = \"force\"\nat = \"1.9 m\"\nforce = [\"0 kN\", \"400 kN\"]\n"));
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  CHECK(shear->check.station.s.value() == Approx(1.997).margin(2e-3));
  CHECK(shear->plates->plate->panel.depth.value() > 3.003 / 3.0);
}

TEST_CASE("plates that are not judged stop the verdict, with the reason", "[plates]") {
  const std::string slender = box("a", 600.0, 1224.0, 12.0, 8.0);
  const std::string force = tip(10.0, -10.0);
  const auto refused = [&](const std::string& text, const std::string& why) {
    const Verification of = verified(text);
    INFO(why);
    CHECK(of.verdict == Verdict::not_applicable);
    CHECK(has_gate(of, why));
  };
  CHECK(verified(cantilever(slender, segment(10.0, "a"), force)).verdict == Verdict::pass);
  // 13 eps = 10.6; gamma of 50 x 8 mm by hand: (83e3 + 400 x 3504/3904 x 31^2)/92.4e3 = 4.6.
  refused(cantilever(slender + flats("a", "bottom flange", {0.0}, 180.0, 12.0), segment(10.0, "a"),
                     force),
          "a stiffener of the bottom flange twists: d/t = 15");
  refused(cantilever(slender + flats("a", "bottom flange", {0.0}, 50.0, 8.0), segment(10.0, "a"),
                     force),
          "the stiffeners of the bottom flange are too weak, gamma = 4.6");
  // Between its flats the flange would be of class 3; with them it may buckle.
  refused(cantilever(
              box("a", 600.0, 400.0, 12.0, 12.0) + flats("a", "bottom flange", {0.0}, 180.0, 12.0),
              segment(10.0, "a"), force),
          "its stiffeners may buckle with it");
  refused(cantilever(slender,
                     segment(10.0, "a") + "[[beam.holes]]\nname = \"h\"\nstation = \"5 m\"\n"
                                          "diameter = \"100 mm\"\nthrough = \"webs\"\nlevels = "
                                          "[\"0 mm\"]\nconcentration = \"in-plane bending\"\n",
                     force),
          "wider than 0.05 of its plate");
}

TEST_CASE("fatigue of plates of which less than half works is not judged", "[plates]") {
  const std::string cycles =
      "[[situations]]\nname = \"on\"\nloads = { tip = 1.0 }\n"
      "[[situations]]\nname = \"off\"\nloads = { tip = 0.0 }\n"
      "[[situations]]\nname = \"lift\"\nbetween = [\"on\", \"off\"]\ncycles = 1000\n";
  const auto at = [&](double flange, double web, double force) {
    return verified(
        cantilever(box("a", 900.0, 1000.0, flange, web), segment(10.0, "a"), tip(10.0, -force)) +
        fatigue + cycles);
  };
  CHECK(!has_gate(at(16.0, 10.0, 10.0), "2.2(5)"));
  // Flange 880 x 8 mm under 250 MPa: lambda_red = 110/(28.4 x 0.8136 x 2) sqrt(250/355) = 2.0.
  CHECK(has_gate(at(8.0, 10.0, 260.0), "2.2(5)"));
  // Web 968 x 5 mm: sigma_E = 190e9/193.6^2 = 5.07 MPa; k_sigma of bending 23.9, so that it
  // breathes from 1.1 x 23.9 x 5.07 = 133 MPa on.
  CHECK(!has_gate(at(16.0, 5.0, 120.0), "breathes"));
  CHECK(has_gate(at(16.0, 5.0, 260.0), "breathes"));
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
        const report::Sheet sheet = sheet_of(project, of, *result);
        INFO(result->check.id);
        INFO(section);
        REQUIRE(!sheet.steps.empty());
        const report::Step& last = sheet.steps.back();
        CHECK(last.symbol == "factor");
        REQUIRE(!last.formulas.empty());
        CHECK(std::stod(last.formulas.back()) == Approx(result->check.safety_factor).epsilon(6e-4));
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

TEST_CASE("clause 8 asks of a box that lies on its side what it asks of the upright one",
          "[plates]") {
  const auto stops = [](double width, double height, double flange, double web, bool space) {
    const std::string load = space ? "[loads.tip]\nkind = \"force\"\nat = \"6 m\"\n"
                                     "force = [\"0 kN\", \"-50 kN\", \"0 kN\"]\n"
                                   : tip(6.0, -50.0);
    const Verification of =
        verified(cantilever(box("a", width, height, flange, web),
                            segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}, 20.0), load,
                            space ? "space = true\n" : ""));
    return has_gate(of, "may buckle into");
  };
  // The numbers of the upright box above: 4 mm stop, 6 mm do not.
  for (const double thin : {4.0, 6.0})
    CHECK(stops(1280.0, 600.0, thin, 40.0, true) == stops(600.0, 1280.0, 40.0, thin, false));
}

TEST_CASE("a flange that is pressed all over breathes below b/t = 120 as well", "[plates]") {
  // sigma_E = 190e9/116.8^2 = 13.93 MPa, k_sigma = 4: 1.1 x 4 x 13.93 = 61.3 MPa is the limit.
  const auto at = [](double moment) {
    return verified(
        cantilever(box("a", 1200.0, 800.0, 10.0, 16.0), segment(2.0, "a"),
                   "[loads.tip]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 kN\", \"0 kN\"]\n" +
                       fmt::format("moment = \"{:.17g} kN m\"\n", moment)) +
        fatigue +
        "[[situations]]\nname = \"on\"\nloads = { tip = 1.0 }\n"
        "[[situations]]\nname = \"off\"\nloads = { tip = 0.0 }\n"
        "[[situations]]\nname = \"lift\"\nbetween = [\"on\", \"off\"]\ncycles = 1000\n");
  };
  // I = (1200 x 800^3 - 1168 x 780^3)/12 = 5.01e9 mm^4: 395 mm from the axis 50 and 100 MPa.
  CHECK_FALSE(has_gate(at(634.0), "breathes"));
  CHECK(has_gate(at(1268.0), "breathes"));
}

TEST_CASE("the excavator's slender webs get a verdict between diaphragms alone", "[plates]") {
  Project project = read_project(test::project_file("sections/excavator-boom/boom.toml"));
  const Verification of = verify(project);
  CHECK(of.verdict == Verdict::pass);
  // Nothing says what bears the forces that come into slender webs.
  project.beam.diaphragms.clear();
  CHECK(verify(project).verdict == Verdict::not_applicable);
  // By hand, N and mm, as README.md of the case: N = -22 kN and M = 128.15 kN m where the force of
  // the cylinder comes in; webs of 500 x 8 under N alone.
  const CheckResult* const effective = of.governing(Criterion::effective_section);
  REQUIRE(effective != nullptr);
  const double lambda_p = 62.5 / (28.4 * std::sqrt(235.0 / 355.0) * 2.0);
  const double idle = (1.0 - (lambda_p - 0.22) / (lambda_p * lambda_p)) * 500.0;
  CHECK(1e-6 * effective->check.acting.value() ==
        Approx(22e3 / (14240.0 - 2.0 * idle * 8.0) + 128.15e6 * 256.0 / 5.753e8).epsilon(1e-3));
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  // The clear depth falls from 500 by 284 over the 3100 of the upper panel.
  const double depth = 500.0 - 284.0 * (shear->check.station.s.value() - 2.1) / 3.1;
  const double k_tau = 5.34 + 4.0 * std::pow(depth / 3100.0, 2);
  const double lambda = depth / 8.0 / (37.4 * std::sqrt(235.0 / 355.0) * std::sqrt(k_tau));
  const double chi = std::min(1.2, 0.83 / lambda);
  CHECK(shear->check.resisting.value() ==
        Approx(chi * 355.0 * depth * 8.0 / std::sqrt(3.0)).epsilon(5e-3));
  // Little shear, most of it bending: no more than a tenth of what the webs bear.
  CHECK(shear->check.utilisation() < 0.1);
}

}  // namespace plate_checks_test
