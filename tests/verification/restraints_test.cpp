// What the case says of how its beam is held against buckling: closed forms of columns and of
// beams that turn over, a frame that has the same supports, and what is refused.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "boxbeam/report/remarks.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"
#include "support/slider_crank.hpp"

namespace restraints_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double E = 210e9, G = 81e9, L = 6.0;

/// A box 100 x 200 x 5, 6 m long, clamped at its start by its frame, with a force or a couple at
/// its end.
Project column(const std::string& load, const std::string& restraints = "",
               const std::string& supports = "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n") {
  return parse_project("column.toml",
                       "[case]\nname = \"column\"\nkind = \"static\"\n"
                       "[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
                       "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
                       "flange = \"5 mm\"\nweb = \"5 mm\"\n"
                       "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"6 m\"\n"
                       "section = \"box\"\n" +
                           restraints + supports + "[loads.tip]\nkind = \"force\"\nat = \"6 m\"\n" +
                           load + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n");
}

const std::string pushed = "force = [\"-50 kN\", \"0 N\"]\n";
const std::string turned = "moment = \"20 kN m\"\n";

/// One of [[beam.restraints]].
std::string held(double s, const std::string& ways, bool clamped = false) {
  return fmt::format("[[beam.restraints]]\nstation = \"{} m\"\nholds = [{}]\n{}", s, ways,
                     clamped ? "clamped = true\n" : "");
}
std::string across(double s, bool clamped = false) { return held(s, "\"along y\"", clamped); }

SectionProperties box() { return properties_of(column(pushed).beam.segments.front().from); }

SecondOrderEstimate estimate_of(const Project& project) {
  return estimate_second_order(project, run_situations(project, {}));
}

/// N_cr across over that of the column pinned at both ends, pi^2 E I_z/L^2.
double times_euler(const std::string& restraints) {
  const double euler = pi * pi * E * box().I_z.value() / (L * L);
  return 50e3 / estimate_of(column(pushed, restraints)).across->part / euler;
}

double turning_over(const std::string& restraints) {
  return estimate_of(column(turned, restraints)).lateral->part;
}

bool has_remark(const Project& project, const Verification& of, const std::string& text) {
  for (const Remark& remark : remarks_of(project, of))
    if (remark.whole().find(text) != std::string::npos) return true;
  return false;
}

/// What is said of a case that is refused.
std::string refused(const std::string& restraints) {
  return test::refusal_of([&] { return column(pushed, restraints); });
}

}  // namespace

// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), sections 2.2, 2.3 and 2.5: 20.19 of
// the column clamped and pinned, pi^2/4, pi^2, 4 pi^2.
TEST_CASE("columns buckle as their restraints hold them", "[restraints]") {
  CHECK(times_euler("") == Approx(0.25).epsilon(1e-3));
  CHECK(times_euler(across(0.0, true)) == Approx(0.25).epsilon(1e-3));
  CHECK(times_euler(across(0.0) + across(6.0)) == Approx(1.0).epsilon(1e-3));
  CHECK(times_euler(across(0.0, true) + across(6.0)) == Approx(2.0457).epsilon(1e-3));
  CHECK(times_euler(across(0.0, true) + across(6.0, true)) == Approx(4.0).epsilon(2e-3));
  CHECK(times_euler(across(0.0) + across(3.0) + across(6.0)) == Approx(4.0).epsilon(1e-3));
  CHECK(times_euler(across(6.0) + across(4.0) + across(2.0) + across(0.0)) ==
        Approx(9.0).epsilon(1e-3));
}

TEST_CASE("a restraint more never lets a column buckle earlier", "[restraints]") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> place(0.05, 0.95);
  for (int i = 0; i < 8; ++i) {
    std::string restraints = across(0.0) + across(6.0);
    double before = times_euler(restraints);
    for (int k = 0; k < 3; ++k) {
      restraints += across(L * place(engine), k == 1);
      CAPTURE(restraints);
      const double now = times_euler(restraints);
      CHECK(now >= before * (1.0 - 1e-3));
      before = now;
    }
  }
}

