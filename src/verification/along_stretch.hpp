#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "boxbeam/verification/stress_points.hpp"

/// What is searched along stretches of wall.
namespace boxbeam {

/// The influences along the stretch of a point. On a straight wall of a cell or a path the normal
/// stress is linear and the shear flow a parabola: three places tell all.
class AlongStretch {
 public:
  explicit AlongStretch(const StressPoint& point);

  bool straight() const { return straight_; }

  /// At a part of the same point's stretch.
  StressInfluence at(const StressPoint& point, double part) const;

 private:
  bool straight_ = false;
  std::array<StressInfluence, 3> three_;
};

/// The local maxima of values on a grid, by their indices; of a ring the first and the last place
/// are one.
std::vector<std::size_t> local_maxima_of(const std::vector<double>& values, bool ring);

}  // namespace boxbeam
