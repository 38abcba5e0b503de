// Drivers: derivatives by central differences, ends, periods.

#include "boxbeam/mechanism/common/driver.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"

namespace driver_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("rate and acceleration of every driver are the derivatives of its value") {
  const std::vector<Driver> drivers = {
      HarmonicDriver{0.2, 0.3, 4.0, 0.5, {{0.1, 12.0, -0.3}, {0.02, 40.0, 1.0}}},
      RateDriver{0.4, -2.0}, PolynomialDriver{{0.3, -1.0, 0.5, 2.0, -0.7}},
      StepDriver{0.5, -0.2, 0.1, 1.3},
      TableDriver{TableCurve({0.0, 0.4, 0.7, 1.5}, {0.0, 0.3, 0.1, 1.0}, Interpolation::cubic,
                             Beyond::hold)}};
  const double h = 1e-4;
  for (const Driver& driver : drivers) {
    for (const double t : {0.2345, 0.5, 0.813, 1.2}) {
      const DriverState here = driver_at(driver, t);
      const double before = driver_at(driver, t - h).value;
      const double behind = driver_at(driver, t + h).value;
      CHECK(here.rate == Approx((behind - before) / (2.0 * h)).margin(1e-4));
      CHECK(here.acceleration ==
            Approx((behind - 2.0 * here.value + before) / (h * h)).margin(2e-3));
    }
  }
}

TEST_CASE("a smooth step begins and ends at rest, exactly at its values") {
  const StepDriver step{0.5, -0.2, 0.1, 1.3};
  for (const double t : {-1.0, 0.1}) {
    const DriverState state = driver_at(step, t);
    CHECK(state.value == 0.5);
    CHECK(state.rate == 0.0);
    CHECK(state.acceleration == 0.0);
  }
  for (const double t : {1.3, 9.0}) {
    const DriverState state = driver_at(step, t);
    CHECK(state.value == -0.2);
    CHECK(state.rate == 0.0);
    CHECK(state.acceleration == 0.0);
  }
  // Half-way by symmetry; largest rate 15/8 of the mean one (hand, from 30 u^2 (1-u)^2 at 1/2).
  CHECK(driver_at(step, 0.7).value == Approx(0.15));
  CHECK(driver_at(step, 0.7).rate == Approx(15.0 / 8.0 * -0.7 / 1.2));
}

TEST_CASE("periods: one, a common one, none") {
  CHECK(common_period_of({2.0 * pi}).value() == Approx(1.0));
  // 0.4 s and 0.6 s meet after 1.2 s.
  CHECK(common_period_of({2.0 * pi / 0.4, 2.0 * pi / 0.6}).value() == Approx(1.2));
  CHECK(common_period_of({1.0, 2.0, 5.0}).value() == Approx(2.0 * pi));
  CHECK_FALSE(common_period_of({1.0, std::sqrt(2.0)}).has_value());
  CHECK_FALSE(common_period_of({}).has_value());
}

TEST_CASE("what repeats, what ends, and how fast it changes") {
  const DriverTiming sum = timing_of(HarmonicDriver{0.0, 1.0, 3.0, 0.0, {{0.1, 21.0, 0.0}}}, false);
  CHECK(sum.repeats);
  CHECK(sum.omegas == std::vector<double>{3.0, 21.0});
  CHECK(sum.highest_omega == 21.0);
  CHECK(timing_of(RateDriver{0.0, -4.0}, true).omegas == std::vector<double>{4.0});
  CHECK_FALSE(timing_of(RateDriver{0.0, 4.0}, false).repeats);
  CHECK(timing_of(PolynomialDriver{{7.0}}, false).repeats);
  CHECK_FALSE(timing_of(PolynomialDriver{{7.0, 1.0}}, false).repeats);
  const DriverTiming step = timing_of(StepDriver{0.0, 1.0, 0.5, 2.5}, false);
  CHECK_FALSE(step.repeats);
  CHECK(step.end == 2.5);
}

}  // namespace driver_test
