// Bending under an axial force, in mechanisms: against the closed form of the beam-column, and
// where a beam buckles.

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/loaded_posture.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"
#include "support/slider_crank.hpp"

namespace second_order_test {

using namespace boxbeam;
using test::contains;

namespace {

constexpr double pi = std::numbers::pi;

// Box 60 x 60 x 4, 4 m long.
constexpr double E = 2.1e11, L = 4.0;
constexpr double A = 0.06 * 0.06 - 0.052 * 0.052;
const double I = (std::pow(0.06, 4) - std::pow(0.052, 4)) / 12.0;
const double W = I / 0.03;
const double critical = pi * pi * E * I / (L * L);  // 61 kN
const double weight = 7850.0 * A * 9.81;            // per length

/// Largest stress of a pinned beam-column under its weight, rigid in shear: N/A + M/W with
///
///     M = q/k^2 (sec(kL/2) - 1), k^2 = N/EI   (compression)
///
/// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 1.3.
double beam_column_stress(double compression) {
  const double k = std::sqrt(std::abs(compression) / (E * I));
  const double shape =
      compression > 0.0 ? 1.0 / std::cos(0.5 * k * L) - 1.0 : 1.0 - 1.0 / std::cosh(0.5 * k * L);
  return std::abs(compression) / A + weight / (k * k) * shape / W;
}

/// Of the rod while it lies level, in the middle.
double stress_of(const Project& project, const ElasticModel& model) {
  const std::deque<SituationRun> runs = run_situations(project, model);
  const CutForces cut = runs.front().loads.diagram(0).at({si<Length>(0.5 * L)});
  return std::abs(cut.N.value()) / A + std::abs(cut.M_y.value()) / W;
}

/// Of the beam as a member, 0 where it does not count.
double member_use(const Verification& verification) {
  const CheckResult* const of = governing_of(verification.checks, Criterion::member);
  return of == nullptr ? 0.0 : of->check.utilisation();
}

bool blocked(const Verification& verification, const std::string& words) {
  for (const Gate& gate : verification.gates) {
    if (gate.blocks && contains(gate.finding, words)) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a connecting rod in compression has the stress of the beam-column", "[second_order]") {
  for (const double part : {0.08, 0.33, 0.66, 0.82}) {
    const Project project = test::slow_slider_crank(part * critical);
    const ModelChoice choice = choose_model(project);
    INFO("N/N_cr = " << part << ": " << choice.reason);
    CHECK(choice.chosen.level == ModelLevel::quasi_static);
    CHECK(choice.second_order.in_plane.part == Approx(part).epsilon(2e-3));
    CHECK(stress_of(project, choice.chosen) ==
          Approx(beam_column_stress(part * critical)).epsilon(1e-3));
  }
}

TEST_CASE("tension takes bending from a connecting rod", "[second_order]") {
  for (const double part : {0.3, 3.0}) {
    const Project project = test::slow_slider_crank(-part * critical);
    const ModelChoice choice = choose_model(project);
    INFO(choice.reason);
    CHECK(choice.chosen.level == ModelLevel::quasi_static);
    CHECK(stress_of(project, choice.chosen) ==
          Approx(beam_column_stress(-part * critical)).epsilon(1e-3));
  }
}

// Its range is that of its weight as it tilts, a few thousandths of the whole: 10 % will do here.
TEST_CASE("a rod with little compression stays rigid and says how little it is", "[second_order]") {
  Project project = test::slow_slider_crank(0.001 * critical);
  project.model.tolerance = 0.1;
  const ModelChoice choice = choose_model(project);
  INFO(choice.reason);
  CHECK(choice.chosen.level == ModelLevel::rigid);
  CHECK(choice.second_order.in_plane.part == Approx(0.001).epsilon(3e-3));
  CHECK(contains(choice.reason, "N/N_cr = 0.001"));
  CHECK(*choice.second_order.change <= choice.tolerance);
  // 1/(1 - 0.001) of the bending, which is nearly all of the stress, and more of its small range.
  CHECK(*choice.second_order.change >= 0.00095);
}

TEST_CASE("a rod above its critical load never passes, whatever the model", "[second_order]") {
  Project project = test::slow_slider_crank(3.28 * critical);
  for (const ModelDemand demand : {ModelDemand::automatic, ModelDemand::rigid}) {
    project.model.demand = demand;
    const Verification verification = verify(project);
    INFO(verification.model.reason);
    CHECK(verification.verdict != Verdict::pass);
    CHECK(blocked(verification, "of the elastic critical one"));
  }
}

TEST_CASE("rigid bodies that are demanded where second order counts do not pass",
          "[second_order]") {
  Project project = test::slow_slider_crank(0.33 * critical);
  project.model.demand = ModelDemand::rigid;
  const Verification verification = verify(project);
  CHECK(verification.model.chosen.level == ModelLevel::rigid);
  CHECK(verification.verdict == Verdict::not_applicable);
  CHECK(blocked(verification, "the model that was demanded misses"));
}

// The same rod on edge: 30 mm wide, so that it buckles across the plane of motion first.
TEST_CASE("a rod that buckles across the plane of motion does not pass", "[second_order]") {
  const Project project = test::slow_slider_crank(0.5 * critical, "30 mm");
  const Verification verification = verify(project);
  CHECK(verification.model.second_order.in_plane.part < 1.0);
  CHECK(verification.verdict != Verdict::pass);
  CHECK((blocked(verification, "across it") || member_use(verification) > 1.0));
}

TEST_CASE("a load factor for strength counts in buckling as a member", "[second_order]") {
  // lambda = 2.28, chi = 0.16 by curve c: 0.33 N_cr is 0.4 of the resistance, three times more than
  // all of it.
  Project project = test::slow_slider_crank(0.33 * critical);
  const double once = member_use(verify(project));
  CHECK(once < 1.0);
  project.situations.front().load_factor = 3.0;
  const Verification times = verify(project);
  CHECK(times.model.second_order.in_plane.part == Approx(0.99).epsilon(3e-3));
  // It is the loads times it, the weight among them.
  Project loaded = test::slow_slider_crank(3.0 * 0.33 * critical);
  std::get<planar::Mechanism>(loaded.mechanism).gravity *= 3.0;
  // As closely as N_cr is found, and better where the halvings are the same.
  CHECK(member_use(times) == Approx(member_use(verify(loaded))).epsilon(1e-5));
  CHECK(member_use(times) >= 3.0 * once);
}

TEST_CASE("a load factor counts in whichever situation of the same loads it stands",
          "[second_order]") {
  Project project = test::slow_slider_crank(0.33 * critical);
  Situation& first = project.situations.front();
  first.name = "running";
  Situation storm = first;
  storm.name = "storm";
  storm.load_factor = 3.0;
  for (const bool before : {false, true}) {
    Project both = project;
    both.situations.insert(before ? both.situations.begin() : both.situations.end(), storm);
    CHECK(member_use(verify(both)) > 1.0);
  }
}

TEST_CASE("a beam is not bent at more instants than can be looked at", "[second_order]") {
  // A thousand turns in the second that is looked at, sixteen instants each.
  const std::string text =
      "[case]\nname = \"fast\"\nkind = \"planar\"\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n[model]\nloads = \"measured\"\n"
      "damping = \"1 ms\"\n[motion]\nduration = \"1 s\"\n"
      "[bodies.lever]\npoints = { C = [\"0 m\", \"0 m\"], D = [\"0.3 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"] }\n"
      "[joints.C]\nkind = \"pin\"\nconnect = [\"lever.C\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "[drivers.motor]\npoint = \"lever.C\"\ncoordinate = \"angle\"\nkind = \"constant rate\"\n"
      "start = \"0 deg\"\nrate = \"60000 rpm\"\n"
      "[sections.box]\nkind = \"box\"\nwidth = \"80 mm\"\nheight = \"100 mm\"\n"
      "flange = \"6 mm\"\nweb = \"6 mm\"\n"
      "[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n"
      "[[beam.segments]]\nlength = \"0.3 m\"\nsection = \"box\"\n"
      "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
  Project project = parse_project("fast.toml", text);
  project.model.demand = ModelDemand::flexible;
  try {
    static_cast<void>(verify(project));
    FAIL("no error");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().what.find("16000 instants") != std::string::npos);
  }
}

