// Slopes of results by inputs: powers have their exponent, kinks both of theirs.

#include "boxbeam/study/sensitivities.hpp"

#include <cmath>

#include "catch.hpp"

namespace sensitivities_test {

using namespace boxbeam;

namespace {

Slope slope_of(const std::function<std::optional<double>(double)>& f) {
  const auto results_at = [&](double factor) -> std::optional<std::map<Criterion, double>> {
    const std::optional<double> value = f(factor);
    if (!value) return std::nullopt;
    return std::map<Criterion, double>{{Criterion::yield, *value}};
  };
  return slopes_of(*results_at(1.0), results_at).at(Criterion::yield);
}

}  // namespace

TEST_CASE("a power has its exponent as slope", "[study]") {
  for (const double exponent : {-5.0, -3.0, -1.0, 0.2, 1.0, 2.0, 15.0}) {
    CAPTURE(exponent);
    const Slope slope = slope_of([&](double x) { return 7.0 * std::pow(x, exponent); });
    CHECK(slope.value() == Approx(exponent).epsilon(1e-5));
    CHECK_FALSE(slope.kinks());
    CHECK(std::abs(slope.value() - exponent) <= slope.of_both().error + 1e-12);
  }
}

TEST_CASE("where another place governs on the other side both slopes are told", "[study]") {
  const Slope slope = slope_of([](double x) { return std::min(2.0 * x, 2.0 / (x * x)); });
  CHECK(slope.kinks());
  CHECK(slope.down->slope == Approx(1.0).epsilon(1e-9));
  CHECK(slope.up->slope == Approx(-2.0).epsilon(1e-3));
  CHECK(slope.value() == Approx(-2.0).epsilon(1e-3));
}

TEST_CASE("where only one side can be verified its slope is told", "[study]") {
  const Slope slope = slope_of([](double x) -> std::optional<double> {
    if (x > 1.0) return std::nullopt;
    return x * x;
  });
  CHECK_FALSE(slope.up);
  CHECK(slope.value() == Approx(2.0).epsilon(1e-9));
  CHECK(slopes_of({{Criterion::yield, 1.0}}, [](double) { return std::nullopt; }).empty());
}

TEST_CASE("what is level on one side and not known on the other has an effect", "[study]") {
  const auto with = [](const Slope& slope) {
    Sensitivity input;
    input.slopes[Criterion::yield] = slope;
    return input;
  };
  const Slope falls = slope_of([](double x) { return x < 1.003 ? 1.0 : 0.9; });
  const Slope bends = slope_of([](double x) { return std::min(1.0, 1.0 - 3.0 * (x - 1.002)); });
  CHECK_FALSE(with(falls).has_no_effect());
  CHECK_FALSE(with(bends).has_no_effect());
  CHECK_FALSE(with(slope_of([](double x) { return 2.0 + 1e-2 * x; })).has_no_effect());
  CHECK(with(slope_of([](double) { return 3.0; })).has_no_effect());
  // Of one side alone, too.
  CHECK(with(slope_of([](double x) {
          return x > 1.0 ? std::nullopt : std::optional(3.0);
        })).has_no_effect());
}

// Slope 1 before and 1 + jump behind a place some way from where it is asked for: what is stated
// holds within its error on either side, or is not known.
TEST_CASE("a kink or a jump close by is in what is stated, or it is said to be not known",
          "[study]") {
  for (const double jump : {-3.0, -0.5, -0.1, 0.03, 0.1, 0.5, 3.0})
    for (const double place : {-0.012, -0.0075, -0.005, -0.003, -0.001, 0.0, 0.0007, 0.001, 0.0015,
                               0.002, 0.0033, 0.005, 0.007, 0.009, 0.012}) {
      CAPTURE(jump, place);
      const Slope slope = slope_of(
          [&](double x) { return 1.0 + (x - 1.0) + jump * std::max(0.0, x - 1.0 - place); });
      REQUIRE(slope.down);
      REQUIRE(slope.up);
      // By 1 + (x - 1): f at 1 is 1 but for what the kink before it has added.
      const double own = 1.0 + jump * std::max(0.0, -place);
      const double before = (place < 0.0 ? 1.0 + jump : 1.0) / own;
      const double behind = (place <= 0.0 ? 1.0 + jump : 1.0) / own;
      // Nothing that is looked at lies nearer.
      if (std::abs(place) < 0.005 / 8.0 && place != 0.0) continue;
      if (slope.down->is_known())
        CHECK(std::abs(slope.down->slope - before) <= slope.down->error + 1e-9);
      if (slope.up->is_known()) CHECK(std::abs(slope.up->slope - behind) <= slope.up->error + 1e-9);
    }
  for (const double place : {-0.008, -0.002, -1e-9, 1e-9, 0.002, 0.008}) {
    CAPTURE(place);
    const Slope slope = slope_of([&](double x) { return x - 1.0 < place ? x : 0.5 * x; });
    CHECK_FALSE((place < 0.0 ? slope.down : slope.up)->is_known());
    const SideSlope& other = *(place < 0.0 ? slope.up : slope.down);
    CHECK(other.is_known());
    CHECK(other.slope == Approx(1.0).epsilon(1e-9));
    CHECK(slope.value() == Approx(1.0).epsilon(1e-9));
  }
  // The value itself is apart from both sides.
  const Slope slope = slope_of([](double x) { return x == 1.0 ? 1.1 : x; });
  CHECK_FALSE(slope.of_both().is_known());
}

TEST_CASE("what does not change has no slope", "[study]") {
  CHECK(slope_of([](double) { return 3.0; }).value() == 0.0);
}

}  // namespace sensitivities_test
