// Thin-walled paths of class 4 from the case to the verdict: a plate girder by hand, a box as a
// path against the box itself, and stations looked at one by one.

#include "boxbeam/verification/path_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/strength/shear_buckling.hpp"
#include "catch.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/path_cases.hpp"
#include "support/uniform.hpp"

namespace slender_path_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::girder;
using path_cases::girder_case;
using path_cases::held;
using path_cases::path_at;
using path_cases::section;

namespace {

bool is_judged(const Verification& of) {
  return !test::blocks(of, "class 4") &&
         std::any_of(of.checks.begin(), of.checks.end(),
                     [](const CheckResult& result) { return result.path.has_value(); });
}

}  // namespace

TEST_CASE("a plate girder of class 4 gets a verdict: effective section and shear by hand") {
  const double V = 150e3, L = 6.0;
  const Project project = parse_project("path.toml", girder_case(girder, L, -1e-3 * V));
  const Verification of = verify(project);
  CHECK(is_judged(of));
  // One pass by hand, tests/strength/effective_path_test.cpp: flange rho 0.7631, then the web. The
  // program goes on until nothing changes, which is up to 3 % less.
  const double eps = std::sqrt(235.0 / 355.0);
  const double flange = 6.0 + 2.0 * 0.76309 * 197.0;
  const double A = (flange + 400.0) * 12.0 + 7200.0;
  const double axis = (400.0 - flange) * 12.0 * 606.0 / A;  // towards the stretched flange
  const double psi = -(600.0 - axis) / (600.0 + axis);
  const double k = 7.81 - 6.29 * psi + 9.78 * psi * psi;
  const double lambda = 200.0 / (28.4 * eps * std::sqrt(k));
  const double rho = (lambda - 0.055 * (3.0 + psi)) / (lambda * lambda);
  const double pressed = 1200.0 / (1.0 - psi), idle = (1.0 - rho) * pressed;
  const double at_idle = 600.0 - 0.4 * rho * pressed - 0.5 * idle;  // from mid-height
  const double left = A - 6.0 * idle, moved = (A * axis + 6.0 * idle * at_idle) / left;
  const double I = (flange + 400.0) * (12.0 * 606.0 * 606.0 + 144.0) +
                   6.0 * std::pow(1200.0, 3) / 12 -
                   6.0 * (std::pow(idle, 3) / 12 + idle * at_idle * at_idle) - left * moved * moved;
  const double sigma = V * L * 1e3 * (606.0 + moved) / I;
  const CheckResult* const bent = of.governing(Criterion::effective_section);
  REQUIRE(bent != nullptr);
  CHECK(bent->check.station.s.value() == 0.0);
  CHECK(bent->check.acting.value() >= sigma * 1e6 * (1.0 - 1e-4));
  CHECK(bent->check.acting.value() <= sigma * 1e6 * 1.03);
  // h_w/t = 200, k_tau = 5.34: chi = 0.83 x 37.4 eps sqrt(5.34)/200. V_w is the integral of V S/I
  // over the clear web: all but what flows beyond it in the flanges.
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  const double chi = 0.83 * 37.4 * eps * std::sqrt(5.34) / 200.0;
  CHECK(shear->check.resisting.value() ==
        Approx(chi * 355e6 * 1.2 * 0.006 / std::sqrt(3.0)).epsilon(1e-9));
  const double I_gross =
      2.0 * 400.0 * (12.0 * 606.0 * 606.0 + 144.0) + 6.0 * std::pow(1200.0, 3) / 12;
  const double mean = 400.0 * 12.0 * 606.0 + 6.0 * 600.0 * 600.0 / 3.0;  // S over the web, mean
  CHECK(shear->check.acting.value() == Approx(V * mean * 1200.0 / I_gross).epsilon(1e-3));
  CHECK(shear->check.point == "wall 5");
  // The last step of each sheet is the factor of its check.
  int sheets = 0;
  for (const CheckResult& result : of.checks) {
    if (!result.path || result.check.station.s.value() > 0.0) continue;
    test::sheet_to_factor(project, of, result);
    ++sheets;
  }
  CHECK(sheets >= 2);
}