namespace {

/// Whether a column between pins, of E I as a polynomial along it, stands under a force.
bool column_stands(const std::array<double, 4>& EI, double force) {
  flexible::Mechanism held;
  flexible::Link& link = held.links.emplace_back();
  link.name = "column";
  link.length = L;
  link.parts = 128;
  flexible::LinkStretch& stretch = link.stretches.emplace_back();
  stretch.length = L;
  std::copy(EI.begin(), EI.end(), stretch.EI.c.begin());
  stretch.EA.c = {1e6 * E * A};
  stretch.GA.c = {1e6 * E * A};
  const double free = 0.0, stiff = std::numeric_limits<double>::infinity();
  for (const double s : {0.0, L}) {
    flexible::Joint& joint = held.joints.emplace_back();
    joint.name = "pin";
    joint.a = {0, {s, 0.0}};
    joint.b = {flexible::ground, {s, 0.0}};
    joint.stiffness = {s == 0.0 ? stiff : free, stiff, free};
  }
  const Project project = test::slow_slider_crank(0.0);
  BeamLoads loads;
  loads.lines = unloaded_lines(project.beam);
  loads.points = {{si<Length>(0.0), {1e3, 0.0, 0.0}}, {si<Length>(L), {-1e3, 0.0, 0.0}}};
  return stands(loaded_beam(held, project.beam, loads, force / 1e3));
}

/// The smallest P of w'' + P w/(E I) = 0, w = 0 at both ends, by central differences on n steps.
double by_differences(const std::array<double, 4>& EI, int n) {
  const double h = L / n;
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(n - 1, n - 1);
  Eigen::VectorXd soft(n - 1);
  for (int i = 0; i < n - 1; ++i) {
    const double x = (i + 1) * h;
    soft[i] = 1.0 / (EI[0] + x * (EI[1] + x * (EI[2] + x * EI[3])));
    second(i, i) = 2.0 / (h * h);
    if (i > 0) second(i, i - 1) = second(i - 1, i) = -1.0 / (h * h);
  }
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(
             second, Eigen::MatrixXd(soft.asDiagonal()), Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

}  // namespace

// E I ~ (1 + (r - 1) x/L)^2 between pins: N_cr L^2/(E I_min) = (r - 1)^2 ((pi/ln r)^2 + 1/4).
// Source: Timoshenko, Gere, Theory of Elastic Stability (1961), section 2.14, n = 2; 1.5270, 2.1067
// and 3.4155 times pi^2 for r = 1.5, 2 and 3.
TEST_CASE("a column whose depth tapers buckles at the closed form", "[second_order]") {
  for (const auto& [r, published] :
       {std::pair(1.5, 1.5270), std::pair(2.0, 2.1067), std::pair(3.0, 3.4155)}) {
    const double d = (r - 1.0) / L;
    const double closed =
        std::pow(r - 1.0, 2) * (std::pow(pi / std::log(r), 2) + 0.25) * E * I / (L * L);
    CHECK(closed * L * L / (pi * pi * E * I) == Approx(published).margin(5e-5));
    const std::array<double, 4> EI{E * I, 2.0 * d * E * I, d * d * E * I, 0.0};
    INFO("r = " << r);
    CHECK(column_stands(EI, (1.0 - 1e-4) * closed));
    CHECK_FALSE(column_stands(EI, (1.0 + 1e-4) * closed));
  }
}

// Any taper against an eigenproblem of finite differences, by Richardson's extrapolation.
TEST_CASE("columns of any taper buckle where finite differences say", "[second_order]") {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> of(0.3, 4.0);
  for (int k = 0; k < 15; ++k) {
    // A cubic through four stiffnesses, so that it is nowhere near nothing.
    Eigen::Matrix4d powers;
    Eigen::Vector4d values;
    for (int i = 0; i < 4; ++i) {
      const double x = L * i / 3.0;
      powers.row(i) << 1.0, x, x * x, x * x * x;
      values[i] = E * I * (i < 2 ? 1.0 : 0.5) * (1.0 + 0.5 * of(random));
    }
    const Eigen::Vector4d c = powers.partialPivLu().solve(values);
    const std::array<double, 4> EI{c[0], c[1], c[2], c[3]};
    const double coarse = by_differences(EI, 60), fine = by_differences(EI, 120);
    const double critical = fine + (fine - coarse) / 3.0;
    INFO("taper " << k);
    CHECK(column_stands(EI, (1.0 - 1e-4) * critical));
    CHECK_FALSE(column_stands(EI, (1.0 + 1e-4) * critical));
  }
}

}  // namespace second_order_test
