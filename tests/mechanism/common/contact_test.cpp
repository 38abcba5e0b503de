// The law of an impact, against its first integral, closed forms and an integration of its own.

#include "boxbeam/mechanism/common/contact.hpp"

#include <cmath>

#include "catch.hpp"

namespace contact_test {

using namespace boxbeam;

namespace {

constexpr double m = 2.0, k = 5e6;

LineLaw stop_of(double exponent, double restitution) {
  return {k, 0.3, 0.0, Acts::pushing, Impact{exponent, restitution}};
}

/// The velocity with which a free mass comes out of a stop that it meets with v, by Runge and
/// Kutta's method of order 4 with steps of one size, on the depth and its rate.
double after_impact(const LineLaw& law, double v) {
  const Touch touch = touched(law, v, m);
  const auto change = [&](double d, double rate) {
    return tension_of(law, law.free_length - d, -rate, touch) / m;
  };
  double d = 0.0, rate = v;
  const double h = 1e-4 * std::sqrt(m / k);
  while (true) {
    const double d1 = rate, r1 = change(d, rate);
    const double d2 = rate + 0.5 * h * r1, r2 = change(d + 0.5 * h * d1, d2);
    const double d3 = rate + 0.5 * h * r2, r3 = change(d + 0.5 * h * d2, d3);
    const double d4 = rate + h * r3, r4 = change(d + h * d3, d4);
    const double next = d + h / 6.0 * (d1 + 2.0 * d2 + 2.0 * d3 + d4);
    const double next_rate = rate + h / 6.0 * (r1 + 2.0 * r2 + 2.0 * r3 + r4);
    // Out of it there is no force: the last step hardly changes the rate.
    if (next <= 0.0) return rate;
    d = next;
    rate = next_rate;
  }
}

}  // namespace

TEST_CASE("what an impact loses solves its first integral") {
  for (const double e : {0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999}) {
    CAPTURE(e);
    const double x = hysteresis_of(e);
    CHECK(x > 0.0);
    CHECK(x < 1.0 / e);
    // As numbers of more digits see it, for at 0.05 only 1.6e-8 is left of 1 - e x.
    const long double exact = x, of = e;
    const long double open = exact * (1.0L + of) - std::log1p(exact) + std::log1p(-of * exact);
    // Its slope there: what an error of x by a rounding changes.
    const long double slope = (1.0L + of) - 1.0L / (1.0L + exact) - of / (1.0L - of * exact);
    CHECK(std::abs(open) < 1e-14L * std::max(1.0L, std::abs(slope * exact)));
  }
  CHECK(hysteresis_of(1.0) == 0.0);
  // To first order in 1 - e, on both sides of where that is used.
  CHECK(hysteresis_of(1.0 - 1e-6) == Approx(1.5e-6).epsilon(1e-5));
  CHECK(hysteresis_of(1.0 - 2e-5) == Approx(3e-5).epsilon(1e-4));
}

TEST_CASE("a free impact ends with its restitution, whatever exponent and velocity it has") {
  for (const double exponent : {1.0, 1.5}) {
    for (const double e : {0.1, 0.5, 0.9, 1.0}) {
      for (const double v : {0.02, 3.0}) {
        CAPTURE(exponent, e, v);
        CHECK(after_impact(stop_of(exponent, e), v) == Approx(-e * v).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("a stop only pushes and a cable only pulls") {
  const LineLaw stop = stop_of(1.5, 0.4);
  const Touch touch = touched(stop, 1.0, 1e9);
  CHECK(tension_of(stop, 0.2, -0.5, {}) == 0.0);
  CHECK(tension_of(stop, 0.2, 0.0, touch) == Approx(-k * std::pow(0.1, 1.5)).epsilon(1e-14));
  CHECK(tension_of(stop, 0.2, -0.5, touch) < tension_of(stop, 0.2, 0.0, touch));
  // Drawn out faster than it follows.
  CHECK(tension_of(stop, 0.2, 100.0, touch) == 0.0);
  const LineLaw cable{k, 0.3, 1e3, Acts::pulling};
  CHECK(tension_of(cable, 0.4, 2.0, {true, 0.0}) == Approx(0.1 * k + 2e3).epsilon(1e-14));
  CHECK(tension_of(cable, 0.4, -1e3, {true, 0.0}) == 0.0);
  CHECK(tension_of(cable, 0.2, 2.0, {false, 0.0}) == 0.0);
  // A damper that only pushes has no length to begin at.
  const LineLaw damper{0.0, 0.0, 1e3, Acts::pushing};
  CHECK(!begins_at_length(damper));
  CHECK(tension_of(damper, 0.5, -2.0, {}) == Approx(-2e3).epsilon(1e-14));
  CHECK(tension_of(damper, 0.5, 2.0, {}) == 0.0);
}

TEST_CASE("beyond the depth of its impact a contact is damped by that depth's force") {
  constexpr double v = 2.0;
  const LineLaw stop = stop_of(1.0, 0.5);
  const Touch touch = touched(stop, v, m);
  // m v^2/2 = k d^2/2 without loss.
  const double depth = v * std::sqrt(m / k);
  CHECK(touch.depth == Approx(depth).epsilon(1e-14));
  const auto damping_at = [&](double d) {
    return (tension_of(stop, 0.3 - d, 0.0, touch) - tension_of(stop, 0.3 - d, -1e-3, touch)) / 1e-3;
  };
  CHECK(damping_at(0.5 * depth) == Approx(0.5 * k * depth * touch.loss).epsilon(1e-9));
  CHECK(damping_at(depth) == Approx(k * depth * touch.loss).epsilon(1e-9));
  CHECK(damping_at(3.0 * depth) == Approx(k * depth * touch.loss).epsilon(1e-9));
  // Whatever it meets it with: of a linear contact x sqrt(k m).
  CHECK(k * touched(stop, 0.01, m).depth * touched(stop, 0.01, m).loss ==
        Approx(hysteresis_of(0.5) * std::sqrt(k * m)).epsilon(1e-12));
}

TEST_CASE("what is laid down slowly is damped as if it were not") {
  const LineLaw stop = stop_of(1.0, 0.5);
  const double x = hysteresis_of(0.5);
  CHECK(touched(stop, 0.0, m).loss == Approx(x / slowest_approach).epsilon(1e-14));
  CHECK(touched(stop, 2.0, m).loss == Approx(0.5 * x).epsilon(1e-14));
}

}  // namespace contact_test
