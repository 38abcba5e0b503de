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
    CHECK(std::abs(slope.value() - exponent) <= slope.error + 1e-12);
  }
}

TEST_CASE("where another place governs on the other side both slopes are told", "[study]") {
  const Slope slope = slope_of([](double x) { return std::min(2.0 * x, 2.0 / (x * x)); });
  CHECK(slope.kinks());
  CHECK(*slope.down == Approx(1.0).epsilon(1e-9));
  CHECK(*slope.up == Approx(-2.0).epsilon(1e-3));
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

TEST_CASE("what does not change has no slope", "[study]") {
  CHECK(slope_of([](double) { return 3.0; }).value() == 0.0);
}

}  // namespace sensitivities_test