TEST_CASE("shear above half of the resistance takes from the moment of a girder, 7.1(1)",
          "[plates]") {
  const Project project = parse_project("path.toml", girder_case(girder, 1.5, -350.0));
  const Verification of = verify(project);
  const CheckResult* const both = of.governing(Criterion::interaction);
  REQUIRE(both != nullptr);
  CHECK(both->check.source == "EN 1993-1-5:2006, 7.1(1), equation 7.1");
  const double eta_1 = use_of(of, Criterion::effective_section);
  const double eta_3 = use_of(of, Criterion::shear_buckling);
  REQUIRE(eta_3 > 0.7);
  CHECK(both->check.utilisation() > std::max(eta_1, eta_3) * (1.0 - 1e-6));
  CHECK(both->check.utilisation() < 0.98 / interaction_factor(eta_1, eta_3));
  // kN and m; of the compressed flange 2 x 0.76309 x 197 mm work, what stands over the web is left
  // out.
  const double F_c = 2.0 * 0.76309 * 197.0 * 12.0 * 0.355, F_t = 2.0 * 197.0 * 12.0 * 0.355;
  const double W = 7200.0 * 0.355, w = F_c - F_t, M_f = F_c * 1.212;
  const double M_pl = (F_c + F_t) * 0.606 + W * 1.2 / 4.0 * (1.0 - w * w / (W * W));
  const double f = 1.0 / both->check.utilisation(), m = 350.0 * 1.5 / M_pl;
  const double used = f * m + (1.0 - M_f / M_pl) * std::pow(2.0 * f * eta_3 - 1.0, 2);
  // Either 7.1(1) or clause 5 alone ends it.
  CHECK(used <= 1.0 + 1e-3);
  CHECK((std::abs(used - 1.0) < 1e-3 || f * eta_3 > 1.0 - 1e-3));
  test::sheet_to_factor(project, of, *both);
}

TEST_CASE("a box as a path is used as the box where no moment acts", "[plates]") {
  const double b = 600.0, h = 1224.0;
  const std::string pushed = segment(1.0, "a") + diaphragms({1.0});
  for (const auto& [N, V] : {std::pair{-3000.0, 0.0}, {0.0, -500.0}}) {
    const Verification as_box =
        verified(cantilever(box("a", b, h, 12.0, 8.0), pushed, tip(1.0, V, N)));
    const Verification as_path =
        verified(cantilever(section("a", box_path(b, h, 12.0, 8.0)), pushed, tip(1.0, V, N)));
    for (const Criterion criterion : {Criterion::effective_section, Criterion::shear_buckling}) {
      // One pass of the box and all of the path differ under M.
      if (criterion == Criterion::effective_section && V != 0.0) continue;
      CAPTURE(N, V, to_text(criterion));
      CHECK(use_of(as_path, criterion) == Approx(use_of(as_box, criterion)).epsilon(1e-6));
    }
    CHECK(use_of(as_path, Criterion::interaction) >=
          use_of(as_box, Criterion::interaction) * (1.0 - 1e-6));
  }
}

TEST_CASE("torsion of a box as a path: q = T/(2 A_m) in all four walls", "[plates]") {
  const double T = 500e3;
  const std::string twist = fmt::format(
      "[loads.twist]\nkind = \"force\"\nat = \"4 m\"\nmoment = [\"{} N m\", \"0 N m\", \"0 N "
      "m\"]\n",
      T);
  const Project project =
      parse_project("path.toml", cantilever(section("a", box_path(600.0, 1224.0, 6.0, 8.0)),
                                            segment(4.0, "a"), twist, "space = true\n"));
  const auto path = path_at(project, 2.0);
  REQUIRE(path != nullptr);
  CutForces cut{};
  cut.T = si<Moment>(T);
  const double q = T / (2.0 * 0.592 * 1.218);
  REQUIRE(path->sheared.size() == 4);
  for (const ShearedWall& wall : path->sheared)
    CHECK(wall.force_of(cut).value() == Approx(q * wall.panel.depth.value()).epsilon(5e-4));
}

namespace {

double beside_use_of(const Verification& of) {
  double most = 0.0;
  for (const CheckResult& result : of.beside)
    if (result.check.criterion == Criterion::reduced_stress)
      most = std::max(most, result.check.utilisation());
  return most;
}

/// Looks at the paths of so many stations one by one: none is used more than what is reported, by
/// reduced stresses beside the verdict neither. How many had one.
int look_along_path(const Project& project, int steps) {
  const Verification of = verify(project);
  const auto runs = run_situations(project, of.model.chosen);
  const auto zones = bending_zones_of(project, runs);
  std::map<Criterion, double> most;
  const auto take = [&](const std::vector<CheckResult>& checks) {
    for (const CheckResult& check : checks) {
      double& use = most[check.check.criterion];
      use = std::max(use, check.check.utilisation());
    }
  };
  for (int k = 0; k <= steps; ++k) {
    const Station station{project.beam.length() * (static_cast<double>(k) / steps), Side::both};
    const auto path = slender_path_at(project, zones, station);
    REQUIRE(path != nullptr);
    const auto histories = histories_at(runs, station);
    take(check_path(project, station, path, histories));
    take(check_reduced_path(project, station, path, histories));
  }
  const double section_use =
      std::max(use_of(of, Criterion::effective_section), use_of(of, Criterion::yield));
  constexpr double close = 1.0 + 1e-3;
  CHECK(most[Criterion::effective_section] <= section_use * close);
  CHECK(most[Criterion::shear_buckling] <= use_of(of, Criterion::shear_buckling) * close);
  CHECK(most[Criterion::interaction] <= std::max({use_of(of, Criterion::interaction), section_use,
                                                  use_of(of, Criterion::shear_buckling)}) *
                                            close);
  CHECK(most[Criterion::reduced_stress] <= beside_use_of(of) * close);
  if (!project.strength.shear_lag) CHECK(most[Criterion::reduced_stress] > 0.0);
  return steps + 1;
}

}  // namespace

