// Thin-walled paths of class 4 from the case to the verdict: a plate girder by hand, a box as a
// path against the box itself, stations looked at one by one, and what must not be judged so.

#include "boxbeam/verification/path_checks.hpp"

#include <cmath>
#include <random>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"

namespace slender_path_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::held;
using path_cases::section;

namespace {

/// S355, flanges 400 x 12, web 1200 x 6: both of class 4.
const ThinWalled girder = i_section(400.0, 12.0, 1200.0, 6.0);

std::string girder_case(const ThinWalled& path, double length, double V, double N = 0.0,
                        const std::string& more = "") {
  return cantilever(section("a", path),
                    segment(length, "a") + diaphragms({length}) + held(length, 20) + more,
                    tip(length, V, N));
}

bool has_blocking_gate(const Verification& of, const std::string& words) {
  return std::any_of(of.gates.begin(), of.gates.end(), [&](const Gate& gate) {
    return gate.blocks && gate.finding.find(words) != std::string::npos;
  });
}

bool is_judged(const Verification& of) {
  return !has_blocking_gate(of, "class 4") &&
         std::any_of(of.checks.begin(), of.checks.end(),
                     [](const CheckResult& result) { return result.path.has_value(); });
}

std::shared_ptr<const SlenderPath> at(const Project& project, double s) {
  return slender_path_at(project, {}, {s * metre, Side::both});
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
    INFO(result.check.id);
    const report::Sheet sheet = sheet_of(project, of, result);
    REQUIRE(!sheet.steps.empty());
    const report::Step& last = sheet.steps.back();
    CHECK(last.symbol == "factor");
    REQUIRE(!last.formulas.empty());
    CHECK(std::stod(last.formulas.back()) == Approx(result.check.safety_factor).epsilon(6e-4));
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
  const report::Sheet sheet = sheet_of(project, of, *both);
  CHECK(std::stod(sheet.steps.back().formulas.back()) ==
        Approx(both->check.safety_factor).epsilon(6e-4));
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
  const auto path = at(project, 2.0);
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
  std::mt19937 random(21);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
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
    const report::Sheet sheet = sheet_of(project, of, *section);
    CHECK(std::stod(sheet.steps.back().formulas.back()) ==
          Approx(section->check.safety_factor).epsilon(1e-3));
  }
  CHECK(uses[1] < 0.999 * uses[0]);
  CHECK(uses[2] <= uses[1]);
}

TEST_CASE("plates of a path by reduced stresses, beside the verdict", "[plates]") {
  SECTION("a flange that stands out, by hand") {
    // k = 0.43, sigma_E = 190e3 (12/197)^2 = 705.0, sigma_cr = 303.1 MPa; without shear lambda =
    // sqrt(355/303.1) = 1.0822, rho = (1.0822 - 0.188)/1.0822^2 = 0.7635.
    const Project project = parse_project("path.toml", girder_case(girder, 4.0, -50.0));
    const auto path = at(project, 1.0);
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
    for (const CheckResult& result : of.beside) {
      const report::Sheet sheet = sheet_of(project, of, result);
      REQUIRE_FALSE(sheet.steps.empty());
      CHECK(std::stod(sheet.steps.back().formulas.back()) ==
            Approx(result.check.safety_factor).epsilon(1e-3));
    }
  }
}

TEST_CASE("of open sections it is said what is taken for granted of them, not of a box",
          "[plates]") {
  const auto remark = [](const std::string& sections) {
    const Project project = parse_project(
        "path.toml", cantilever(sections, segment(4.0, "a") + held(4.0, 20), tip(4.0, -20.0)));
    for (const Remark& of : remarks_of(project, verify(project)))
      if (of.text.starts_with("not checked here")) return of.text;
    return std::string();
  };
  const std::string open = remark(section("a", girder));
  CHECK(open.find("of the box") == std::string::npos);
  CHECK(open.find("open sections") != std::string::npos);
  CHECK(open.find("shear centre") != std::string::npos);
  const std::string closed = remark(section("a", box_path(600.0, 1200.0, 10.0, 8.0)));
  CHECK(closed.find("distortion of the box") != std::string::npos);
  CHECK(closed.find("open sections") == std::string::npos);
}

