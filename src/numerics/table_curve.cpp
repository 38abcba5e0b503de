#include "boxbeam/numerics/table_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace boxbeam {
namespace {

/// Slope at a point between two chords of lengths `before`, `behind` and slopes `s`, `t`. Fritsch
/// and Butland (1984), with the weights of Brodlie.
double monotone_slope(double before, double behind, double s, double t) {
  if (!(s * t > 0.0)) return 0.0;
  const double w1 = 2.0 * behind + before;
  const double w2 = behind + 2.0 * before;
  return (w1 + w2) / (w1 / s + w2 / t);
}

std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y,
                                    bool periodic) {
  const std::size_t n = x.size();
  const auto chord = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  std::vector<double> slope(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    slope[i] = monotone_slope(x[i] - x[i - 1], x[i + 1] - x[i], chord(i - 1), chord(i));
  }
  if (periodic) {
    slope[0] = monotone_slope(x[n - 1] - x[n - 2], x[1] - x[0], chord(n - 2), chord(0));
    slope[n - 1] = slope[0];
  }
  return slope;
}

/// The cubic with values a, b and slopes s, t at the ends of a step h, at the share u of it.
/// Source: Hermite's basis, de Boor, A Practical Guide to Splines (1978), chapter IV.
Derivatives hermite(double a, double b, double s, double t, double h, double u) {
  const double chord = (b - a) / h;
  const double c2 = (3.0 * chord - 2.0 * s - t) / h;
  const double c3 = (s + t - 2.0 * chord) / (h * h);
  const double d = u * h;
  return {a + d * (s + d * (c2 + d * c3)), s + d * (2.0 * c2 + 3.0 * d * c3),
          2.0 * c2 + 6.0 * d * c3};
}

/// What rounding may have moved a place by, over the length of a table or the place's own size.
double rounding_at(double x, double length) { return 4e-15 * std::max(std::abs(x), length); }

}  // namespace

TableCurve::TableCurve(std::vector<double> x, std::vector<double> y, Interpolation interpolation,
                       Beyond beyond)
    : x_(std::move(x)), y_(std::move(y)), interpolation_(interpolation), beyond_(beyond) {
  assert(x_.size() == y_.size() && x_.size() >= 3);
  const bool periodic = beyond == Beyond::periodic;
  if (interpolation == Interpolation::cubic)
    spline_.emplace(x_, y_, periodic ? SplineEnds::periodic : SplineEnds::clamped);
  if (interpolation == Interpolation::pchip) slope_ = monotone_slopes(x_, y_, periodic);
}

Derivatives TableCurve::at(double x) const {
  // Twice continuously differentiable, also over its ends: nothing depends on the side.
  if (spline_) return spline_->at(x);
  const double length = x_.back() - x_.front();
  const double rounding = rounding_at(x, length);
  if (beyond_ == Beyond::periodic) {
    x -= length * std::floor((x - x_.front()) / length);
    if (x >= x_.back() - rounding) x = x_.front();
  }
  if (x < x_.front() - rounding) return {y_.front(), 0.0, 0.0};
  if (x >= x_.back() - rounding) return {y_.back(), 0.0, 0.0};
  const auto behind = std::upper_bound(x_.begin() + 1, x_.end() - 1, x + rounding);
  const auto i = static_cast<std::size_t>(behind - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i];
  const double u = std::clamp((x - x_[i]) / h, 0.0, 1.0);
  switch (interpolation_) {
    case Interpolation::step: return {y_[i], 0.0, 0.0};
    case Interpolation::pchip: return hermite(y_[i], y_[i + 1], slope_[i], slope_[i + 1], h, u);
    case Interpolation::linear:
    case Interpolation::cubic: break;
  }
  return {(1.0 - u) * y_[i] + u * y_[i + 1], (y_[i + 1] - y_[i]) / h, 0.0};
}

std::vector<Break> TableCurve::breaks(double from, double until) const {
  const int order = static_cast<int>(interpolation_);
  const double length = x_.back() - x_.front();
  const double slack = rounding_at(std::max(std::abs(from), std::abs(until)), length);
  std::vector<Break> breaks;
  const auto take = [&](double at) {
    if (at < from - slack || at > until + slack) return;
    // The seam of two periods is one place.
    if (!breaks.empty() && at - breaks.back().at <= slack) return;
    breaks.push_back({std::clamp(at, from, until), order});
  };
  if (beyond_ != Beyond::periodic) {
    std::for_each(x_.begin(), x_.end(), take);
    return breaks;
  }
  const double first = std::floor((from - x_.front()) / length);
  const double last = std::floor((until - x_.front()) / length);
  const auto periods = static_cast<std::size_t>(std::max(0.0, last - first + 1.0));
  for (std::size_t k = 0; k < periods; ++k) {
    const double shift = (first + static_cast<double>(k)) * length;
    for (const double at : x_) take(at + shift);
  }
  return breaks;
}

Overshoot TableCurve::overshoot() const {
  Overshoot worst;
  if (!spline_) return worst;
  const auto [least, most] = std::minmax_element(y_.begin(), y_.end());
  const auto look = [&](double x, double low, double high) {
    const double value = spline_->at(x).value;
    const double beyond = std::max(value - high, low - value);
    if (beyond > worst.beyond) worst = {beyond, x, 0.0};
  };
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    const auto [low, high] = std::minmax(y_[i], y_[i + 1]);
    // The slope is a parabola in the piece, from its values at the ends and in the middle:
    // s + d (c1 + d c2); its roots are where the curve turns.
    const double h = x_[i + 1] - x_[i];
    const Derivatives begin = spline_->at(x_[i]);
    const double end_second = spline_->at(x_[i] + h).second;
    const double c2 = 0.5 * (end_second - begin.second) / h;
    const double root = begin.second * begin.second - 4.0 * c2 * begin.first;
    if (root < 0.0) continue;
    // Without cancellation: q/c2 and s/q.
    const double q = -0.5 * (begin.second + std::copysign(std::sqrt(root), begin.second));
    for (const double d : {q != 0.0 ? begin.first / q : 0.0, c2 != 0.0 ? q / c2 : 0.0}) {
      if (d > 0.0 && d < h) look(x_[i] + d, low, high);
    }
  }
  if (*most > *least) worst.share = worst.beyond / (*most - *least);
  return worst;
}

}  // namespace boxbeam
