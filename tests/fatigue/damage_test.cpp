#include "boxbeam/fatigue/damage.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

using namespace boxbeam;

namespace {

Stress MPa(double x) { return si<Stress>(x * 1e6); }
SnCurve category(double x) { return {MPa(x), CurveKind::en_1993_1_9}; }

std::vector<Cycle> cycles_of(std::vector<std::pair<double, double>> range_and_count) {
  std::vector<Cycle> cycles;
  for (const auto& [range, count] : range_and_count) cycles.push_back({MPa(range), MPa(0), count});
  return cycles;
}

/// 1e5 cycles of 90, 1e6 of 60 and 1e7 of 40 MPa: a published example of Miner's rule.
const std::vector<Cycle> example = cycles_of({{90, 1e5}, {60, 1e6}, {40, 1e7}});

FatigueDemand demand(double periods, double gamma_Mf = 1.0, Loading loading = Loading::spectrum) {
  return {periods, loading, 1.0, gamma_Mf};
}

}  // namespace

TEST_CASE("Miner's sum of a published example: 2.5 for category 56, 0.33 for category 90") {
  // Published 2.5 and 0.33; to more digits from the equations of EN 1993-1-9, 7.1, apart from
  // this program.
  CHECK(damage_of(example, category(56), demand(1)) == Approx(2.535004).margin(1e-6));
  CHECK(damage_of(example, category(90), demand(1)) == Approx(0.331002).margin(1e-6));
}

TEST_CASE("the same with gamma_Mf = 1.15 and 1.35 on the whole curve, EN 1993-1-9 annex A.5") {
  CHECK(damage_of(example, category(56), demand(1, 1.15)) == Approx(4.022244).margin(1e-6));
  CHECK(damage_of(example, category(90), demand(1, 1.15)) == Approx(0.622606).margin(1e-6));
  CHECK(damage_of(example, category(56), demand(1, 1.35)) == Approx(6.506931).margin(1e-6));
  CHECK(damage_of(example, category(90), demand(1, 1.35)) == Approx(1.203694).margin(1e-6));
}

TEST_CASE("category 71: 1e5 of 100, 5e5 of 60 and 2e6 of 40 MPa give 0.39512") {
  // A published example with one slope gives 0.46939; with the standard's m = 5 branch 0.39512.
  const auto cycles = cycles_of({{100, 1e5}, {60, 5e5}, {40, 2e6}});
  CHECK(damage_of(cycles, category(71), demand(1)) == Approx(0.395120).margin(1e-6));
}

TEST_CASE("damage is proportional to the number of periods") {
  CHECK(damage_of(example, category(71), demand(7)) ==
        Approx(7.0 * damage_of(example, category(71), demand(1))).epsilon(1e-14));
}

TEST_CASE("the factor, gamma_Ff and gamma_Mf all multiply the ranges") {
  const double expected = damage_of(example, category(71), demand(1), 1.2 * 1.1 * 1.35);
  CHECK(damage_of(example, category(71), {1, Loading::spectrum, 1.1, 1.35}, 1.2) ==
        Approx(expected).epsilon(1e-12));
}

TEST_CASE("constant amplitude: no damage below the knee divided by gamma_Mf") {
  // d_sigma_D = 73.68 MPa of category 100, 54.58 with 1.35.
  const auto at = [&](double range) {
    return damage_of(cycles_of({{range, 1}}), category(100),
                     demand(1e8, 1.35, Loading::constant_amplitude));
  };
  CHECK(at(54.5) == 0.0);
  CHECK(at(54.7) > 1.0);
}

TEST_CASE("one cycle: the largest factor is the strength at its count over its range") {
  const auto cycle = cycles_of({{40, 1}});
  // By hand: at 1e6 cycles 100 (2e6/1e6)^(1/3), at 1e7 knee (5e6/1e7)^(1/5), behind 1e8 the
  // cut-off.
  const double knee = 100 * std::cbrt(0.4);
  const auto factor = [&](double periods, Loading loading) {
    return largest_factor(cycle, category(100), demand(periods, 1.0, loading));
  };
  CHECK(factor(1e6, Loading::spectrum) == Approx(100 * std::cbrt(2.0) / 40).epsilon(1e-12));
  CHECK(factor(1e7, Loading::spectrum) == Approx(knee * std::pow(0.5, 0.2) / 40).epsilon(1e-12));
  CHECK(factor(1e9, Loading::spectrum) == Approx(knee * std::pow(0.05, 0.2) / 40).epsilon(1e-12));
  CHECK(factor(1e9, Loading::constant_amplitude) == Approx(knee / 40).epsilon(1e-12));
  CHECK(largest_factor(cycle, category(100), {1e6, Loading::spectrum, 1.1, 1.35}) ==
        Approx(100 * std::cbrt(2.0) / 40 / 1.1 / 1.35).epsilon(1e-12));
}

