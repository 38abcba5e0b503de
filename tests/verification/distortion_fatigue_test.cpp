// Distortion of the boxes of a case in fatigue: hand values, and an exhaustive search of the ways
// in which torques may come.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"
#include "catch.hpp"
#include "support/distorted_boxes.hpp"

namespace distortion_fatigue_test {

using namespace boxbeam;
using namespace distorted_boxes;

namespace {

/// From the whole loads "tip" and "eccentric" to parts of them, and back.
std::string changing(double tip, double eccentric, double cycles = 1e5) {
  return fmt::format(
      "[[situations]]\nname = \"0\"\nloads = {{ tip = 1.0, eccentric = 1.0 }}\n"
      "[[situations]]\nname = \"1\"\nloads = {{ tip = {}, eccentric = {} }}\n"
      "[[situations]]\nname = \"change\"\nbetween = [\"0\", \"1\"]\ncycles = {}\n",
      tip, eccentric, cycles);
}

const std::string by_category_100 =
    "[fatigue]\ncategory = 100\nloading = \"spectrum\"\ngamma_Ff = 1.0\ngamma_Mf = "
    "1.0\nrequired = 1.0\n";

}  // namespace

TEST_CASE("ranges of distortion join those of their point, and bend corners across",
          "[distortion]") {
  const double torque = 400e3, tip = -2e3;
  const std::string load = twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm");
  const Verification of = verify(stout_beam(load + by_category_100 + changing(0.0, 0.0), tip));
  const CheckResult& joined = result_of(of, Criterion::distortion_fatigue);
  const DistortionEstimate estimate = estimate_of(stout_beam(load, tip));
  REQUIRE(joined.distortion->stress.spectrum.size() >= 1);
  CHECK(joined.check.station.s.value() == Approx(50.0));
  const double bending = -tip * 50.0 * 0.31 / I_stout;
  double largest = 0.0;
  for (const SpectrumRow& row : joined.distortion->stress.spectrum)
    if (row.kind == StressKind::direct) largest = std::max(largest, row.cycle.range.value());
  // The end of a web lies 10 mm inside the corner.
  CHECK(largest == Approx(bending + estimate.along.value()).epsilon(0.05));
  // 36 at 1e5 cycles: 36 (2e6/1e5)^(1/3).
  const CheckResult& across = result_of(of, Criterion::distortion_fatigue, true);
  CHECK(across.check.safety_factor ==
        Approx(36e6 * std::cbrt(20.0) / estimate.across.value()).epsilon(1e-6));
  const Verification better = verify(stout_beam(
      load + by_category_100 + "corner = { category = 71 }\n" + changing(0.0, 0.0), tip));
  CHECK(result_of(better, Criterion::distortion_fatigue, true).check.safety_factor ==
        Approx(71.0 / 36.0 * across.check.safety_factor));
  // A torque that stays does no damage.
  const Verification steady = verify(stout_beam(load + by_category_100 + changing(0.0, 1.0), tip));
  CHECK(steady.governing(Criterion::distortion_fatigue) == nullptr);
  CHECK(steady.governing(Criterion::distortion) != nullptr);
}

TEST_CASE("where distortion does nothing the plain check stands, with its own remedies",
          "[distortion]") {
  // At the wall, whose end warps freely, M_D is zero and bending largest; a plate takes the torque
  // in the middle.
  const std::string load =
      twist("eccentric", 50.0, 400e3) + diaphragm(0.0, "50 mm") + diaphragm(50.0, "50 mm");
  const auto with_cycles = [&](double cycles) {
    return verify(stout_beam(load + by_category_100 + "diaphragms = { category = 160 }\n" +
                                 changing(0.0, 0.0, cycles),
                             -20e3),
                  Figures::without, Advice::with);
  };
  const Verification of = with_cycles(2.5e5);
  REQUIRE(of.verdict == Verdict::fail);
  const CheckResult& worst = of.checks.front();
  CHECK_FALSE(worst.distortion);
  CHECK(worst.check.station.s.value() == 0.0);
  for (const CheckResult& result : of.checks) {
    if (result.distortion) CHECK(result.check.utilisation() < worst.check.utilisation());
  }
  CHECK(std::any_of(of.remedies.found.begin(), of.remedies.found.end(),
                    [](const Remedy& remedy) { return remedy.what == Remedy::What::category; }));
}

TEST_CASE("no order of loads does more damage than the check of distortion says", "[distortion]") {
  // Two torques at the same places in every situation, one after the other: their signs, by
  // exhaustion, and the cycles of the sum counted.
  const std::vector<std::array<double, 3>> factors{
      {1.0, 1.0, 0.2}, {-0.5, -0.4, 1.0}, {0.3, 0.9, -0.6}, {-1.0, 0.1, 0.5}, {0.8, -1.0, 0.0}};
  const double tip = -2e3, torque = 400e3;
  std::string text = twist("a", 48.0, torque) + twist("b", 51.0, torque) + diaphragm(0.0, "50 mm") +
                     by_category_100;
  std::string names;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    text += fmt::format("[[situations]]\nname = \"{}\"\nloads = {{ tip = {}, a = {}, b = {} }}\n",
                        i, factors[i][0], factors[i][1], factors[i][2]);
    names += fmt::format("{}\"{}\"", i > 0 ? ", " : "", i);
  }
  text += fmt::format("[[situations]]\nname = \"all\"\nsequence = [{}]\ncycles = 1e5\n", names);
  const Project project = stout_beam(text, tip);
  const Verification of = verify(project);
  const CheckResult& result = result_of(of, Criterion::distortion_fatigue);

