#include "boxbeam/fatigue/hot_spot.hpp"

namespace boxbeam {

Stress hot_spot_stress_of(const SurfaceStress& surface) {
  constexpr double first = 0.4, second = 1.0;
  return surface.near + first / (second - first) * (surface.near - surface.far);
}

}  // namespace boxbeam
