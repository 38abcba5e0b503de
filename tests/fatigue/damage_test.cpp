#include "boxbeam/fatigue/damage.hpp"

#include <cmath>
#include <random>

#include "catch.hpp"

namespace damage_test {

using namespace boxbeam;

namespace {

Stress MPa(double x) { return si<Stress>(x * 1e6); }
SnCurve category(double x) { return en_1993_1_9_direct(x); }

/// Cycles of given ranges [MPa] and counts, all of them `times` as often.
std::vector<Cycle> cycles_of(std::vector<std::pair<double, double>> range_and_count,
                             double times = 1.0) {
  std::vector<Cycle> cycles;
  for (const auto& [range, count] : range_and_count) {
    cycles.push_back({MPa(range), MPa(0), count * times});
  }
  return cycles;
}

/// Ranges on all branches of the curves.
const std::vector<Cycle> example = cycles_of({{90, 1e5}, {60, 1e6}, {40, 1e7}});

FatigueDemand demand(double gamma_Mf = 1.0, Loading loading = Loading::spectrum) {
  return {loading, 1.0, gamma_Mf};
}

}  // namespace

TEST_CASE("damage is additive over blocks") {
  const auto once = cycles_of({{90, 1e5}, {60, 1e6}});
  const auto other = cycles_of({{40, 1e7}});
  CHECK(damage_of(example, category(71), demand()) ==
        Approx(damage_of(once, category(71), demand()) + damage_of(other, category(71), demand()))
            .epsilon(1e-14));
}

TEST_CASE("the factor, gamma_Ff and gamma_Mf all multiply the ranges") {
  const double expected = damage_of(example, category(71), demand(1), 1.2 * 1.1 * 1.35);
  CHECK(damage_of(example, category(71), {Loading::spectrum, 1.1, 1.35}, 1.2) ==
        Approx(expected).epsilon(1e-12));
}

TEST_CASE("constant amplitude: no damage below the knee divided by gamma_Mf") {
  // d_sigma_D = 73.68 MPa of category 100, 54.58 with 1.35.
  const auto at = [&](double range) {
    return damage_of(cycles_of({{range, 1e8}}), category(100),
                     demand(1.35, Loading::constant_amplitude));
  };
  CHECK(at(54.5) == 0.0);
  CHECK(at(54.7) > 1.0);
}

TEST_CASE("one cycle: the largest factor is the strength at its count over its range") {
  // By hand: at 1e6 cycles 100 (2e6/1e6)^(1/3), at 1e7 knee (5e6/1e7)^(1/5), behind 1e8 the
  // cut-off.
  const double knee = 100 * std::cbrt(0.4);
  const auto factor = [&](double count, Loading loading) {
    return largest_factor(cycles_of({{40, count}}), category(100), demand(1.0, loading));
  };
  CHECK(factor(1e6, Loading::spectrum) == Approx(100 * std::cbrt(2.0) / 40).epsilon(1e-12));
  CHECK(factor(1e7, Loading::spectrum) == Approx(knee * std::pow(0.5, 0.2) / 40).epsilon(1e-12));
  CHECK(factor(1e9, Loading::spectrum) == Approx(knee * std::pow(0.05, 0.2) / 40).epsilon(1e-12));
  CHECK(factor(1e9, Loading::constant_amplitude) == Approx(knee / 40).epsilon(1e-12));
  CHECK(largest_factor(cycles_of({{40, 1e6}}), category(100), {Loading::spectrum, 1.1, 1.35}) ==
        Approx(100 * std::cbrt(2.0) / 40 / 1.1 / 1.35).epsilon(1e-12));
}

TEST_CASE("a factor of N equal cycles is that of one cycle N times") {
  for (const double times : {1e5, 3e6, 1e9}) {
    const auto many = cycles_of({{40, 1}, {40, 2}, {40, 1}}, times);
    const auto one = cycles_of({{40, 4}}, times);
    CHECK(largest_factor(many, category(90), demand()) ==
          Approx(largest_factor(one, category(90), demand())).epsilon(1e-12));
  }
}

TEST_CASE("a history without cycles bears any factor") {
  CHECK(std::isinf(largest_factor({}, category(90), demand())));
  CHECK(std::isinf(largest_factor(cycles_of({{0, 1}, {0, 3}}), category(90), demand())));
}

TEST_CASE("random cycles: damage is at most 1 just below the largest factor, above 1 just above") {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const double categories[] = {36, 71, 100, 160};
  for (int run = 0; run < 400; ++run) {
    std::vector<Cycle> cycles;
    const int number = 1 + run % 9;
    const double times = std::pow(10.0, 3.0 + 6.0 * any(random));
    for (int i = 0; i < number; ++i) {
      const double range = std::pow(10.0, 3.0 * any(random));  // 1 to 1000 MPa
      cycles.push_back({MPa(range), MPa(0), times * (1.0 + std::floor(3.0 * any(random)))});
    }
    const double number_of = categories[run % 4];
    const SnCurve curve = run % 5 == 0 ? published_step(number_of) : category(number_of);
    const FatigueDemand wanted{run % 3 == 0 ? Loading::constant_amplitude : Loading::spectrum,
                               1.0 + any(random), 1.0 + 0.35 * any(random)};
    const double factor = largest_factor(cycles, curve, wanted);
    CAPTURE(run, factor, times);
    REQUIRE(std::isfinite(factor));
    CHECK(damage_of(cycles, curve, wanted, factor * (1 - 1e-9)) <= 1.0);
    CHECK(damage_of(cycles, curve, wanted, factor * (1 + 1e-9)) > 1.0);
    // Stresses k times as large leave a factor k times smaller.
    std::vector<Cycle> scaled = cycles;
    for (Cycle& cycle : scaled) cycle.range *= 2.7;
    CHECK(largest_factor(scaled, curve, wanted) == Approx(factor / 2.7).epsilon(1e-10));
  }
}

TEST_CASE("the largest factor is that of bisection, at kinks and jumps of the damage too") {
  // Plain bisection of the damage sum itself, without any bracket of ours.
  const auto bisected = [](std::span<const FatigueLoad> loads, const FatigueDemand& wanted) {
    const auto lives = [&](double factor) {
      double sum = 0.0;
      for (const FatigueLoad& load : loads) sum += damage_of(load, wanted, factor);
      return sum <= 1.0;
    };
    double low = 1e-9, high = 1e9;
    for (int i = 0; i < 200; ++i) {
      const double middle = std::sqrt(low * high);
      (lives(middle) ? low : high) = middle;
    }
    return low;
  };
  std::mt19937 random(47);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  // Lives at which a range stands on the knee, at the cut-off, between and beyond.
  const double lives_at[] = {2e6, 5e6, 1e8, 3e5, 4e7, 9e8};
  for (int run = 0; run < 300; ++run) {
    const auto cycles = [&](int number, double largest) {
      std::vector<Cycle> of;
      for (int i = 0; i < number; ++i) {
        const double range = i == 0 ? largest : largest * std::pow(10.0, -3.0 * any(random));
        const double count = i == 0 ? lives_at[run % 6] : 1e6 * any(random);
        of.push_back({MPa(range), MPa(0), count});
      }
      return of;
    };
    const std::vector<Cycle> direct = cycles(2 + run % 7, 60.0), shear = cycles(1 + run % 3, 30.0);
    const SnLine of_direct(category(71)), of_shear(en_1993_1_9_shear(80));
    const FatigueLoad loads[] = {{direct, &of_direct}, {shear, &of_shear}};
    const FatigueDemand wanted =
        demand(1.35, run % 2 == 0 ? Loading::spectrum : Loading::constant_amplitude);
    for (const std::size_t channels : {1U, 2U}) {
      const std::span<const FatigueLoad> some(loads, channels);
      CAPTURE(run, channels);
      CHECK(largest_factor(some, wanted) == Approx(bisected(some, wanted)).epsilon(1e-13));
    }
  }
}

TEST_CASE(
    "constant amplitude: below the knee nothing damages, above it the smaller ranges do too") {
  // 7.1(2) and 7.1(3): category 100, knee 73.68 MPa. A history of one large and one small range.
  const SnCurve curve = category(100);
  FatigueDemand demand;
  demand.loading = Loading::constant_amplitude;
  const std::vector<Cycle> below{{si<Stress>(73e6), {}, 1e6}, {si<Stress>(60e6), {}, 5e6}};
  CHECK(damage_of(below, curve, demand) == 0.0);
  const std::vector<Cycle> above{{si<Stress>(80e6), {}, 1e6}, {si<Stress>(60e6), {}, 5e6}};
  // By hand: N(80) = 2e6 (100/80)^3, N(60) = 5e6 (73.68/60)^5.
  const double knee = 100.0 * std::cbrt(0.4);
  const double expected =
      1e6 / (2e6 * std::pow(100.0 / 80.0, 3)) + 5e6 / (5e6 * std::pow(knee / 60.0, 5));
  CHECK(damage_of(above, curve, demand) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("direct stress and shear together: 0.9^3 + 0.50625^5 = 0.76225, EN 1993-1-9 8(3)") {
  // 2e6 cycles of 60 MPa on category 90 and of 30 MPa shear on category 80, gamma_Mf = 1.35; by
  // hand 60/(90/1.35) = 0.9 and 30/(80/1.35) = 0.50625.
  const auto direct = cycles_of({{60, 2e6}});
  const auto shear = cycles_of({{30, 2e6}});
  const double D_direct = damage_of(direct, category(90), demand(1.35));
  const double D_shear = damage_of(shear, en_1993_1_9_shear(80), demand(1.35));
  CHECK(D_direct == Approx(0.729).epsilon(1e-12));
  CHECK(D_shear == Approx(0.03325).margin(1e-5));
  CHECK(D_direct + D_shear == Approx(0.76225).margin(1e-5));
  const FatigueChannel channels[] = {{direct, category(90)}, {shear, en_1993_1_9_shear(80)}};
  const double factor = largest_factor(channels, demand(1.35));
  CHECK(std::pow(0.9 * factor, 3) + std::pow(0.50625 * factor, 5) == Approx(1.0).epsilon(1e-12));
  // A channel without cycles changes nothing.
  const FatigueChannel alone[] = {{direct, category(90)}, {{}, en_1993_1_9_shear(80)}};
  CHECK(largest_factor(alone, demand(1.35)) ==
        Approx(largest_factor(direct, category(90), demand(1.35))).epsilon(1e-14));
}

TEST_CASE(
    "two channels: the damage of both is at most 1 just below the factor, above 1 just above") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int run = 0; run < 200; ++run) {
    FatigueChannel channels[2] = {{{}, category(80)}, {{}, en_1993_1_9_shear(100)}};
    for (FatigueChannel& channel : channels) {
      for (int i = 0; i < 1 + run % 5; ++i) {
        channel.cycles.push_back(
            {MPa(std::pow(10.0, 3.0 * any(random))), MPa(0), std::pow(10.0, 9.0 * any(random))});
      }
    }
    const double factor = largest_factor(channels, demand());
    const auto damage = [&](double k) {
      return damage_of(channels[0].cycles, channels[0].curve, demand(), k) +
             damage_of(channels[1].cycles, channels[1].curve, demand(), k);
    };
    CAPTURE(run, factor);
    CHECK(damage(factor * (1 - 1e-9)) <= 1.0);
    CHECK(damage(factor * (1 + 1e-9)) > 1.0);
  }
}

TEST_CASE("the equivalent range at 2e6 does the damage of the spectrum") {
  const FatigueDemand wanted{Loading::spectrum, 1.1, 1.35};
  const double D = damage_of(example, category(56), wanted);
  const Stress equivalent = equivalent_range(D, category(56), wanted);
  const std::vector<Cycle> same{{equivalent, MPa(0), 2e6}};
  CHECK(damage_of(same, category(56), wanted) == Approx(D).epsilon(1e-12));
  // Equal cycles at 2e6 are their own equivalent.
  const auto equal = cycles_of({{50, 2e6}});
  CHECK(equivalent_range(damage_of(equal, category(56), wanted), category(56), wanted).value() ==
        Approx(50e6).epsilon(1e-12));
  CHECK(equivalent_range(0.0, category(56), wanted).value() == 0.0);
}

TEST_CASE("compression counts 60 %: +80/-60 MPa is a range of 116 MPa, EN 1993-1-9 7.2.1") {
  const auto range = [&](double highest, double lowest) {
    const std::vector<Cycle> cycles{{MPa(highest - lowest), MPa(0.5 * (highest + lowest)), 1.0}};
    return compression_reduced(cycles).front().range.value() * 1e-6;
  };
  CHECK(range(80, -60) == Approx(116).epsilon(1e-12));
  CHECK(range(80, 20) == Approx(60).epsilon(1e-12));    // all tension: as it is
  CHECK(range(-20, -80) == Approx(36).epsilon(1e-12));  // all compression: 60 %
  CHECK(range(50, 0) == Approx(50).epsilon(1e-12));
}

}  // namespace damage_test
