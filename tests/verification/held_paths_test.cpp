// What stands beside a slender path, holds it or lets it turn over: diaphragms that bound panels,
// shear lag of its flanges, and its check as a member.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "boxbeam/verification/path_checks.hpp"
#include "catch.hpp"
#include "support/path_cases.hpp"

namespace held_paths_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::girder;
using path_cases::girder_case;
using path_cases::held;
using path_cases::path_at;
using path_cases::section;

TEST_CASE("what stands beside a web bounds its panels where it is rigid (9.3.3)", "[plates]") {
  const auto panel = [](const ThinWalled& path, double thickness, double opening) {
    const Project project = parse_project(
        "path.toml",
        cantilever(section("a", path),
                   segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}, thickness, opening) +
                       held(6.0, 20),
                   tip(6.0, -100.0)));
    return path_at(project, 3.0)->sheared.back().panel.length;
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
    const auto path = path_at(project, 3.0);
    for (const ShearedWall& wall : path->sheared)
      if (wall.panel.depth.value() > 1.0) return wall.panel.length;
    return std::optional<Length>();
  };
  CHECK(panel(0.0));
  CHECK(panel(100.0 - 2.0 * 40.0));
  CHECK_FALSE(panel(100.0 - 2.0 * 38.5));
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

}  // namespace held_paths_test
