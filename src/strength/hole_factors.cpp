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

std::optional<double> plate_bending_concentration(double diameter_to_thickness,
                                                  double diameter_to_width) {
  const double k = diameter_to_thickness;
  const double a = diameter_to_width;
  if (!(k >= 0.0 && a >= 0.0 && a < 0.3)) return std::nullopt;
  constexpr NoDerivation plainly;
  return hole::plate_bending_concentration(plainly, k, a);
}

}  // namespace boxbeam
