#include "boxbeam/mechanism/common/contact.hpp"

#include <cassert>
#include <cmath>

namespace boxbeam {

double hysteresis_of(double restitution) {
  const double e = restitution;
  assert(e >= least_restitution && e <= 1.0);
  // Where the logarithms leave no digits: x = 3 (1 - e)/2 to first order in what is lost.
  if (1.0 - e < 1e-5) return 1.5 * (1.0 - e);
  // By u = -ln(1 - e x), which has all digits of small x and of x close to 1/e. The function is
  // zero at u = 0 as well, below zero between its zeros and convex beyond the second.
  const auto x_of = [&](double u) { return -std::expm1(-u) / e; };
  const auto open = [&](double u) {
    const double x = x_of(u);
    return u + std::log1p(x) - x * (1.0 + e);
  };
  double high = 1.0;
  while (open(high) < 0.0) high *= 2.0;
  double low = 0.25 * (1.0 - e) * e;
  while (open(low) > 0.0) low *= 0.5;
  for (int i = 0; i < 200 && high - low > 1e-16 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (open(middle) < 0.0 ? low : high) = middle;
  }
  return x_of(0.5 * (low + high));
}

Touch touched(const LineLaw& law, double approach, double mass) {
  if (!law.impact) return {true};
  const double v = std::max(approach, slowest_approach), n = law.impact->exponent;
  const double depth = std::pow(0.5 * (n + 1.0) * mass * v * v / law.stiffness, 1.0 / (n + 1.0));
  return {true, hysteresis_of(law.impact->restitution) / v, depth};
}

double tension_of(const LineLaw& law, double length, double rate, const Touch& touch) {
  if (law.acts == Acts::both)
    return law.stiffness * (length - law.free_length) + law.damping * rate;
  if (begins_at_length(law) && !touch.on) return 0.0;
  const double d = inward(law, length - law.free_length);
  const double d_rate = inward(law, rate);
  if (!law.impact) return inward(law, std::max(0.0, law.stiffness * d + law.damping * d_rate));
  // A touch lasts until d has gone below zero, by round-off: there it goes on smoothly.
  const double n = law.impact->exponent;
  const auto force_at = [&](double depth) {
    return law.stiffness * (n == 1.0 ? depth : std::copysign(std::pow(std::abs(depth), n), depth));
  };
  const double force = force_at(d) + force_at(std::min(d, touch.depth)) * touch.loss * d_rate;
  return inward(law, (d > 0.0 ? std::max(0.0, force) : force) + touch.push);
}

double stiffness_at(const LineLaw& law, double length) {
  const double n = law.impact ? law.impact->exponent : 1.0;
  if (n == 1.0) return law.stiffness;
  return n * law.stiffness *
         std::pow(std::max(0.0, inward(law, length - law.free_length)), n - 1.0);
}

}  // namespace boxbeam
