#include "boxbeam/strength/material.hpp"

#include <algorithm>
#include <limits>

namespace boxbeam {
namespace {

const ThicknessStep* step_of(const Material& material, Length thickness) {
  // A thickness typed in millimetres may stand a bit of round-off above the step it names.
  const Length slack = 1e-12 * metre;
  for (const ThicknessStep& step : material.steps) {
    if (thickness <= step.up_to + slack) return &step;
  }
  return nullptr;
}

}  // namespace

std::optional<Stress> yield_strength_of(const Material& material, Length thickness) {
  const ThicknessStep* step = step_of(material, thickness);
  if (step == nullptr) return std::nullopt;
  return step->yield_strength;
}

std::optional<Stress> tensile_strength_of(const Material& material, Length thickness) {
  const ThicknessStep* step = step_of(material, thickness);
  if (step == nullptr) return std::nullopt;
  return step->tensile_strength;
}

Material steel_of(Stress yield_strength) {
  Material material;
  material.steps = {{si<Length>(std::numeric_limits<double>::max()), yield_strength, {}}};
  return material;
}

Material lower_of(const Material& one, const Material& other) {
  std::vector<Length> ends;
  for (const Material* material : {&one, &other}) {
    for (const ThicknessStep& step : material->steps) ends.push_back(step.up_to);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  Material lower{one.name,
                 "the lower of " + one.source + ", and " + other.source,
                 std::max(one.beta_w, other.beta_w),
                 {}};
  for (const Length& end : ends) {
    const ThicknessStep* a = step_of(one, end);
    const ThicknessStep* b = step_of(other, end);
    if (a == nullptr) a = b;
    if (b == nullptr) b = a;
    lower.steps.push_back({end, std::min(a->yield_strength, b->yield_strength),
                           std::min(a->tensile_strength, b->tensile_strength)});
  }
  return lower;
}

}  // namespace boxbeam
