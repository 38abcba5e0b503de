// Curves through the points of a table against hand calculation, their smoothness and their bounds.

#include "boxbeam/numerics/table_curve.hpp"

#include <cmath>

#include "catch.hpp"

namespace table_curve_test {

using namespace boxbeam;

namespace {

const std::vector<double> trapezoid_times{0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
const std::vector<double> trapezoid{0.0, 0.0, 20.0, 20.0, 0.0, 0.0};

TableCurve curve(Interpolation interpolation, Beyond beyond = Beyond::hold) {
  return {trapezoid_times, trapezoid, interpolation, beyond};
}

}  // namespace

TEST_CASE("a spline overshoots a trapezoid, other curves never leave their points") {
  // By hand: the clamped spline's second derivatives are -240/11, 480/11, -360/11 and their mirror
  // (2 M0 + M1 = 0, M0 + 4 M1 + M2 = 120, M1 + 5 M2 = -120), so that the middle of the flat top is
  // 360/11/8 = 45/11 above it.
  const TableCurve spline = curve(Interpolation::cubic);
  CHECK(spline.at(2.5).value == Approx(20.0 + 45.0 / 11.0).epsilon(1e-13));
  const Overshoot overshoot = spline.overshoot();
  CHECK(overshoot.beyond == Approx(45.0 / 11.0).epsilon(1e-12));
  CHECK(overshoot.share == Approx(45.0 / 220.0).epsilon(1e-12));
  CHECK(overshoot.at == Approx(2.5).epsilon(1e-12));
  for (const Interpolation kind :
       {Interpolation::step, Interpolation::linear, Interpolation::pchip}) {
    const TableCurve other = curve(kind);
    CHECK(other.overshoot().beyond == 0.0);
    for (int i = 0; i <= 5000; ++i) {
      const double value = other.at(0.001 * i).value;
      CHECK(value >= 0.0);
      CHECK(value <= 20.0);
    }
    for (std::size_t i = 0; i < trapezoid.size(); ++i) {
      CHECK(other.at(trapezoid_times[i]).value == trapezoid[i]);
    }
  }
}

TEST_CASE("straight lines between points, and steps that hold a value until the next one") {
  const TableCurve lines = curve(Interpolation::linear);
  CHECK(lines.at(1.25).value == Approx(5.0));
  CHECK(lines.at(1.25).first == Approx(20.0));
  CHECK(lines.at(3.75).value == Approx(5.0));
  // At a point, the slope behind it.
  CHECK(lines.at(2.0).first == 0.0);
  const TableCurve steps = curve(Interpolation::step);
  CHECK(steps.at(1.999).value == 0.0);
  CHECK(steps.at(2.0).value == 20.0);
  CHECK(steps.at(3.999).value == 20.0);
  CHECK(steps.at(4.0).value == 0.0);
}

TEST_CASE("monotone cubics by Fritsch and Butland") {
  // By hand, unequal steps: chords 1 and 1/4 with steps 1 and 2 give w1 = 5, w2 = 4 and the slope
  // 9/(5/1 + 4/(1/4)) = 3/7; before a chord that falls the slope is zero.
  const TableCurve hill({0.0, 1.0, 3.0, 4.0}, {0.0, 1.0, 1.5, 1.0}, Interpolation::pchip,
                        Beyond::hold);
  CHECK(hill.at(1.0).first == Approx(3.0 / 7.0).epsilon(1e-14));
  CHECK(hill.at(3.0).first == Approx(0.0).margin(1e-14));
  // The middle of a Hermite cubic: mean of the values + h/8 (s - t).
  CHECK(hill.at(2.0).value == Approx(1.25 + 2.0 / 8.0 * 3.0 / 7.0).epsilon(1e-14));
  // Monotone between any two points, its slope continuous.
  double before = hill.at(0.0).value;
  for (int i = 1; i <= 3000; ++i) {
    const double value = hill.at(0.001 * i).value;
    CHECK(value >= before - 1e-15);
    before = value;
  }
  for (const double x : {1.0, 3.0}) {
    CHECK(hill.at(x - 1e-9).first == Approx(hill.at(x).first).margin(1e-7));
  }
  // Derivatives by central differences.
  for (const double x : {0.3, 1.7, 3.4}) {
    const double h = 1e-5;
    CHECK(hill.at(x).first ==
          Approx((hill.at(x + h).value - hill.at(x - h).value) / (2.0 * h)).margin(1e-9));
    CHECK(hill.at(x).second ==
          Approx((hill.at(x + h).first - hill.at(x - h).first) / (2.0 * h)).margin(1e-7));
  }
}

TEST_CASE("beyond its ends a table keeps its values or begins anew") {
  for (const Interpolation kind :
       {Interpolation::step, Interpolation::linear, Interpolation::pchip, Interpolation::cubic}) {
    const TableCurve held({0.0, 1.0, 2.0}, {1.0, 5.0, 3.0}, kind, Beyond::hold);
    CHECK(held.at(-7.0).value == 1.0);
    CHECK(held.at(9.0).value == 3.0);
    CHECK(held.at(9.0).first == 0.0);
    const TableCurve again({0.0, 1.0, 2.0}, {1.0, 5.0, 1.0}, kind, Beyond::periodic);
    for (const double x : {0.0, 0.37, 1.0, 1.9}) {
      CHECK(again.at(x + 6.0).value == Approx(again.at(x).value).epsilon(1e-14));
      CHECK(again.at(x - 4.0).value == Approx(again.at(x).value).epsilon(1e-14));
    }
  }
  // A periodic monotone curve is smooth over its seam: chords 2 and 1 of equal steps, slope 4/3.
  const TableCurve ramp({0.0, 1.0, 2.0, 3.0}, {0.0, 1.0, -2.0, 0.0}, Interpolation::pchip,
                        Beyond::periodic);
  CHECK(ramp.at(3.0).first == Approx(4.0 / 3.0).epsilon(1e-14));
  CHECK(ramp.at(3.0 - 1e-9).first == Approx(4.0 / 3.0).margin(1e-7));
}

TEST_CASE("where a curve is not smooth, and what jumps there") {
  const TableCurve held({0.0, 0.1, 0.3}, {0.0, 2.0, 0.0}, Interpolation::linear, Beyond::hold);
  CHECK(held.breaks(0.05, 1.0) == std::vector<Break>{{0.1, 1}, {0.3, 1}});
  const TableCurve steps({0.0, 0.1, 0.3}, {0.0, 2.0, 0.0}, Interpolation::step, Beyond::periodic);
  const std::vector<Break> breaks = steps.breaks(0.2, 1.0);
  // 0.3, 0.4, 0.6, 0.7, 0.9, 1.0: the seam of two periods is one place.
  const double expected[] = {0.3, 0.4, 0.6, 0.7, 0.9, 1.0};
  REQUIRE(breaks.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(breaks[i].at == Approx(expected[i]).epsilon(1e-14));
    CHECK(breaks[i].order == 0);
    // The value behind a jump, however the time was rounded; the one before it a little earlier.
    const bool high = i % 2 == 1;
    CHECK(steps.at(breaks[i].at).value == (high ? 2.0 : 0.0));
    CHECK(steps.at(breaks[i].at - 1e-9).value == (i % 2 == 1 ? 0.0 : 2.0));
  }
  CHECK(curve(Interpolation::pchip).breaks(0.0, 5.0).front().order == 2);
  CHECK(curve(Interpolation::cubic).breaks(0.0, 5.0).front().order == 3);
}

}  // namespace table_curve_test