TEST_CASE("ways of holding are told apart", "[restraints]") {
  const SecondOrderEstimate free = estimate_of(column(pushed));
  const SecondOrderEstimate sideways = estimate_of(column(pushed, across(0.0) + across(6.0)));
  CHECK(sideways.in_plane.part == Approx(free.in_plane.part).epsilon(1e-9));
  CHECK(sideways.across->part == Approx(free.across->part / 4.0).epsilon(2e-3));
  CHECK(sideways.across->held == "pinned at s = 0 m and 6 m, as the case says");
  CHECK_FALSE(sideways.across->assumed);
  CHECK(free.across->held == "clamped at s = 0 m and free elsewhere");
  CHECK(free.across->assumed);
  const SecondOrderEstimate upright = estimate_of(
      column(pushed, held(0.0, "\"along z\", \"turning over\"") + held(6.0, "\"along z\"")));
  CHECK(upright.across->part == Approx(free.across->part).epsilon(1e-9));
  // Shear of the webs takes N_E/(G A_s) = 0.5 % of N_cr here, of the cantilever a quarter of that.
  CHECK(upright.in_plane.part == Approx(free.in_plane.part / 4.0).epsilon(6e-3));
}

// The frame buckles in its plane by matrices of its own (mechanism/frame/stability).
TEST_CASE("a column over three supports buckles as the frame of these supports", "[restraints]") {
  const std::string supports =
      "[supports.foot]\nkind = \"pinned\"\nat = \"0 m\"\n"
      "[supports.middle]\nkind = \"roller\"\nat = \"2.5 m\"\ndirection = \"90 deg\"\n"
      "[supports.head]\nkind = \"roller\"\nat = \"6 m\"\ndirection = \"90 deg\"\n";
  const std::string said =
      held(0.0, "\"along z\"") + held(2.5, "\"along z\"") + held(6.0, "\"along z\"");
  const Project project = column(pushed, said, supports);
  const std::deque<SituationRun> runs = run_situations(project, {});
  const double part = estimate_second_order(project, runs).in_plane.part;
  const auto factor = runs.front().motion->critical_factor(runs.front().loads, 1e3);
  REQUIRE(factor);
  CHECK(part * *factor == Approx(1.0).epsilon(3e-3));
  // Its two outermost supports alone are on the safe side.
  CHECK(estimate_of(column(pushed, "", supports)).in_plane.part > 2.0 * part);
}

// M_cr = pi/a sqrt(E I G I_T), a the distance of forks, I with the bow of the bent beam: 1/I =
// 1/I_z
// - 1/I_y. Source: Timoshenko, Gere (1961), section 6.3. Of one fork a = 2 L, the end being free.
TEST_CASE("forks between the ends divide the length in which a beam turns over", "[restraints]") {
  const Project project = column(turned);
  const double I = 1.0 / (1.0 / box().I_z.value() - 1.0 / box().I_y.value());
  const double I_T = torsion_properties_of(project.beam.segments.front().from).I_T->value();
  const double both = 20e3 / (pi / L * std::sqrt(E * I * G * I_T));
  const auto forks = [](std::initializer_list<double> at) {
    std::string text;
    for (const double s : at) text += held(s, "\"turning over\"");
    return text;
  };
  CHECK(turning_over("") == Approx(2.0 * both).epsilon(1e-3));
  CHECK(turning_over(forks({0.0, 6.0})) == Approx(both).epsilon(1e-3));
  CHECK(turning_over(forks({0.0, 3.0, 6.0})) == Approx(both / 2.0).epsilon(1e-3));
  CHECK(turning_over(forks({0.0, 2.0, 6.0})) == Approx(both * 2.0 / 3.0).epsilon(1e-3));
  // What holds sideways alone does not hold the beam against turning.
  CHECK(turning_over(across(0.0) + across(3.0) + across(6.0)) == Approx(turning_over("")));
}

