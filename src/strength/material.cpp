#include "boxbeam/strength/material.hpp"

namespace boxbeam {

std::optional<Stress> yield_strength_of(const Material& material, Length thickness) {
  // A thickness typed in millimetres may stand a bit of round-off above the step it names.
  const Length slack = 1e-12 * metre;
  for (const ThicknessStep& step : material.yield) {
    if (thickness <= step.up_to + slack) return step.yield_strength;
  }
  return std::nullopt;
}

}  // namespace boxbeam
