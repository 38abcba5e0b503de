#include "boxbeam/strength/transverse_stiffener.hpp"

#include <cmath>
#include <numbers>

namespace boxbeam {

SecondMoment rigid_stiffener_inertia(Length depth, Length thickness, Length length) {
  const double h_w = depth.value(), t = thickness.value(), a = length.value();
  return si<SecondMoment>(a < std::numbers::sqrt2 * h_w ? 1.5 * std::pow(h_w * t, 3) / (a * a)
                                                        : 0.75 * h_w * std::pow(t, 3));
}

SecondMoment stiffener_inertia(Length web_thickness, Length width, Length thickness,
                               bool both_sides) {
  const double half = 0.5 * web_thickness.value(), b = width.value();
  const double one = thickness.value() * (std::pow(half + b, 3) - std::pow(half, 3)) / 3.0;
  return si<SecondMoment>(both_sides ? 2.0 * one : one);
}

}  // namespace boxbeam