TEST_CASE("a verdict that rests on how the beam is held says so", "[restraints]") {
  const Project assumed = column(pushed), said = column(pushed, across(0.0) + across(6.0));
  const Verification by_assumption = verify(assumed), by_case = verify(said);
  const std::string key = "[[beam.restraints]] with holds = [\"along y\"]";
  REQUIRE(by_assumption.model.second_order.across->part > no_buckling_below);
  REQUIRE(by_case.model.second_order.across->part > no_buckling_below);
  CHECK(has_remark(assumed, by_assumption, key));
  CHECK_FALSE(has_remark(said, by_case, key));
  const auto across_use = [](const Verification& of) {
    for (const CheckResult& result : of.checks)
      if (result.check.id == "member-buckling/across-the-plane-of-motion")
        return result.check.utilisation();
    return 0.0;
  };
  CHECK(across_use(by_case) > 0.0);
  CHECK(across_use(by_case) < across_use(by_assumption));
}

TEST_CASE("in the plane a mechanism that holds its beam says how", "[restraints]") {
  Project project = test::slow_slider_crank(10e3);
  const double before = estimate_of(project).in_plane.part;
  for (const double s : {0.0, 2.0, 4.0})
    project.restraints.push_back({si<Length>(s), false, true, false, false});
  const Verification of = verify(project);
  CHECK(of.model.second_order.in_plane.part == Approx(before).epsilon(1e-9));
  CHECK(has_remark(project, of, "hold along z does not count"));
}

// A crank that a force pushes along its axis: 4 L^2 in place of L^2 across.
TEST_CASE("a force that comes from nowhere holds no beam", "[restraints]") {
  const Project project = parse_project(
      "crank.toml",
      "[case]\nname = \"crank\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n"
      "[bodies.crank]\npoints = { O = [\"0 m\", \"0 m\"], A = [\"6 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"] }\n"
      "[joints.O]\nkind = \"pin\"\nconnect = [\"crank.O\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "[drivers.motor]\npoint = \"crank.O\"\ncoordinate = \"angle\"\nkind = \"constant rate\"\n"
      "start = \"0 deg\"\nrate = \"0.001 rad/s\"\n"
      "[forces.push]\nkind = \"force\"\npoint = \"crank.A\"\ndirection = \"180 deg\"\n"
      "turns_with_body = true\nsize = \"50 kN\"\n"
      "[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
      "flange = \"5 mm\"\nweb = \"5 mm\"\n"
      "[beam]\nbody = \"crank\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"6 m\"\n"
      "section = \"box\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n");
  const double euler = pi * pi * E * box().I_z.value() / (L * L);
  const auto across_of = estimate_of(project).across;
  CHECK(across_of->part == Approx(4.0 * 50e3 / euler).epsilon(2e-3));
  CHECK(across_of->held == "clamped at s = 0 m and free elsewhere");
}

TEST_CASE("restraints that do not hold are refused", "[restraints]") {
  const auto says = [](const std::string& text, const std::string& part) {
    INFO(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(says(refused(across(3.0)), "lets it turn"));
  CHECK(says(refused(across(3.0) + across(3.05)), "lets it turn"));
  CHECK(says(refused(held(0.0, "\"sideways\"")), "is not held \"sideways\""));
  CHECK(says(refused(held(0.0, "")), "holds"));
  CHECK(says(refused(held(0.0, "\"turning over\"", true)), "a clamp holds along y or z"));
  CHECK(says(refused(across(7.0) + across(0.0)), "behind the end of the beam"));
  CHECK(says(refused(across(0.0) + across(0.0) + across(6.0)), "twice"));
  CHECK(refused(held(3.0, "\"turning over\"")).empty());
  CHECK(refused(across(3.0, true)).empty());
}

}  // namespace restraints_test
