// A stress history judged by itself, against hand sums of its cycles.

#include "boxbeam/verification/history_fatigue.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace history_fatigue_test {

using namespace boxbeam;

namespace {

HistoryDemand demand_on(const std::string& path, double category = 56) {
  HistoryDemand demand;
  demand.source.path = path;
  demand.direct.curve = en_1993_1_9_direct(category);
  return demand;
}

}  // namespace

TEST_CASE("equal waves of one range: their number by their damage, repeated as asked") {
  const test::TemporaryFolder folder;
  std::string text = "sigma [MPa]\n0\n";
  for (int i = 0; i < 10; ++i) text += "100\n0\n";
  HistoryDemand demand = demand_on(folder.write("waves.csv", text));
  demand.repetitions = 50000.0;
  std::uint64_t told = 0;
  const HistoryFatigue fatigue =
      fatigue_of_history(demand, [&](std::uint64_t samples) { told = samples; });
  CHECK(told == 21);
  CHECK(fatigue.history.samples == 21);
  // Ten cycles of 100 MPa 5e4 times, N = 2e6 (56/100)^3.
  const double once = 10.0 / (2e6 * std::pow(0.56, 3));
  CHECK(fatigue.direct.cycles == Approx(5e5));
  CHECK(fatigue.damage == Approx(5e4 * once).epsilon(1e-12));
  REQUIRE(fatigue.life);
  CHECK(*fatigue.life == Approx(1.0 / once).epsilon(1e-12));
  CHECK(fatigue.direct.equivalent_range.value() ==
        Approx(100e6 * std::cbrt(5e5 / 2e6)).epsilon(1e-12));
  CHECK_FALSE(fatigue.passes());
  CHECK_FALSE(fatigue.shear);
}

TEST_CASE("the damage of a long history is that of the cycles in its spectrum") {
  const test::TemporaryFolder folder;
  std::mt19937 random(17);
  std::uniform_int_distribution<int> any(-20, 20);
  std::string text = "sigma [MPa]\n";
  for (int i = 0; i < 30000; ++i) text += fmt::format("{}\n", 5 * any(random));
  HistoryDemand demand = demand_on(folder.write("noise.csv", text));
  demand.demand.gamma_Mf = 1.35;
  for (const bool reduced : {false, true}) {
    demand.compression_reduced = reduced;
    const HistoryFatigue fatigue = fatigue_of_history(demand);
    std::vector<Cycle> cycles;
    for (const SpectrumBin& bin : fatigue.direct.spectrum) {
      cycles.push_back({bin.range, bin.mean, bin.count});
    }
    if (!fatigue.direct.binned) {
      CHECK(fatigue.damage ==
            Approx(damage_of(cycles, demand.direct.curve, demand.demand)).epsilon(1e-10));
    }
    // The rainflow of any history holds its whole range, 200 MPa here; of it 100 is compression.
    CHECK(fatigue.direct.largest.value() == Approx(reduced ? 160e6 : 200e6).epsilon(1e-12));
  }
}

TEST_CASE("normal and shear stress are counted apart and their damages added, 8(3)") {
  const test::TemporaryFolder folder;
  std::string text = "sigma [MPa], tau [MPa]\n";
  for (int i = 0; i < 5; ++i) text += "0, 0\n100, 40\n";
  text += "0, 0\n";
  HistoryDemand demand = demand_on(folder.write("both.csv", text));
  CHECK_THROWS_AS(fatigue_of_history(demand), InputError);
  demand.shear = NamedResistance{en_1993_1_9_shear(80), "", 1.0, 1.0, "", ""};
  const HistoryFatigue fatigue = fatigue_of_history(demand);
  REQUIRE(fatigue.shear);
  CHECK(fatigue.direct.damage == Approx(5.0 / (2e6 * std::pow(0.56, 3))).epsilon(1e-12));
  CHECK(fatigue.shear->damage == Approx(5.0 / (2e6 * std::pow(2.0, 5))).epsilon(1e-12));
  CHECK(fatigue.damage == fatigue.direct.damage + fatigue.shear->damage);
}

TEST_CASE("a curve for shear and a history without any: the normal stress alone") {
  const test::TemporaryFolder folder;
  HistoryDemand demand = demand_on(folder.write("one.csv", "sigma [MPa]\n0\n100\n0\n"));
  demand.shear = NamedResistance{en_1993_1_9_shear(80), "", 1.0, 1.0, "", ""};
  const HistoryFatigue fatigue = fatigue_of_history(demand);
  CHECK_FALSE(fatigue.shear);
  CHECK(fatigue.damage == fatigue.direct.damage);
}

TEST_CASE("a history whose ranges are below the cut-off lives without limit") {
  const test::TemporaryFolder folder;
  // Category 56: cut-off 56 0.4047 = 22.7 MPa.
  HistoryDemand demand = demand_on(folder.write("quiet.csv", "sigma [MPa]\n0\n22\n0\n"));
  demand.repetitions = 1e12;
  const HistoryFatigue fatigue = fatigue_of_history(demand);
  CHECK(fatigue.damage == 0.0);
  CHECK_FALSE(fatigue.life);
  CHECK(fatigue.passes());
  CHECK(fatigue.direct.equivalent_range.value() == 0.0);
  // At constant amplitude nothing below the limit of 41.3 MPa.
  demand.source.path = folder.write("more.csv", "sigma [MPa]\n0\n41\n0\n");
  CHECK(fatigue_of_history(demand).damage > 0.0);
  demand.demand.loading = Loading::constant_amplitude;
  CHECK(fatigue_of_history(demand).damage == 0.0);
}

}  // namespace history_fatigue_test
