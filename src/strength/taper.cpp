#include "boxbeam/strength/taper.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace boxbeam {

double wedge_bending_ratio(double half_angle) {
  assert(half_angle >= 0.0 && half_angle < 0.25 * std::numbers::pi);
  // Below this the difference loses its digits; the next term of the series is 1e-9 there.
  if (half_angle < 5e-3) return 1.0 - 0.2 * half_angle * half_angle;
  const double sine = std::sin(2.0 * half_angle);
  const double tangent = std::tan(half_angle);
  return 1.5 * (2.0 * half_angle - sine) / (tangent * tangent * sine);
}

}  // namespace boxbeam
