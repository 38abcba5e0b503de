// What stands against believing elastic stresses, on the rig with other plates. All limits by the
// formulas of EN 1993-1-1, table 5.2, and EN 1993-1-5.

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/model_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/beam_checks.hpp"
#include "support/cantilever.hpp"
#include "support/changed_rig.hpp"
#include "support/held_bar.hpp"
#include "support/luffing_boom.hpp"
#include "support/refusals.hpp"
#include "support/rig.hpp"

namespace gates_test {

using namespace boxbeam;
using test::contains;

namespace {

const std::string box_of_600 = "height = \"600 mm\"\nflange = \"50 mm\"\nweb = \"50 mm\"";
const std::string box_of_1000 = "height = \"1000 mm\"\nflange = \"50 mm\"\nweb = \"50 mm\"";

std::string with_web(std::string box, const std::string& web) {
  const std::string usual = "web = \"50 mm\"";
  return box.replace(box.find(usual), usual.size(), "web = \"" + web + "\"");
}

/// The rig with other webs at its ends and in the middle, whose fatigue is asked nothing of.
Project with_webs(const std::string& at_ends, const std::string& in_middle) {
  Project project = test::changed_rig({{box_of_600, with_web(box_of_600, at_ends)},
                                       {box_of_1000, with_web(box_of_1000, in_middle)}});
  project.fatigue.required = 0.01;
  return project;
}

std::vector<Gate> gates_with(const Verification& verification, const std::string& words) {
  std::vector<Gate> found;
  for (const Gate& gate : verification.gates) {
    if (gate.finding.find(words) != std::string::npos) found.push_back(gate);
  }
  return found;
}

const double eps_355 = std::sqrt(235.0 / 355.0);

}  // namespace

TEST_CASE("the rig as it is: shear lag counts, nothing blocks") {
  Project tolerant = test::rig();
  tolerant.fatigue.required = 1.0;
  const Verification verification = verify(tolerant);
  for (const Gate& gate : verification.gates) {
    INFO(gate.finding);
    CHECK_FALSE(gate.blocks);
    CHECK(contains(gate.finding, "shear lag"));
  }
  CHECK(verification.verdict == Verdict::pass);
}

TEST_CASE("shear lag of the rig: kappa = 0.175/6.2, beta_2 by EN 1993-1-5 table 3.1") {
  const Project& project = test::rig();
  const std::deque<SituationRun> runs = run_situations(project);
  const std::vector<BendingZone> zones = bending_zones_of(project, runs);
  // Pinned ends, the hub's force in between: zero moment at both ends only.
  REQUIRE(zones.size() == 1);
  CHECK(zones[0].from.value() == Approx(0.0).margin(1e-4));
  CHECK(zones[0].to.value() == Approx(6.2).epsilon(1e-4));
  CHECK(zones[0].region == BendingRegion::hogging);
  const Length hub = si<Length>(3.2);
  const auto lag = shear_lag_at(zones, section_at(project.beam, {hub}), {hub});
  REQUIRE(lag);
  const double kappa = 0.175 / 6.2;
  const double beta = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  CHECK(kappa == Approx(0.02823).margin(5e-6));
  CHECK(beta == Approx(0.9211).margin(5e-5));
  CHECK(lag->b_0.value() == Approx(0.175).epsilon(1e-12));
  CHECK(lag->kappa == Approx(kappa).epsilon(1e-4));
  CHECK(lag->beta == Approx(beta).epsilon(1e-4));
  // Of the clear 300 mm between the webs: 350 mm between their middles less (1 - beta) of it.
  CHECK(lag->flange_part == Approx((0.3 - (1.0 - beta) * 0.35) / 0.3).epsilon(1e-4));
  const std::vector<Gate> gates = gates_with(verify(project), "shear lag");
  REQUIRE_FALSE(gates.empty());
  for (const Gate& gate : gates) CHECK_FALSE(gate.blocks);
  CHECK(contains(gates.front().finding, "kappa = 0.0282"));
  CHECK(contains(gates.front().finding, "beta = 0.921"));
}

TEST_CASE("shear lag of a simply supported beam: beta_1 under its weight, beta_2 under a force") {
  // A box 200 mm wide with webs of 10 mm on 2 m: b_0 = 95 mm, kappa = 0.095/2 = 0.0475.
  const std::string box =
      "kind = \"box\"\nwidth = \"200 mm\"\nheight = \"200 mm\"\nflange = \"10 mm\"\n"
      "web = \"10 mm\"\n";
  const double kappa = 0.095 / 2.0;
  const Length middle = si<Length>(1.0);
  const auto lag_of = [&](const std::string& force, BendingRegion region) {
    const Project project = test::held_bar(true, box, force);
    const std::deque<SituationRun> runs = run_situations(project);
    const std::vector<BendingZone> zones = bending_zones_of(project, runs);
    REQUIRE(zones.size() == 1);
    CHECK(zones[0].region == region);
    CHECK(zones[0].effective_length.value() == Approx(2.0).epsilon(1e-6));
    const auto lag = shear_lag_at(zones, section_at(project.beam, {middle}), {middle});
    REQUIRE(lag);
    CHECK(lag->kappa == Approx(kappa).epsilon(1e-6));
    return lag->beta;
  };
  CHECK(lag_of("", BendingRegion::sagging) ==
        Approx(1.0 / (1.0 + 6.4 * kappa * kappa)).epsilon(1e-6));
  const double beta_2 = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  CHECK(lag_of("[forces.load]\nkind = \"force\"\npoint = \"bar.M\"\ndirection = \"-90 deg\"\n"
               "size = \"50 kN\"\n",
               BendingRegion::hogging) == Approx(beta_2).epsilon(1e-6));
}

TEST_CASE("shear lag of several situations: each by its own zero moments, the least part counts") {
  // A beam of 5 m on supports at 0 and 4 m, b_0 = 115 mm. A: 1000 kN at the tip, zero moments at 0
  // and 5 m, M = 500 kN m at 2 m. B: 300 kN at 2 m, zero moments at 0 and 4 m, M = 300 kN m there.
  const auto lag_at = [](double s, double size_of_B, double factor_of_B, bool with_A = true) {
    Project project = parse_project(
        "case.toml",
        fmt::format(
            "[case]\nname = \"two\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 "
            "m/s^2\"]\n[sections.box]\nkind = \"box\"\nwidth = \"240 mm\"\nheight = \"200 mm\"\n"
            "flange = \"10 mm\"\nweb = \"10 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
            "[[beam.segments]]\nlength = \"5 m\"\nsection = \"box\"\n"
            "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
            "[supports.right]\nkind = \"roller\"\nat = \"4 m\"\n"
            "[loads.tip]\nkind = \"force\"\nat = \"5 m\"\nforce = [\"0 kN\", \"-1000 kN\"]\n"
            "[loads.middle]\nkind = \"force\"\nat = \"2 m\"\nforce = [\"0 kN\", \"{} kN\"]\n"
            "[[situations]]\nname = \"A\"\nloads = {{ tip = {} }}\n"
            "[[situations]]\nname = \"B\"\nloads = {{ middle = 1.0 }}\n"
            "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n",
            -size_of_B, with_A ? "1.0" : "0.0"));
    project.situations.back().load_factor = factor_of_B;
    const std::deque<SituationRun> runs = run_situations(project);
    const std::vector<BendingZone> zones = bending_zones_of(project, runs);
    const Length at = si<Length>(s);
    const auto lag = shear_lag_at(zones, section_at(project.beam, {at}), {at});
    REQUIRE(lag);
    CHECK(ultimate_share_at(zones, section_at(project.beam, {at}), {at}, BendingAxis::y) ==
          Approx(std::pow(lag->beta, lag->kappa)).epsilon(1e-12));
    return *lag;
  };
  const double of_A = 0.115 / 5.0, of_B = 0.115 / 4.0;
  CHECK(lag_at(2.0, 300.0, 1.0).kappa == Approx(of_B).epsilon(1e-6));
  // As B by itself.
  CHECK(lag_at(2.0, 300.0, 1.0).beta == Approx(lag_at(2.0, 300.0, 1.0, false).beta).epsilon(1e-9));
  // Where B does not bend the beam, and where it bends it by less than a tenth of A's moment.
  CHECK(lag_at(4.5, 300.0, 1.0).kappa == Approx(of_A).epsilon(1e-6));
  CHECK(lag_at(2.0, 20.0, 1.0).kappa == Approx(of_A).epsilon(1e-6));
  // With its load factor: 3 times 20 kN m beside 500.
  CHECK(lag_at(2.0, 20.0, 3.0).kappa == Approx(of_B).epsilon(1e-6));
}

TEST_CASE("a case that leaves shear lag out has no bending zones") {
  Project project = test::rig();
  project.strength.shear_lag = false;
  const std::deque<SituationRun> runs = run_situations(project);
  CHECK(bending_zones_of(project, runs).empty());
  CHECK(gates_with(verify(project), "shear lag").empty());
}

TEST_CASE("a web evenly compressed while it carries little has no class of its own") {
  // When the rig's beam passes its middle position the bending of S4, above the hub, vanishes and
  // its weight and the upper rod's press: psi = 1. c/t = 500/14 = 35.7 is above 42 eps = 34.2, but
  // a hundredth of the yield strength raises eps tenfold (5.5.2(9)).
  const Verification verification = verify(with_webs("14 mm", "50 mm"));
  CHECK(gates_with(verification, "class 4").empty());
  CHECK(verification.verdict == Verdict::pass);
}

TEST_CASE("a web in even compression: 42 eps, with eps by its stress") {
  // c/t = 184/4 = 46 is above 42 eps = 34.2 where its compression is above (34.2/46)^2 = 0.552 of
  // the yield strength. A hole keeps it from being judged by its effective widths.
  const std::string slender =
      "kind = \"box\"\nwidth = \"160 mm\"\nheight = \"200 mm\"\nflange = \"8 mm\"\n"
      "web = \"4 mm\"\n";
  const double area = 2.0 * 0.16 * 0.008 + 2.0 * 0.184 * 0.004;
  const auto gates_under = [&](double part, const ModelChoice& model, bool hole) {
    // The load's largest size is 1.5.
    const double force = part * 355e6 * area / 1.5;
    Project project = test::cantilever(slender, {{{-force, 0.0, 0.0}}});
    if (hole) {
      BeamHole at;
      at.s = si<Length>(0.5);
      at.hole = {"h", si<Length>(0.02), HoleWalls::webs, Length{}};
      at.concentration = HoleCase::in_plane_bending;
      project.holes.push_back(at);
    }
    std::vector<Gate> classes;
    for (const Gate& gate : test::beam_checks_of(project, model).gates) {
      if (contains(gate.finding, "class 4")) classes.push_back(gate);
    }
    return classes;
  };
  const double limit = 42.0 * eps_355;
  const double edge = limit * limit / (46.0 * 46.0);
  CHECK(edge == Approx(0.552).margin(5e-4));
  CHECK(gates_under(0.99 * edge, {}, true).empty());
  CHECK(gates_under(1.01 * edge, {}, false).empty());
  const std::vector<Gate> gates = gates_under(1.01 * edge, {}, true);
  REQUIRE(gates.size() == 2);
  const double lambda = 46.0 / (28.4 * eps_355 * 2.0);  // k_sigma = 4
  CHECK((lambda - 0.22) / (lambda * lambda) == Approx(0.783).margin(5e-4));
  for (const Gate& gate : gates) {
    CHECK(gate.blocks);
    CHECK(contains(gate.finding, "c/t = 46 is above 45.8"));
    CHECK(contains(gate.finding, "psi = 1.00"));
    CHECK(contains(gate.finding, "rho = 0.783"));
    CHECK(contains(gate.finding, "hole \"h\" is wider than 0.05 of its plate"));
  }
  // 5.5.2(10): where the member may buckle, table 5.2 as it is; with an effective section it is
  // judged as a member by that.
  ModelChoice slender_member;
  slender_member.second_order.in_plane.part = 0.05;
  CHECK(gates_under(0.1, slender_member, false).empty());
  CHECK(gates_under(0.1, {}, true).empty());
  CHECK(gates_under(0.1, slender_member, true).size() == 2);
}

TEST_CASE("a web too slender in bending is of class 4 under its actual stress") {
  // The limit of class 3 by the formulas, psi from the cut forces at every instant and the gross
  // section by hand.
  const Project project = with_webs("30 mm", "10 mm");
  const std::deque<SituationRun> runs = run_situations(project);
  const Station hub{si<Length>(3.2), Side::before};
  const double area = 0.4 - 0.38 * 0.9;
  const double inertia = (0.4 - 0.38 * 0.729) / 12.0;
  const std::vector<SituationHistory> histories = histories_at(runs, hub);
  const double required = project.strength.required;
  double lowest = 1e300;
  for (const CutForces& cut : histories.front().history.samples()) {
    const double middle = -cut.N.value() / area;
    const double bending = std::abs(cut.M_y.value() * 0.45 / inertia);
    const double most = middle + bending;
    if (most <= 0.5e6) continue;  // far above the 1 % that do not count
    const double psi = (middle - bending) / most;
    const double limit = psi > -1.0 ? 42.0 * eps_355 / (0.67 + 0.33 * psi)
                                    : 62.0 * eps_355 * (1.0 - psi) * std::sqrt(-psi);
    lowest = std::min(lowest, limit / std::sqrt(std::min(1.0, required * most / 355e6)));
  }
  const std::vector<Gate> gates = test::beam_checks_at(project, {hub}).gates;
  bool found = false;
  for (const Gate& gate : gates) found = found || contains(gate.finding, "class 4");
  CHECK(found == (90.0 > lowest));
}

TEST_CASE("webs above 72 eps/eta beside holes or in steep tapers: not applicable") {
  // S355 up to 16 mm: 72 sqrt(235/355)/1.2 = 48.8. 900/15 = 60, 900/20 = 45 (of 345 MPa).
  CHECK(72.0 * eps_355 / 1.2 == Approx(48.8).margin(0.05));
  const Verification slender = verify(with_webs("50 mm", "15 mm"));
  const std::vector<Gate> gates = gates_with(slender, "may buckle in shear");
  REQUIRE_FALSE(gates.empty());
  for (const Gate& gate : gates) {
    CHECK(gate.blocks);
    CHECK(gate.plate == "web");
    CHECK((gate.segment == "S2" || gate.segment == "S3"));
  }
  CHECK(contains(gates.front().finding, "h_w/t_w = 60 is above 72 eps/eta = 48.8"));
  CHECK(slender.verdict == Verdict::not_applicable);
  const Verification stout = verify(with_webs("50 mm", "20 mm"));
  CHECK(gates_with(stout, "may buckle in shear").empty());
}

TEST_CASE("a flange of class 4 in a steep taper blocks: c/t above 42 eps") {
  Project project = test::changed_rig(
      {{box_of_600, "height = \"600 mm\"\nflange = \"8 mm\"\nweb = \"50 mm\""},
       {box_of_1000, "height = \"1000 mm\"\nflange = \"8 mm\"\nweb = \"50 mm\""}});
  project.fatigue.required = 0.01;
  const Verification verification = verify(project);
  // (400 - 100)/8 = 37.5 > 34.2
  const std::vector<Gate> gates = gates_with(verification, "c/t = 37.5 is above 34.2");
  REQUIRE_FALSE(gates.empty());
  CHECK(gates.front().plate.find("flange") != std::string::npos);
  CHECK(verification.verdict == Verdict::not_applicable);
}

TEST_CASE("stress above the yield strength blocks, whatever is required") {
  Project project = test::rig();
  project.fatigue.required = 0.01;
  project.strength.required = 0.01;
  // The rig's yield factor is about 20: thirty times the loads.
  project.situations.front().load_factor = 30.0;
  const Verification verification = verify(project);
  REQUIRE(verification.governing(Criterion::yield)->check.safety_factor < 1.0);
  const std::vector<Gate> gates = gates_with(verification, "above the yield strength");
  REQUIRE(gates.size() == 1);
  CHECK(gates.front().blocks);
  CHECK(contains(gates.front().finding,
                 to_text(verification.governing(Criterion::yield)->check.station)));
  CHECK(verification.verdict == Verdict::not_applicable);
}

TEST_CASE("a check that fails comes before a gate: the verdict is fail") {
  Project project = with_webs("50 mm", "15 mm");
  project.strength.required = 1e6;
  CHECK(verify(project).verdict == Verdict::fail);
}

TEST_CASE("pins of rigid bodies prove nothing beside a beam that vibrates", "[model_choice]") {
  ModelChoice rigid;
  ModelChoice modal;
  modal.chosen = {ModelLevel::modal, 1, 8, {}, false};
  Project project = test::rig();
  CHECK(model_gates_of(project, modal).empty());
  project.pins.emplace_back();
  CHECK(model_gates_of(project, rigid).empty());
  const std::vector<Gate> gates = model_gates_of(project, modal);
  REQUIRE(gates.size() == 1);
  CHECK(gates.front().blocks);
  CHECK(contains(gates.front().finding, "pins and rods"));
}

TEST_CASE("in space bending moves forces of pins where a spring takes over", "[model_choice]") {
  ModelChoice bent;
  bent.chosen = {ModelLevel::quasi_static, 0, 16, {}, false};
  Project project = parse_project("boom.toml", test::luffing_in_space(190.0, 120.0));
  project.pins.emplace_back();
  CHECK(model_gates_of(project, bent).empty());
  std::get<spatial::Mechanism>(project.mechanism).springs.emplace_back();
  const std::vector<Gate> gates = model_gates_of(project, bent);
  REQUIRE(gates.size() == 1);
  CHECK(gates.front().blocks);
  CHECK(contains(gates.front().finding, "the beam's bending is missing"));
}

TEST_CASE("a model beyond the tolerance blocks, demanded or for want of a better one",
          "[model_choice]") {
  ModelChoice choice;
  choice.tolerance = 0.01;
  Project project = test::rig();
  choice.weighed = {{{}, "", 0.65, {}}, {{}, "", 0.004, {}}};
  choice.chosen.level = ModelLevel::modal;
  CHECK(model_gates_of(project, choice).empty());
  choice.weighed.pop_back();
  choice.chosen.level = ModelLevel::rigid;
  const std::vector<Gate> by_want = model_gates_of(project, choice);
  REQUIRE(by_want.size() == 1);
  CHECK(by_want.front().blocks);
  CHECK(contains(by_want.front().finding, "by 65 %, tolerance 1 %"));
  project.model.demand = ModelDemand::rigid;
  const std::vector<Gate> gates = model_gates_of(project, choice);
  REQUIRE(gates.size() == 1);
  CHECK(gates.front().blocks);
  CHECK(contains(gates.front().finding, "an estimated 65 %, tolerance 1 %"));
  choice.weighed.front().found = 0.009;
  CHECK(model_gates_of(project, choice).empty());
}

TEST_CASE("a beam whose vibration is not in balance as far bent as it is does not pass",
          "[model_choice]") {
  ModelChoice choice;
  choice.tolerance = 0.01;
  choice.weighed = {{{}, "", 0.004, 0.02}};
  choice.bends_rigid_motion = true;
  const Project project = test::rig();
  for (const ModelLevel level : {ModelLevel::modal, ModelLevel::quasi_static}) {
    choice.chosen.level = level;
    const std::vector<Gate> gates = model_gates_of(project, choice);
    REQUIRE(gates.size() == 1);
    CHECK(gates.front().blocks);
    CHECK(contains(gates.front().finding, "2 % of the governing stress is not in balance"));
    CHECK(contains(gates.front().finding, "vibration is not proven"));
  }
  choice.weighed.front().found = 0.009;
  CHECK(model_gates_of(project, choice).empty());
}

TEST_CASE("a polygon whose walls may buckle blocks, as the box that it is") {
  // A hollow square 390 mm with walls t: c/t = 390/1.5 = 260, 39 of 10 mm, above 42 eps = 34.2; 33
  // of 12 mm; massive 1.
  const auto stops = [](double wall) {
    const auto square = [](double half) {
      return fmt::format(
          "[[\"-{0} mm\", \"-{0} mm\"], [\"{0} mm\", \"-{0} mm\"], [\"{0} mm\", "
          "\"{0} mm\"], [\"-{0} mm\", \"{0} mm\"]]",
          half);
    };
    const std::string hollow = wall < 195.0 ? "holes = [" + square(195.0 - wall) + "]\n" : "";
    const Verification of = verify(parse_project(
        "polygon.toml",
        "[case]\nname = \"polygon\"\nkind = \"static\"\n[frame]\n"
        "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n[sections.a]\nkind = \"polygon\"\nouter = " +
            square(195.0) + "\n" + hollow +
            "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"8 m\"\nsection = "
            "\"a\"\n"
            "[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.f]\nkind = \"force\"\nat = "
            "\"8 m\"\n"
            "force = [\"0 kN\", \"-3 kN\"]\n[material]\nsteel = \"S355\"\n[strength]\nrequired = "
            "1.0\n"));
    return of.verdict == Verdict::not_applicable && !gates_with(of, "class 4").empty();
  };
  CHECK(stops(1.5));
  CHECK(stops(10.0));
  CHECK_FALSE(stops(12.0));
  CHECK_FALSE(stops(195.0));
}

}  // namespace gates_test