TEST_CASE("what stands beside a web bounds its panels where it is rigid (9.3.3)", "[plates]") {
  const auto panel = [](const ThinWalled& path, double thickness, double opening) {
    const Project project = parse_project(
        "path.toml",
        cantilever(section("a", path),
                   segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}, thickness, opening) +
                       held(6.0, 20),
                   tip(6.0, -100.0)));
    return at(project, 3.0)->sheared.back().panel.length;
  };
  // Web 1200 x 6, a = 2 m: 0.75 x 1200 x 216 = 194400 mm^4 (a above sqrt(2) h_w: 1.697 m). Of the
  // web 2 x 73.2 + 10 = 156.5 mm, 2817 mm^4. Flats of 10 mm: (2 b + 6)^3 - 6^3 = 12/10 x 191583 or
  // more: b = 27.65 mm.
  REQUIRE(panel(girder, 20.0, 0.0));
  CHECK(panel(girder, 20.0, 0.0)->value() == Approx(2.0));
  // Of 197 mm on each side what the opening leaves.
  CHECK(panel(girder, 10.0, 2.0 * (197.0 - 28.0)));
  CHECK_FALSE(panel(girder, 10.0, 2.0 * (197.0 - 27.0)));
  // What twists bounds nothing: 106/10 (9.2.1(8)), as that of 1 mm.
  CHECK(panel(girder, 10.0, 2.0 * (197.0 - 105.0)));
  CHECK_FALSE(panel(girder, 10.0, 2.0 * (197.0 - 106.0)));
  CHECK_FALSE(panel(girder, 1.0, 0.0));
  // Flanges that lean by 0.14 degrees change nothing of that.
  ThinWalled leaning = girder;
  for (SectionPlace& node : leaning.nodes)
    if (node.y.value() > 0.1) node.z += si<Length>(0.5e-3);
  CHECK(panel(leaning, 10.0, 2.0 * (197.0 - 28.5)));
  CHECK_FALSE(panel(leaning, 10.0, 2.0 * (197.0 - 27.0)));
  CHECK_FALSE(panel(leaning, 1.0, 0.0));
}

