#include "boxbeam/numerics/cubic_spline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace boxbeam {
namespace {

/// Solves a tridiagonal system by elimination without pivoting (it is diagonally dominant).
std::vector<double> solve_tridiagonal(const std::vector<double>& lower,
                                      std::vector<double> diagonal,
                                      const std::vector<double>& upper, std::vector<double> right) {
  const std::size_t n = diagonal.size();
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) right[i] -= upper[i] * right[i + 1];
    right[i] /= diagonal[i];
  }
  return right;
}

}  // namespace

CubicSpline::CubicSpline(std::vector<double> x, std::vector<double> y, SplineEnds ends)
    : x_(std::move(x)), y_(std::move(y)), ends_(ends) {
  assert(x_.size() == y_.size() && x_.size() >= (ends == SplineEnds::periodic ? 3U : 2U));
  const std::size_t n = x_.size();
  std::vector<double> step(n - 1), slope(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    step[i] = x_[i + 1] - x_[i];
    slope[i] = (y_[i + 1] - y_[i]) / step[i];
  }
  if (ends == SplineEnds::clamped) {
    // h_(i-1) M_(i-1) + 2 (h_(i-1) + h_i) M_i + h_i M_(i+1) = 6 (slope_i - slope_(i-1)), and zero
    // slope at the ends.
    std::vector<double> lower(n), diagonal(n), upper(n), right(n);
    diagonal[0] = 2.0 * step[0];
    upper[0] = step[0];
    right[0] = 6.0 * slope[0];
    for (std::size_t i = 1; i + 1 < n; ++i) {
      lower[i] = step[i - 1];
      diagonal[i] = 2.0 * (step[i - 1] + step[i]);
      upper[i] = step[i];
      right[i] = 6.0 * (slope[i] - slope[i - 1]);
    }
    lower[n - 1] = step[n - 2];
    diagonal[n - 1] = 2.0 * step[n - 2];
    right[n - 1] = -6.0 * slope[n - 2];
    bend_ = solve_tridiagonal(lower, diagonal, upper, right);
    return;
  }
  // Periodic: the corner entries by the formula of Sherman and Morrison.
  const std::size_t m = n - 1;
  std::vector<double> lower(m), diagonal(m), upper(m), right(m), corner(m);
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t before = (i + m - 1) % m;
    lower[i] = step[before];
    diagonal[i] = 2.0 * (step[before] + step[i]);
    upper[i] = step[i];
    right[i] = 6.0 * (slope[i] - slope[before]);
  }
  if (m == 2) {
    // Both neighbours of a point are the same one.
    const double off = step[0] + step[1];
    const double determinant = diagonal[0] * diagonal[1] - off * off;
    bend_ = {(right[0] * diagonal[1] - off * right[1]) / determinant,
             (right[1] * diagonal[0] - off * right[0]) / determinant};
  } else {
    const double edge = step[m - 1];
    const double gamma = -diagonal[0];
    diagonal[0] -= gamma;
    diagonal[m - 1] -= edge * edge / gamma;
    corner[0] = gamma;
    corner[m - 1] = edge;
    const std::vector<double> plain = solve_tridiagonal(lower, diagonal, upper, right);
    const std::vector<double> extra = solve_tridiagonal(lower, diagonal, upper, corner);
    const double share =
        (plain[0] + edge * plain[m - 1] / gamma) / (1.0 + extra[0] + edge * extra[m - 1] / gamma);
    bend_.resize(m);
    for (std::size_t i = 0; i < m; ++i) bend_[i] = plain[i] - share * extra[i];
  }
  bend_.push_back(bend_.front());
}

Derivatives CubicSpline::at(double x) const {
  if (ends_ == SplineEnds::periodic) {
    const double period = x_.back() - x_.front();
    x -= period * std::floor((x - x_.front()) / period);
  } else if (x <= x_.front()) {
    return {y_.front(), 0.0, x == x_.front() ? bend_.front() : 0.0};
  } else if (x >= x_.back()) {
    return {y_.back(), 0.0, x == x_.back() ? bend_.back() : 0.0};
  }
  const auto behind = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(behind - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i];
  const double u = (x - x_[i]) / h;
  const double w = 1.0 - u;
  const double second = w * bend_[i] + u * bend_[i + 1];
  const double first =
      (y_[i + 1] - y_[i]) / h +
      h / 6.0 * ((3.0 * u * u - 1.0) * bend_[i + 1] - (3.0 * w * w - 1.0) * bend_[i]);
  const double value = w * y_[i] + u * y_[i + 1] +
                       h * h / 6.0 * ((w * w * w - w) * bend_[i] + (u * u * u - u) * bend_[i + 1]);
  return {value, first, second};
}

}  // namespace boxbeam
