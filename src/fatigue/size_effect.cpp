#include "boxbeam/fatigue/size_effect.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

/// (reference/size)^exponent, 1 for sizes up to the reference.
double falling_factor(Length reference, Length size, double exponent) {
  return std::pow(std::min(1.0, static_cast<double>(reference / size)), exponent);
}

}  // namespace

double size_factor_of_butt_weld(Length thickness) {
  return falling_factor(si<Length>(0.025), thickness, 0.2);
}

double size_factor_of_eccentric_butt_weld(Length thinner, Length thicker, Length eccentricity) {
  const double ratio = thicker / thinner;
  const double share = 1.0 / (1.0 + std::pow(ratio, 1.5));
  const double bending = 6.0 * static_cast<double>(eccentricity / thinner) * share;
  return size_factor_of_butt_weld(thinner) / (1.0 + bending);
}

double size_factor_of_bolt(Length diameter) {
  return falling_factor(si<Length>(0.030), diameter, 0.25);
}

}  // namespace boxbeam
