// Cycles of the sum of two stresses of which one is known by its range and its rise alone.

#include "boxbeam/fatigue/joined_cycles.hpp"

#include <algorithm>
#include <random>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/rainflow.hpp"
#include "catch.hpp"

namespace joined_cycles_test {

using namespace boxbeam;

namespace {

double damage(const std::vector<Cycle>& cycles, double category) {
  return damage_of(cycles, en_1993_1_9_direct(category), {Loading::spectrum, 1.0, 1.0});
}

std::vector<Stress> sum_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<Stress> sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum.push_back(si<Stress>(a[i] + b[i]));
  return sum;
}

}  // namespace

TEST_CASE("one cycle and another of its kind are one of both ranges", "[joined cycles]") {
  const std::vector<Cycle> one{{si<Stress>(30e6), si<Stress>(5e6), 1.0}};
  const std::vector<Cycle> both = joined_cycles(one, si<Stress>(10e6), si<Stress>(10e6));
  REQUIRE(both.size() == 1);
  CHECK(both.front().range.value() == Approx(40e6));
  // What rises three times is left over twice.
  const std::vector<Cycle> three = joined_cycles(one, si<Stress>(10e6), si<Stress>(30e6));
  REQUIRE(three.size() == 2);
  CHECK(three.back().range.value() == Approx(10e6));
  CHECK(three.back().count == Approx(2.0));
  CHECK(joined_cycles(one, Stress{}, Stress{}).size() == 1);
  CHECK(joined_cycles({}, si<Stress>(10e6), si<Stress>(15e6)).front().count == Approx(1.5));
}

TEST_CASE("joined cycles do no less damage than those of the sum", "[joined cycles]") {
  // Random histories, many of them steps up and down at unlike times, whose sums have more cycles
  // than both.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto history_of = [&](std::size_t count, double scale) {
    std::vector<double> history;
    double value = 0.0;
    const int kind = static_cast<int>(3.0 * uniform(random));
    for (std::size_t i = 0; i < count; ++i) {
      if (kind == 0) value = scale * uniform(random);
      if (kind == 1) value += scale * (uniform(random) - 0.5);
      if (kind == 2) value += uniform(random) < 0.3 ? (2 * i < count ? scale : -scale) : 0.0;
      history.push_back(value);
    }
    return history;
  };
  double tightest = 1e9;
  for (int trial = 0; trial < 4000; ++trial) {
    const auto count = static_cast<std::size_t>(2.0 + 12.0 * uniform(random));
    const std::vector<double> a = history_of(count, 60e6 * uniform(random));
    const std::vector<double> b = history_of(count, 60e6 * uniform(random));
    const auto [low, high] = std::minmax_element(b.begin(), b.end());
    double rise = std::max(0.0, b.front() - b.back());
    for (std::size_t i = 1; i < count; ++i) rise += std::max(0.0, b[i] - b[i - 1]);
    const std::vector<double> none(count, 0.0);
    const auto joined = joined_cycles(count_periodic_cycles(sum_of(a, none)),
                                      si<Stress>(*high - *low), si<Stress>(rise));
    for (const double category : {36.0, 100.0}) {
      const double bound = damage(joined, category);
      const double real = damage(count_periodic_cycles(sum_of(a, b)), category);
      if (bound < real * (1.0 - 1e-9))
        FAIL_CHECK("trial " << trial << ": " << bound << " < " << real);
      if (real > 0.0) tightest = std::min(tightest, bound / real);
    }
  }
  CHECK(tightest >= 1.0 - 1e-9);
  CHECK(tightest < 1.01);
}

}  // namespace joined_cycles_test