TEST_CASE("no station of a path is used more than what is reported", "[plates]") {
  test::Uniform in(21);
  int judged = 0;
  for (int i = 0; i < 6; ++i) {
    const double b = in(300.0, 400.0), t = in(8.0, 12.0), web = in(6.0, 8.0);
    const ThinWalled deep = i_section(b, t, in(900.0, 1200.0), web);
    const ThinWalled shallow = i_section(b * in(0.7, 1.0), t, in(600.0, 900.0), web);
    const double L = 6.0;
    Project project = parse_project(
        "path.toml",
        cantilever(section("a", deep) + section("b", shallow),
                   taper(L, "a", "b") + diaphragms({0.0, 2.0, in(3.0, 5.0), L}) + held(L, 20),
                   tip(L, -in(20.0, 100.0), -in(0.0, 100.0))));
    project.strength.shear_lag = i % 2 == 1;
    judged += look_along_path(project, 60);
    if (i % 3 != 0) continue;
    project.strength.effective_widths = i == 0 ? WidthRule::below_yield : WidthRule::annex_E;
    judged += look_along_path(project, 30);
  }
  CHECK(judged > 300);
}

TEST_CASE("paths below yield are used no more than at yield, by annex E least", "[plates]") {
  // An upper flange so wide that it is stressed less than the lower one, which is stretched.
  const ThinWalled wide = i_section(600.0, 12.0, 700.0, 8.0, 14.0, 200.0);
  Project project = parse_project("path.toml", girder_case(wide, 4.0, 60.0));
  std::vector<double> uses;
  for (const WidthRule rule : {WidthRule::at_yield, WidthRule::below_yield, WidthRule::annex_E}) {
    project.strength.effective_widths = rule;
    const Verification of = verify(project);
    const CheckResult* const section = of.governing(Criterion::effective_section);
    REQUIRE(section != nullptr);
    uses.push_back(section->check.utilisation());
    CHECK(section->check.source.find(rule == WidthRule::at_yield ? "widths, 4.4)"
                                     : rule == WidthRule::below_yield
                                         ? "4.4(4)"
                                         : "annex E") != std::string::npos);
    test::sheet_to_factor(project, of, *section, 1e-3);
  }
  CHECK(uses[1] < 0.999 * uses[0]);
  CHECK(uses[2] <= uses[1]);
}

TEST_CASE("plates of a path by reduced stresses, beside the verdict", "[plates]") {
  SECTION("a flange that stands out, by hand") {
    // k = 0.43, sigma_E = 190e3 (12/197)^2 = 705.0, sigma_cr = 303.1 MPa; without shear lambda =
    // sqrt(355/303.1) = 1.0822, rho = (1.0822 - 0.188)/1.0822^2 = 0.7635.
    const Project project = parse_project("path.toml", girder_case(girder, 4.0, -50.0));
    const auto path = path_at(project, 1.0);
    REQUIRE(path != nullptr);
    const AreaSums& gross = path->section.path().gross;
    CutForces cut;
    cut.M_y = si<Moment>(500e3);
    int compressed = 0;
    for (const ReducedPlate& plate : path->reduced) {
      const PanelStress stress = plate.under(cut);
      if (!plate.held_at_high || !(stress.compression > Stress{})) continue;
      ++compressed;
      const double sigma = 500e3 * 0.606 / (gross.zz - gross.z * gross.z / gross.area);
      CHECK(stress.compression.value() == Approx(sigma).epsilon(1e-9));
      CHECK(plate.use(cut, 1.1) == Approx(1.1 * sigma / (0.7635 * 355e6)).epsilon(1e-3));
    }
    CHECK(compressed == 2);
    CHECK(path->reduced.size() == 5);
  }
  SECTION("a box as a path is used as the box") {
    const auto project_of = [](const std::string& sections) {
      return parse_project(
          "path.toml",
          cantilever(sections, segment(4.0, "a") + diaphragms({0.0, 2.0, 4.0}), tip(4.0, -100.0)));
    };
    const Project as_box = project_of(box("a", 600.0, 1200.0, 10.0, 8.0));
    const Project as_path = project_of(section("a", box_path(600.0, 1200.0, 10.0, 8.0)));
    const Station station{1.0 * metre, Side::both};
    const auto plates = slender_plates_at(as_box, {}, station);
    const auto path = slender_path_at(as_path, {}, station);
    REQUIRE(plates);
    REQUIRE(path);
    const auto most = [](const std::vector<ReducedPlate>& of, const CutForces& cut) {
      double use = 0.0;
      for (const ReducedPlate& plate : of) use = std::max(use, plate.use(cut, 1.1));
      return use;
    };
    for (const auto& [N, V, M] :
         {std::array{0.0, 400e3, 0.0}, {-1e6, 0.0, 0.0}, {0.0, 0.0, 1e6}, {-5e5, 2e5, -8e5}}) {
      CutForces cut;
      cut.N = si<Force>(N);
      cut.V_z = si<Force>(V);
      cut.M_y = si<Moment>(M);
      CHECK(most(path->reduced, cut) == Approx(most(plates->reduced, cut)).epsilon(2e-3));
    }
  }
  SECTION("its sheet ends at the factor of the check") {
    const Project project = parse_project("path.toml", girder_case(girder, 4.0, -150.0));
    const Verification of = verify(project);
    REQUIRE_FALSE(of.beside.empty());
    for (const CheckResult& result : of.beside) test::sheet_to_factor(project, of, result, 1e-3);
  }
}

