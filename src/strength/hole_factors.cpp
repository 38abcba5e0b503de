#include "boxbeam/strength/hole_factors.hpp"

#include <cassert>

#include "hole_formulas.hpp"

namespace boxbeam {

double membrane_concentration(double diameter_to_width) {
  constexpr NoDerivation plainly;
  return hole::membrane_concentration(plainly, diameter_to_width);
}

double published_concentration(double diameter_to_width) {
  constexpr NoDerivation plainly;
  return hole::published_concentration(plainly, diameter_to_width);
}

std::optional<InPlaneBendingStress> in_plane_bending_stress(Moment moment, Length depth,
                                                            Length thickness, Length diameter) {
  const double a = diameter / depth;
  if (!(a > 0.0 && a <= 0.7)) return std::nullopt;
  const auto t_D3_d3 = thickness * (depth * depth * depth - diameter * diameter * diameter);
  return InPlaneBendingStress{12.0 * moment * diameter / t_D3_d3, 6.0 * moment * depth / t_D3_d3};
}

std::optional<double> plate_bending_concentration(double diameter_to_thickness,
                                                  double diameter_to_width) {
  const double k = diameter_to_thickness;
  const double a = diameter_to_width;
  if (!(k >= 0.0 && a >= 0.0 && a < 0.3)) return std::nullopt;
  constexpr NoDerivation plainly;
  return hole::plate_bending_concentration(plainly, k, a);
}

}  // namespace boxbeam
