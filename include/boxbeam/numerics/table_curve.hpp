#pragma once

#include <optional>
#include <vector>

#include "boxbeam/numerics/cubic_spline.hpp"

namespace boxbeam {

/// How a curve goes from one point of a table to the next.
enum class Interpolation {
  step,    ///< keeps the value of a point until the next one, and jumps there
  linear,  ///< straight: continuous, its slope jumps at the points
  pchip,   ///< monotone between two points, its slope is continuous
  cubic,   ///< spline, twice continuously differentiable; it may leave the points' range
};

/// What a table says before its first and behind its last point.
enum class Beyond {
  nothing,   ///< it may not be asked
  hold,      ///< it keeps its end values
  periodic,  ///< it begins anew; the last value is the first
};

/// A place at which a function is not smooth.
struct Break {
  double at = 0.0;
  /// The lowest derivative that jumps there: 0 the value itself, 1 the slope, ...
  int order = 0;

  friend bool operator==(const Break&, const Break&) = default;
};

/// How far a curve leaves the points it goes through: the most by which it is above the higher or
/// below the lower of two neighbours, anywhere between them.
struct Overshoot {
  double beyond = 0.0;  ///< of the value's unit
  double at = 0.0;      ///< where
  double share = 0.0;   ///< of the range of all points
};

/// A function through the points of a table.
///
/// pchip: cubic pieces whose slope at an inner point is zero where the chords beside it change sign
/// and else the weighted harmonic mean of their slopes,
///
///     d = (w1 + w2)/(w1/s_before + w2/s_behind),  w1 = 2 h_behind + h_before, w2 = h_behind + 2
///     h_before
///
/// which makes the piece monotone, so that it never leaves its two points; at the ends of a table
/// that does not repeat the slope is zero, as of the spline (a movement from rest to rest).
/// Source: Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984); the bound 0 <= d <= 3 min(s)
/// of Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980).
class TableCurve {
 public:
  TableCurve() = default;
  /// `x` strictly ascending, at least three points; periodic: y.front() == y.back().
  TableCurve(std::vector<double> x, std::vector<double> y, Interpolation interpolation,
             Beyond beyond);

  /// Value and derivatives. At a point those behind it (a jump has the value behind); a place that
  /// rounding may have put in front of a point counts as the point.
  Derivatives at(double x) const;

  Interpolation interpolation() const { return interpolation_; }
  Beyond beyond() const { return beyond_; }
  const std::vector<double>& points() const { return x_; }
  const std::vector<double>& values() const { return y_; }
  double first_x() const { return x_.front(); }
  double last_x() const { return x_.back(); }

  /// The points between `from` and `until`, both included, in every period; ascending.
  std::vector<Break> breaks(double from, double until) const;

  /// Zero of anything but a spline.
  Overshoot overshoot() const;

 private:
  std::vector<double> x_, y_;
  std::vector<double> slope_;  ///< at the points, of pchip
  std::optional<CubicSpline> spline_;
  Interpolation interpolation_ = Interpolation::linear;
  Beyond beyond_ = Beyond::nothing;
};

}  // namespace boxbeam