TEST_CASE("where class 3 meets class 4 a path jumps by the standard's own and no more",
          "[plates]") {
  // Under N alone: the section's area against what of it works. Internal, c/t = 42 eps: lambda_p =
  // 42/56.8 = 0.7394, rho = 0.9500 (in 4.4(2) buckling begins at 38.2 eps, class 4 at 42 eps);
  // outstands, 14 eps: lambda_p = 14/(28.4 sqrt(0.43)) = 0.7518 above 0.748, rho = 0.9975.
  const double eps = std::sqrt(235.0 / 355.0);
  const auto use = [](double width, double depth) {
    const Verification of = verified(cantilever(
        section("a", i_section(width, 20.0, depth, 10.0)),
        segment(6.0, "a") + diaphragms({0.0, 6.0}, 30.0) + held(6.0, 20), tip(6.0, 0.0, -1000.0)));
    return std::max({use_of(of, Criterion::yield), use_of(of, Criterion::effective_section),
                     use_of(of, Criterion::interaction)});
  };
  const auto area = [](double width, double depth, double rho_f, double rho_w) {
    return 2.0 * 20.0 * (10.0 + rho_f * (width - 10.0)) + rho_w * 10.0 * depth;
  };
  // Jumps are the quotient across; beside them use goes by the area as it changes.
  constexpr double near = 1e-6;
  const double web = 42.0 * eps * 10.0, lambda = 42.0 / 56.8;
  const double rho = (lambda - 0.22) / (lambda * lambda);
  CHECK(rho == Approx(0.95).margin(1e-4));
  CHECK(use(300.0, web * (1.0 + near)) / use(300.0, web * (1.0 - near)) ==
        Approx(area(300.0, web, 1.0, 1.0) / area(300.0, web, 1.0, rho)).epsilon(1e-5));
  const double wide = 2.0 * 14.0 * eps * 20.0 + 10.0;
  const double tip_lambda = 14.0 / (28.4 * std::sqrt(0.43));
  const double tip_rho = (tip_lambda - 0.188) / (tip_lambda * tip_lambda);
  CHECK(tip_rho == Approx(0.9975).margin(1e-4));
  CHECK(use(wide * (1.0 + near), 300.0) / use(wide * (1.0 - near), 300.0) ==
        Approx(area(wide, 300.0, 1.0, 1.0) / area(wide, 300.0, tip_rho, 1.0)).epsilon(1e-5));
  // Everywhere else without a step: N's resistance over small ones of the depth.
  double before = 0.0;
  for (double depth = 0.9 * web; depth < 1.15 * web; depth += 0.01 * web) {
    const double now = use(300.0, depth);
    const bool across = depth > web && depth - 0.01 * web <= web;
    if (before > 0.0) {
      CHECK(now > before / 1.01);
      CHECK(now < before * (across ? 1.03 : 1.0));
    }
    before = now;
  }
}

TEST_CASE("splitting its walls changes no verdict of a path", "[plates]") {
  const Verification whole = verified(girder_case(girder, 6.0, -100.0));
  const Verification in_two =
      verified(girder_case(split(split(girder, 4, 0.35), 0, 0.5), 6.0, -100.0));
  for (const Criterion criterion : {Criterion::yield, Criterion::effective_section,
                                    Criterion::shear_buckling, Criterion::interaction}) {
    CAPTURE(to_text(criterion));
    CHECK(use_of(in_two, criterion) == Approx(use_of(whole, criterion)).epsilon(1e-6));
  }
  CHECK(in_two.verdict == whole.verdict);
}

}  // namespace slender_path_test