TEST_CASE("a plate on one side of a web bounds its panels by what is beside the web", "[plates]") {
  // Web 1200 x 6 of a channel with flanges to 103 mm beside its mid-line: 100 mm of flat. With the
  // 156.5 x 6 = 939 mm^2 of the web I = 2817 + 10 b^3/12 + 939 x 10 b/(939 + 10 b) (b + 6)^2/4 =
  // 194400: b = 39.2 mm (about the web's middle, without the web, it would be 35.8 mm). A hole in
  // the middle leaves half of the rest at the web.
  const auto panel = [](double opening) {
    const Project project = parse_project(
        "path.toml", cantilever(section("a", channel(1224.0, 103.0, 6.0, 12.0)),
                                segment(6.0, "a") +
                                    diaphragms({0.0, 2.0, 4.0, 6.0}, 10.0, opening) + held(6.0, 20),
                                tip(6.0, -10.0)));
    const auto path = at(project, 3.0);
    for (const ShearedWall& wall : path->sheared)
      if (wall.panel.depth.value() > 1.0) return wall.panel.length;
    return std::optional<Length>();
  };
  CHECK(panel(0.0));
  CHECK(panel(100.0 - 2.0 * 40.0));
  CHECK_FALSE(panel(100.0 - 2.0 * 38.5));
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

TEST_CASE("what of a path is not judged keeps the verdict back", "[plates]") {
  SECTION("a force without a diaphragm that the web does not bear under an edge") {
    // 84 kN at the end of the beam: EN 1993-1-5, 6.5 type c with l_e = 0.
    const auto under = [](double kN) {
      return verified(
          cantilever(section("a", girder), segment(6.0, "a") + held(6.0, 20), tip(6.0, -kN)));
    };
    const Verification of = under(100.0);
    CHECK(has_blocking_gate(of, "clause 6"));
    CHECK(of.verdict == Verdict::not_applicable);
    CHECK(!has_blocking_gate(under(50.0), "clause 6"));
    CHECK(!has_blocking_gate(verified(girder_case(girder, 6.0, -50.0)), "clause 6"));
  }
  SECTION("a rib, a lip, reduced stresses, steep walls") {
    const auto found = [](const ThinWalled& path, const std::string& words,
                          const std::string& strength = "") {
      const Verification of = verified(
          cantilever(section("a", path), segment(2.0, "a") + diaphragms({2.0}) + held(2.0, 20),
                     tip(2.0, -0.5), "", strength));
      CAPTURE(words);
      CHECK(of.verdict == Verdict::not_applicable);
      CHECK(has_blocking_gate(of, words));
      CHECK(of.governing(Criterion::effective_section) == nullptr);
    };
    ThinWalled ribbed = girder;
    ribbed = split(ribbed, 4, 0.2);
    const std::size_t foot = ribbed.nodes.size() - 1;
    add_wall(ribbed, foot, add_node(ribbed, mm_place(80.0, 363.6)), 8.0);
    found(ribbed, "a rib stands on it");
    ThinWalled lipped = channel(300.0, 150.0, 2.0, 2.0);
    add_wall(lipped, lipped.walls[0].from, add_node(lipped, mm_place(150.0, 100.0)), 2.0);
    add_wall(lipped, lipped.walls[2].to, add_node(lipped, mm_place(150.0, -100.0)), 2.0);
    found(lipped, "a lip alone");
    found(girder, "plates = \"effective widths\"", "plates = \"reduced stresses\"\n");
    // 400/(2000) is 11.3 degrees on each side.
    const Verification steep = verified(
        cantilever(section("a", girder) + section("b", i_section(400.0, 12.0, 400.0, 6.0)),
                   taper(2.0, "a", "b") + diaphragms({2.0}) + held(2.0, 20), tip(2.0, -10.0)));
    CHECK(has_blocking_gate(steep, "above 10 deg"));
  }
  SECTION("a web into which its flange may buckle: 0.55 E/f_y sqrt(A_w/A_fc)") {
    // 0.55 x 591.5 x sqrt(1500 x 5/(500 x 40)) = 199 < 300.
    const Verification of = verified(girder_case(i_section(500.0, 40.0, 1500.0, 5.0), 6.0, -50.0));
    CHECK(has_blocking_gate(of, "its flange may buckle into it"));
  }
  SECTION("the stem of a T that bears shear") {
    ThinWalled tee;
    const std::size_t top = add_node(tee, mm_place(0.0, 100.0));
    add_wall(tee, add_node(tee, mm_place(100.0, 100.0)), top, 10.0);
    add_wall(tee, top, add_node(tee, mm_place(-100.0, 100.0)), 10.0);
    add_wall(tee, top, add_node(tee, mm_place(0.0, -200.0)), 6.0, 5.0);
    CHECK(has_blocking_gate(verified(girder_case(tee, 0.5, -60.0)), "free edge"));
  }
  SECTION("fatigue of flanges that shear lag reduces") {
    const std::string cycles =
        "[[situations]]\nname = \"on\"\nloads = { tip = 1.0 }\n"
        "[[situations]]\nname = \"off\"\nloads = { tip = 0.0 }\n"
        "[[situations]]\nname = \"lift\"\nbetween = [\"on\", \"off\"]\ncycles = 1000\n";
    for (const bool counts : {false, true}) {
      Project project =
          parse_project("path.toml", girder_case(girder, 2.0, -20.0, 0.0) + fatigue + cycles);
      CHECK(!has_blocking_gate(verify(project), "shear lag"));
      project.strength.shear_lag = true;
      project.fatigue.asked = counts;
      const Verification of = verify(project);
      CHECK(has_blocking_gate(of, "shear lag") == counts);
      CHECK(has_gate(of, "shear lag"));
    }
  }
}

TEST_CASE("shear lag of a girder's flanges: beta^kappa of EN 1993-1-5, 3.3, by hand", "[plates]") {
  // Flanges of class 3 and better (172/16 = 10.8), a web of class 4; clamped: L_e = 2 L.
  Project project =
      parse_project("path.toml", girder_case(i_section(350.0, 16.0, 1200.0, 8.0), 2.0, -300.0));
  const Station root{Length{}, Side::behind};
  const auto at_root = [&](const Verification& of) {
    const auto runs = run_situations(project, of.model.chosen);
    return slender_path_at(project, bending_zones_of(project, runs), root);
  };
  const auto without = at_root(verify(project));
  project.strength.shear_lag = true;
  const Verification of = verify(project);
  const auto with = at_root(of);
  REQUIRE((without && with));
  const double kappa = 175.0 / 4000.0;
  const double beta = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  const double works = std::pow(beta, kappa);
  REQUIRE(works < 0.995);
  for (const PlateAlone& plate : with->section.alone(ActingAlone::M_y_positive).plates)
    CHECK((plate.lag == 1.0 || plate.lag == Approx(works).epsilon(1e-9)));
  // All four outstands lose that of 171 mm at 608 mm, pressed or not; N loses nothing.
  const auto sums = [](const std::shared_ptr<const SlenderPath>& path, ActingAlone acting) {
    return path->section.alone(acting).sums.area;
  };
  CHECK(sums(with, ActingAlone::compression) == sums(without, ActingAlone::compression));
  const double lost = 4.0 * (1.0 - works) * 171.0 * 16.0e-6;
  CHECK(sums(without, ActingAlone::M_y_positive) - sums(with, ActingAlone::M_y_positive) ==
        Approx(lost).epsilon(0.02));
  CutForces cut;
  cut.M_y = si<Moment>(600e3);
  const double more = with->section.use(cut) / without->section.use(cut);
  CHECK(more > 1.0);
  CHECK(more < 1.0 / works);
  CHECK(use_of(of, Criterion::effective_section) >= 0.999 * with->section.use(cut));
}

TEST_CASE("shear lag of a box as a path is that of the box", "[plates]") {
  // Plates so stout that all of their width would work: no passes differ. Webs of class 4.
  const std::string more = diaphragms({2.0}) + held(2.0, 20);
  const auto use = [&](const std::string& of) {
    Project project =
        parse_project("path.toml", cantilever(of, segment(2.0, "a") + more, tip(2.0, -300.0)));
    project.strength.shear_lag = true;
    const Verification found = verify(project);
    return use_of(found, Criterion::effective_section);
  };
  const double as_box = use(box("a", 600.0, 1200.0, 20.0, 9.0));
  const double as_path = use(section("a", box_path(600.0, 1200.0, 20.0, 9.0)));
  CHECK(as_box > 0.05);
  CHECK(as_path >= as_box * (1.0 - 1e-6));
  CHECK(as_path <= as_box * 1.03);
}

TEST_CASE("a web that breathes, and a plate of which less than half works, keep fatigue back",
          "[plates]") {
  const std::string cycles =
      "[[situations]]\nname = \"on\"\nloads = { tip = 1.0 }\n"
      "[[situations]]\nname = \"off\"\nloads = { tip = 0.0 }\n"
      "[[situations]]\nname = \"lift\"\nbetween = [\"on\", \"off\"]\ncycles = 1000\n";
  // tau = 200e3/7200 = 28 MPa; sigma_E = 190e3/200^2 = 4.75 MPa: 1.1 x 28/(5.34 x 4.75) = 1.2.
  CHECK(has_gate(verified(girder_case(girder, 1.0, -200.0) + fatigue + cycles), "breathes"));
  // Its web, evenly compressed by 150 MPa: lambda_red = 200/(28.4 eps 2) sqrt(150/355) = 2.8.
  CHECK(has_gate(verified(girder_case(girder, 1.0, 0.0, -2500.0) + fatigue + cycles),
                 "less than 0.5"));
}

TEST_CASE("a path that turns over is judged as a member by its effective section", "[plates]") {
  const Verification of = verified(
      cantilever(section("a", girder), segment(12.0, "a") + diaphragms({12.0}) + held(12.0, 1),
                 tip(12.0, -20.0)));
  REQUIRE(of.model.second_order.lateral);
  REQUIRE(of.model.second_order.lateral->part > no_turning_over_below);
  const auto member = std::find_if(
      of.checks.begin(), of.checks.end(),
      [](const CheckResult& result) { return result.check.id == "member-buckling/sideways"; });
  if (of.model.second_order.lateral->part < 1.0) {
    REQUIRE(member != of.checks.end());
    // M/(W_eff f_y), by the hand calculation above: more than by the whole section.
    const CheckResult* const bent = of.governing(Criterion::effective_section);
    REQUIRE(bent != nullptr);
    CHECK(member->member->load.bent >= bent->check.utilisation() * (1.0 - 1e-6));
  }
}

TEST_CASE("a box that turns over is judged as a member by its effective section, too", "[plates]") {
  // Webs 1484 x 8 of class 4. By hand EI_z = 25, G I_T = 36 MN m^2, M_cr = 4.0 sqrt(EI_z GI_T)/L =
  // 4 MN m of a cantilever of 30 m (Timoshenko, Gere 6.3): 0.9 MN m are between 0.04 and 1 of it.
  const Verification of =
      verified(cantilever(box("a", 150.0, 1500.0, 8.0, 8.0),
                          segment(30.0, "a") + diaphragms({30.0}), tip(30.0, -30.0)));
  REQUIRE(of.model.second_order.lateral);
  CHECK(of.model.second_order.lateral->part > no_turning_over_below);
  CHECK(of.model.second_order.lateral->part < 1.0);
  const auto member = std::find_if(
      of.checks.begin(), of.checks.end(),
      [](const CheckResult& result) { return result.check.id == "member-buckling/sideways"; });
  REQUIRE(member != of.checks.end());
  const CheckResult* const bent = of.governing(Criterion::effective_section);
  REQUIRE(bent != nullptr);
  CHECK(member->member->load.bent >= bent->check.utilisation() * (1.0 - 1e-6));
}

TEST_CASE("a wheel that starts at a diaphragm comes into the web behind it", "[plates]") {
  const auto wheel = [](const std::string& from, const std::string& to) {
    return "[loads.wheel]\nkind = \"wheels\"\nfrom = \"" + from + "\"\nto = \"" + to +
           "\"\nwheels = [{ force = [\"0 kN\", \"-280 kN\"] }]\n";
  };
  for (const auto& [from, to] : {std::pair{"0 m", "6 m"}, {"0.1 m", "5.9 m"}}) {
    CAPTURE(from);
    const Verification of = verified(cantilever(
        section("a", girder), segment(6.0, "a") + diaphragms({2.0, 4.0, 6.0}) + held(6.0, 20),
        "[supports.end]\nkind = \"roller\"\nat = \"6 m\"\n" + wheel(from, to)));
    CHECK(has_blocking_gate(of, "clause 6"));
  }
}

TEST_CASE("a load on a short length comes in like a force", "[plates]") {
  // 350 kN on 100 mm of a web of 6 mm.
  const std::string line =
      "[loads.q]\nkind = \"line\"\nfrom = \"1.45 m\"\nto = \"1.55 m\"\n"
      "force_per_length = [\"0 kN/m\", \"-3500 kN/m\"]\n";
  const std::string beam = segment(3.0, "a") + diaphragms({3.0}) + held(3.0, 20);
  // As the same force over as long a stiff bearing, whose place is told, of a path and of a box.
  std::string plates;
  const auto use_of = [&](const std::string& loads, const std::string& more) {
    const Verification of = verified(cantilever(plates, beam + more, loads));
    const CheckResult* const worst = of.governing(Criterion::patch_loading);
    REQUIRE(worst != nullptr);
    return worst->check.utilisation();
  };
  double as_line = 0.0;
  for (const std::string& of : {section("a", girder), box("a", 400.0, 1200.0, 12.0, 6.0)}) {
    plates = of;
    as_line = use_of(line, "");
    const double as_force =
        use_of("[loads.q]\nkind = \"force\"\nat = \"1.5 m\"\nforce = [\"0 kN\", \"-350 kN\"]\n",
               "[[beam.load_introductions]]\nstation = \"1.5 m\"\nstiff_length = \"100 mm\"\n");
    CHECK(as_line == Approx(as_force).epsilon(0.02));
  }
  // Nor does it matter where segments meet.
  const std::string two = segment(1.5, "a") + segment(1.5, "a") + diaphragms({3.0}) + held(3.0, 20);
  const Verification across = verified(cantilever(plates, two, line));
  REQUIRE(across.governing(Criterion::patch_loading) != nullptr);
  CHECK(across.governing(Criterion::patch_loading)->check.utilisation() ==
        Approx(as_line).epsilon(0.02));
}

TEST_CASE(
    "torque into a slender path around cells keeps the verdict back where nothing holds its shape",
    "[plates]") {
  const auto with = [](const std::vector<double>& at) {
    return verified(cantilever(
        section("a", box_path(1200.0, 1200.0, 8.0, 8.0)), segment(12.0, "a") + diaphragms(at),
        "[loads.twist]\nkind = \"force\"\nat = \"6 m\"\nforce = [\"0 N\", \"0 N\", \"0 N\"]\n"
        "moment = [\"600 kN m\", \"0 N m\", \"0 N m\"]\n",
        "space = true\n"));
  };
  CHECK(has_blocking_gate(with({12.0}), "cells"));
  CHECK_FALSE(has_blocking_gate(with({0.0, 6.0, 12.0}), "cells"));
}

}  // namespace slender_path_test