  const DistortionSolver solver = solver_of({0.0, 48.0, 51.0, 100.0}, stout_cell(), {{0.0, 0.05}});
  const DistortedBeam& model = solver.beam();
  const CellDistortion stiffness = cell_distortion_of(stout_cell(), E, nu);
  const SnCurve curve = en_1993_1_9_direct(100.0);
  double most = 0.0;
  for (int ways = 0; ways < 4; ++ways) {
    std::vector<Distortion> found;
    for (const auto& at : factors) {
      std::vector<double> loads(model.nodes.size(), 0.0);
      loads[model.nearest(48.0)] = (ways & 1 ? 0.5 : -0.5) * at[1] * torque;
      loads[model.nearest(51.0)] = (ways & 2 ? 0.5 : -0.5) * at[2] * torque;
      found.push_back(solver.solve(loads));
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      std::vector<Stress> history;
      for (std::size_t k = 0; k < factors.size(); ++k) {
        history.push_back(
            si<Stress>(tip * factors[k][0] * (100.0 - model.nodes[i]) * 0.3 / I_stout +
                       found[k].warping_stress(i, stiffness, CellCorner::top_left)));
      }
      std::vector<Cycle> cycles = count_periodic_cycles(history);
      for (Cycle& cycle : cycles) cycle.count *= 1e5;
      most = std::max(most, 1.0 / largest_factor(cycles, curve, project.fatigue.demand));
    }
  }
  CHECK(1.0 / result.check.safety_factor >= most);
  CHECK(1.0 / result.check.safety_factor <= 2.0 * most);
}

TEST_CASE("in fatigue only what changes distorts", "[distortion]") {
  const auto of = [](double tip, double eccentric) {
    return estimate_of(beam(twist("eccentric", 50.0, 60e3) + diaphragm(0.0, "50 mm") +
                            by_category_100 + changing(tip, eccentric)));
  };
  const DistortionEstimate steady = of(-1.0, 1.0);
  CHECK(steady.across_range.value() == Approx(0.0).margin(1e-6 * steady.across.value()));
  CHECK(steady.bending_range.value() == Approx(2.0 * steady.bending.value()).epsilon(1e-9));
  const DistortionEstimate off = of(1.0, 0.0);
  CHECK(off.across_range.value() == Approx(off.across.value()).epsilon(1e-9));
  CHECK(off.along_range.value() == Approx(off.along.value()).epsilon(1e-9));
  CHECK(off.bending_range.value() == Approx(0.0).margin(1e-9 * off.bending.value()));
  const DistortionEstimate turned = of(1.0, -1.0);
  CHECK(turned.across_range.value() == Approx(2.0 * turned.across.value()).epsilon(1e-9));
}

}  // namespace distortion_fatigue_test
