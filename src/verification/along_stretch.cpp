#include "along_stretch.hpp"

namespace boxbeam {
namespace {

/// Of three influences at -1, 0 and 1, the one of the parabola through them at u.
StressInfluence influence_between(const std::array<StressInfluence, 3>& of, double u) {
  const double a = 0.5 * u * (u - 1.0), b = (1.0 - u) * (1.0 + u), c = 0.5 * u * (u + 1.0);
  StressInfluence influence;
  for (std::size_t k = 0; k < cut_force::count; ++k) {
    influence.normal[k] = a * of[0].normal[k] + b * of[1].normal[k] + c * of[2].normal[k];
    influence.shear[k] = a * of[0].shear[k] + b * of[1].shear[k] + c * of[2].shear[k];
  }
  return influence;
}

StressInfluence exactly_at(const StressPoint& point, double part) {
  return influence_in(point, point_on_stretch(*point.stretch->field, point.stretch->wall, part));
}

}  // namespace

AlongStretch::AlongStretch(const StressPoint& point) {
  const WallStretch& wall = point.stretch->wall;
  // Of the end alone one place is enough.
  straight_ = !point.stretch->only_end && !wall.round && !wall.solid &&
              point.stretch->field->flow->at.graph.walls[wall.wall].radius == 0.0;
  if (!straight_) return;
  for (std::size_t k = 0; k < 3; ++k) three_[k] = exactly_at(point, 0.5 * static_cast<double>(k));
}

StressInfluence AlongStretch::at(const StressPoint& point, double part) const {
  return straight_ ? influence_between(three_, 2.0 * part - 1.0) : exactly_at(point, part);
}

std::vector<std::size_t> local_maxima_of(const std::vector<double>& values, bool ring) {
  std::vector<std::size_t> maxima;
  const std::size_t last = values.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const double before = k > 0 ? values[k - 1] : (ring ? values[last - 1] : -1.0);
    const double behind = k < last ? values[k + 1] : (ring ? values[1] : -1.0);
    if (values[k] >= before && values[k] >= behind) maxima.push_back(k);
  }
  return maxima;
}

}  // namespace boxbeam
