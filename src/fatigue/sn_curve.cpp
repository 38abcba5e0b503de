#include "boxbeam/fatigue/sn_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace boxbeam {
namespace {

constexpr double reference_cycles = 2e6;
constexpr double knee_cycles = 5e6;
constexpr double cut_off_cycles = 1e8;
constexpr std::array categories{160, 140, 125, 112, 100, 90, 80, 71, 63, 56, 50, 45, 40, 36};

}  // namespace

Stress knee_of(const SnCurve& curve) {
  if (curve.kind == CurveKind::published_step) return curve.category;
  return curve.category * std::cbrt(reference_cycles / knee_cycles);
}

Stress cut_off_of(const SnCurve& curve) {
  return knee_of(curve) * std::pow(knee_cycles / cut_off_cycles, 0.2);
}

Stress strength_at(const SnCurve& curve, double cycles, Loading loading) {
  const Stress knee = knee_of(curve);
  if (cycles <= knee_cycles) return knee * std::cbrt(knee_cycles / cycles);
  if (loading == Loading::constant_amplitude) return knee;
  return std::max(cut_off_of(curve), knee * std::pow(knee_cycles / cycles, 0.2));
}

double cycles_to_failure(const SnCurve& curve, Stress range, Loading loading) {
  const Stress knee = knee_of(curve);
  const double ratio = knee / range;
  if (range >= knee) return knee_cycles * ratio * ratio * ratio;
  if (loading == Loading::constant_amplitude || range < cut_off_of(curve)) {
    return std::numeric_limits<double>::infinity();
  }
  return knee_cycles * std::pow(ratio, 5);
}

bool is_direct_category(int category) {
  return std::find(categories.begin(), categories.end(), category) != categories.end();
}

std::string direct_categories() { return fmt::format("{}", fmt::join(categories, ", ")); }

}  // namespace boxbeam
