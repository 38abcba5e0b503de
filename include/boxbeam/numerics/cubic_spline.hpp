#pragma once

#include <vector>

namespace boxbeam {

/// Value and first two derivatives of a function of one variable.
struct Derivatives {
  double value = 0.0;
  double first = 0.0;
  double second = 0.0;
};

/// How a spline ends. `clamped`: first derivative zero at both ends (a movement from rest to rest);
/// `periodic`: the last value is the first and all derivatives go on.
enum class SplineEnds { clamped, periodic };

/// Twice continuously differentiable piecewise cubic through given points.
/// Source: de Boor, A Practical Guide to Splines (1978), chapter IV.
class CubicSpline {
 public:
  CubicSpline() = default;
  /// `x` strictly ascending, at least two points (periodic: three, and y.front() == y.back()).
  CubicSpline(std::vector<double> x, std::vector<double> y, SplineEnds ends);

  /// At `x` inside the points; outside a clamped spline keeps its end values, a periodic one goes
  /// on.
  Derivatives at(double x) const;

  double first_x() const { return x_.front(); }
  double last_x() const { return x_.back(); }
  SplineEnds ends() const { return ends_; }
  const std::vector<double>& points() const { return x_; }

 private:
  std::vector<double> x_, y_;
  std::vector<double> bend_;  ///< second derivative at the points
  SplineEnds ends_ = SplineEnds::clamped;
};

}  // namespace boxbeam
