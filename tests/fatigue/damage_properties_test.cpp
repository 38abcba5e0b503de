// Properties that hold for every spectrum, checked on random ones.
#include <cmath>

#include "boxbeam/fatigue/damage.hpp"
#include "catch.hpp"
#include "support/property.hpp"

namespace damage_properties_test {

using namespace boxbeam;

namespace {

/// A random spectrum: ranges of 1 to 1000 MPa, 1 to 1e9 cycles of each.
std::vector<Cycle> any_spectrum() {
  const auto size = *rc::gen::inRange(1, 12);
  std::vector<Cycle> cycles;
  for (int i = 0; i < size; ++i) {
    const double range = std::pow(10.0, *rc::gen::inRange(0, 3001) * 1e-3);
    const double count = std::pow(10.0, *rc::gen::inRange(0, 9001) * 1e-3);
    cycles.push_back({si<Stress>(range * 1e6), Stress{}, count});
  }
  return cycles;
}

SnCurve any_curve() {
  const double category = *rc::gen::element(36.0, 56.0, 71.0, 100.0, 160.0);
  return *rc::gen::arbitrary<bool>() ? en_1993_1_9_direct(category)
                                     : en_1993_1_9_shear(*rc::gen::element(80.0, 100.0));
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-10 * std::max(std::abs(a), 1e-300); }

}  // namespace

TEST_CASE("property: the damage of two blocks is the sum of theirs") {
  test::holds([] {
    const SnCurve curve = any_curve();
    const std::vector<Cycle> one = any_spectrum();
    const std::vector<Cycle> other = any_spectrum();
    std::vector<Cycle> both = one;
    both.insert(both.end(), other.begin(), other.end());
    RC_ASSERT(
        near(damage_of(both, curve, {}), damage_of(one, curve, {}) + damage_of(other, curve, {})));
  });
}

TEST_CASE("property: k times the stress lives k^-m times as long on a branch of slope m") {
  test::holds([] {
    const double k = 1.0 + *rc::gen::inRange(1, 1000) * 1e-3;
    const SnCurve direct = en_1993_1_9_direct(100);
    // Above the knee, 73.68 MPa, m = 3; k times as much stays there.
    const double high = 74.0 + *rc::gen::inRange(0, 400);
    const auto life = [&](const SnCurve& curve, double range) {
      return cycles_to_failure(curve, si<Stress>(range * 1e6), Loading::spectrum);
    };
    RC_ASSERT(near(life(direct, k * high), life(direct, high) / (k * k * k)));
    // Shear: m = 5 down to the cut-off, 45.73 MPa.
    const SnCurve shear = en_1993_1_9_shear(100);
    const double low = 46.0 + *rc::gen::inRange(0, 400);
    RC_ASSERT(near(life(shear, k * low), life(shear, low) / std::pow(k, 5)));
  });
}

TEST_CASE("property: loads k times as large leave a factor k times smaller") {
  test::holds([] {
    const double k = 1.0 + *rc::gen::inRange(1, 3000) * 1e-3;
    const SnCurve curve = any_curve();
    const std::vector<Cycle> cycles = any_spectrum();
    std::vector<Cycle> scaled = cycles;
    for (Cycle& cycle : scaled) cycle.range *= k;
    RC_ASSERT(near(largest_factor(scaled, curve, {}), largest_factor(cycles, curve, {}) / k));
  });
}

TEST_CASE("property: more cycles, a weaker curve or another channel never raise the factor") {
  test::holds([] {
    const FatigueChannel one{any_spectrum(), en_1993_1_9_direct(90)};
    const FatigueChannel other{any_spectrum(), en_1993_1_9_shear(80)};
    const FatigueChannel both[] = {one, other};
    const double together = largest_factor(both, {});
    RC_ASSERT(together <= largest_factor(one.cycles, one.curve, {}) * (1 + 1e-12));
    RC_ASSERT(together <= largest_factor(other.cycles, other.curve, {}) * (1 + 1e-12));
    std::vector<Cycle> more = one.cycles;
    more.push_back({si<Stress>(50e6), Stress{}, 1e7});
    RC_ASSERT(largest_factor(more, one.curve, {}) <=
              largest_factor(one.cycles, one.curve, {}) * (1 + 1e-12));
    RC_ASSERT(largest_factor(one.cycles, en_1993_1_9_direct(80), {}) <
              largest_factor(one.cycles, one.curve, {}));
  });
}

TEST_CASE("property: the largest factor is that of halving alone, to its last digit") {
  test::holds([] {
    const SnCurve curve = *rc::gen::arbitrary<bool>() ? any_curve() : en_1993_1_9_shear(80);
    const FatigueDemand demand{
        *rc::gen::arbitrary<bool>() ? Loading::spectrum : Loading::constant_amplitude, 1.0, 1.15};
    std::vector<Cycle> cycles = any_spectrum();
    // So many cycles that the largest range may do no damage but where it passes the cut-off.
    const double times = *rc::gen::element(1.0, 1e2, 1e6);
    for (Cycle& cycle : cycles) cycle.count *= times;
    if (cycles.size() < 2) return;
    // One of its ranges at the strength of all cycles is below, twice that again and again above.
    double count = 0.0, largest = 0.0;
    for (const Cycle& cycle : cycles) {
      count += cycle.count;
      largest = std::max(largest, cycle.range.value());
    }
    if (largest == 0.0) return;
    double low = strength_at(curve, count, demand.loading).value() /
                 (demand.gamma_Ff * demand.gamma_Mf * largest);
    double high = 2.0 * low;
    for (; damage_of(cycles, curve, demand, high) <= 1.0; high *= 2.0) low = high;
    while (high - low > 1e-15 * high) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (damage_of(cycles, curve, demand, middle) <= 1.0 ? low : high) = middle;
    }
    RC_ASSERT(largest_factor(cycles, curve, demand) == low);
  });
}

}  // namespace damage_properties_test
