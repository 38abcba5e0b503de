// Where samples of a load must not be compared across a jump or a kink.

#include "boxbeam/mechanism/common/rough_times.hpp"

#include "catch.hpp"

namespace rough_times_test {

using namespace boxbeam;

namespace {

Driver table(Interpolation interpolation, Beyond beyond) {
  return TableDriver{
      TableCurve({0.0, 0.25, 0.5, 1.0}, {0.0, 1.0, 1.0, 0.0}, interpolation, beyond)};
}

DriverUse joint(const Driver& driver) { return {&driver, false, DriverUse::On::joint, "joint"}; }

}  // namespace

TEST_CASE("samples on both sides of a kink are not of one piece, those beside it are") {
  const Driver lines = table(Interpolation::linear, Beyond::hold);
  const RoughTimes times({joint(lines)}, 0.0, 1.0, false);
  CHECK(times.between(0.2, 0.3));
  CHECK(times.between(0.1, 0.9));
  CHECK_FALSE(times.between(0.26, 0.49));
  // A kink at the end of the samples leaves them on one line.
  CHECK_FALSE(times.between(0.25, 0.5));
  CHECK_FALSE(times.between(0.1, 0.25));
}

TEST_CASE("at a jump the sample belongs to what is behind it") {
  const Driver steps = table(Interpolation::step, Beyond::hold);
  const RoughTimes times({joint(steps)}, 0.0, 1.0, false);
  CHECK(times.between(0.1, 0.25));
  CHECK_FALSE(times.between(0.25, 0.49));
}

TEST_CASE("a closed motion goes on over its end, and smooth functions have no rough times") {
  const Driver lines = table(Interpolation::linear, Beyond::periodic);
  const RoughTimes closed({joint(lines)}, 0.0, 1.0, true);
  CHECK(closed.between(0.9, 1.1));
  CHECK(closed.between(-0.1, 0.1));
  CHECK_FALSE(closed.between(1.01, 1.24));
  const Driver spline = table(Interpolation::cubic, Beyond::periodic);
  const Driver step = StepDriver{0.0, 1.0, 0.2, 0.6};
  CHECK_FALSE(RoughTimes({joint(spline), joint(step)}, 0.0, 1.0, true).between(-1.0, 2.0));
}

}  // namespace rough_times_test
