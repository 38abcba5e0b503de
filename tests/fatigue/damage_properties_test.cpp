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

}  // namespace damage_properties_test