TEST_CASE("a factor of N equal cycles is that of one cycle N times") {
  const auto many = cycles_of({{40, 1}, {40, 2}, {40, 1}});
  const auto one = cycles_of({{40, 4}});
  for (const double periods : {1e5, 3e6, 1e9}) {
    CHECK(largest_factor(many, category(90), demand(periods)) ==
          Approx(largest_factor(one, category(90), demand(periods))).epsilon(1e-12));
  }
}

TEST_CASE("a history without cycles bears any factor") {
  CHECK(std::isinf(largest_factor({}, category(90), demand(1e6))));
  CHECK(std::isinf(largest_factor(cycles_of({{0, 1}, {0, 3}}), category(90), demand(1e6))));
}

TEST_CASE("random cycles: damage is at most 1 just below the largest factor, above 1 just above") {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const double categories[] = {36, 71, 100, 160};
  for (int run = 0; run < 400; ++run) {
    std::vector<Cycle> cycles;
    const int number = 1 + run % 9;
    for (int i = 0; i < number; ++i) {
      const double range = std::pow(10.0, 3.0 * any(random));  // 1 to 1000 MPa
      cycles.push_back({MPa(range), MPa(0), 1.0 + std::floor(3.0 * any(random))});
    }
    const SnCurve curve{MPa(categories[run % 4]),
                        run % 5 == 0 ? CurveKind::published_step : CurveKind::en_1993_1_9};
    const FatigueDemand wanted{std::pow(10.0, 3.0 + 6.0 * any(random)),
                               run % 3 == 0 ? Loading::constant_amplitude : Loading::spectrum,
                               1.0 + any(random), 1.0 + 0.35 * any(random)};
    const double factor = largest_factor(cycles, curve, wanted);
    CAPTURE(run, factor, wanted.periods);
    REQUIRE(std::isfinite(factor));
    CHECK(damage_of(cycles, curve, wanted, factor * (1 - 1e-9)) <= 1.0);
    CHECK(damage_of(cycles, curve, wanted, factor * (1 + 1e-9)) > 1.0);
    // Stresses k times as large leave a factor k times smaller.
    std::vector<Cycle> scaled = cycles;
    for (Cycle& cycle : scaled) cycle.range *= 2.7;
    CHECK(largest_factor(scaled, curve, wanted) == Approx(factor / 2.7).epsilon(1e-10));
  }
}

TEST_CASE(
    "constant amplitude: below the knee nothing damages, above it the smaller ranges do too") {
  // 7.1(2) and 7.1(3): category 100, knee 73.68 MPa. A history of one large and one small range.
  const SnCurve curve{si<Stress>(100e6), CurveKind::en_1993_1_9};
  FatigueDemand demand;
  demand.periods = 1e6;
  demand.loading = Loading::constant_amplitude;
  const std::vector<Cycle> below{{si<Stress>(73e6), {}, 1.0}, {si<Stress>(60e6), {}, 5.0}};
  CHECK(damage_of(below, curve, demand) == 0.0);
  const std::vector<Cycle> above{{si<Stress>(80e6), {}, 1.0}, {si<Stress>(60e6), {}, 5.0}};
  // By hand: N(80) = 2e6 (100/80)^3, N(60) = 5e6 (73.68/60)^5.
  const double knee = 100.0 * std::cbrt(0.4);
  const double expected =
      1e6 / (2e6 * std::pow(100.0 / 80.0, 3)) + 5e6 / (5e6 * std::pow(knee / 60.0, 5));
  CHECK(damage_of(above, curve, demand) == Approx(expected).epsilon(1e-12));
}
