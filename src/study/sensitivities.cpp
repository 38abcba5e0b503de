#include "boxbeam/study/sensitivities.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

constexpr double h = 0.005;

/// d(ln f)/d(ln x) from three values at equal steps of x from its own, of second order, towards the
/// side of `sign`.
double one_sided(double f, double near, double far, double sign) {
  return sign * (-3.0 * f + 4.0 * near - far) / (2.0 * h * f);
}

}  // namespace

double Slope::value() const {
  if (!down || !up) return down ? *down : up.value_or(0.0);
  if (!kinks()) return 0.5 * (*down + *up);
  return std::abs(*down) > std::abs(*up) ? *down : *up;
}

bool Slope::kinks() const {
  if (!down || !up) return false;
  constexpr double alike = 0.05;
  const double most = std::max(std::abs(*down), std::abs(*up));
  return std::abs(*down - *up) > std::max({10.0 * least_slope, alike * most, 4.0 * error});
}

std::map<Criterion, Slope> slopes_of(const std::map<Criterion, double>& as_it_is,
                                     const ResultsAt& results_at) {
  std::map<Criterion, Slope> slopes;
  const std::array down{results_at(1.0 - h), results_at(1.0 - 2.0 * h)};
  const std::array up{results_at(1.0 + h), results_at(1.0 + 2.0 * h)};
  for (const auto& entry : as_it_is) {
    const Criterion which = entry.first;
    const double f = entry.second;
    const auto value_in = [&](const auto& results) -> std::optional<double> {
      if (!results) return std::nullopt;
      const auto found = results->find(which);
      if (found == results->end() || !std::isfinite(found->second)) return std::nullopt;
      return found->second;
    };
    if (!std::isfinite(f) || f == 0.0) continue;
    const std::optional<double> d1 = value_in(down[0]), d2 = value_in(down[1]);
    const std::optional<double> u1 = value_in(up[0]), u2 = value_in(up[1]);
    Slope slope;
    const auto side = [&](double near, double far, double sign) {
      slope.error = std::max(slope.error,
                             std::abs(sign * (near - f) / (h * f) - one_sided(f, near, far, sign)));
      return one_sided(f, near, far, sign);
    };
    if (d1 && d2) slope.down = side(*d1, *d2, -1.0);
    if (u1 && u2) slope.up = side(*u1, *u2, 1.0);
    if (!slope.down && !slope.up) continue;
    if (slope.down && slope.up && !slope.kinks()) {
      const double coarse = (*u2 - *d2) / (4.0 * h * f), fine = (*u1 - *d1) / (2.0 * h * f);
      slope.down = slope.up = (4.0 * fine - coarse) / 3.0;
      slope.error = std::abs(fine - coarse) / 3.0;
    }
    slopes[which] = slope;
  }
  return slopes;
}

double Sensitivity::steepest() const {
  double most = 0.0;
  for (const auto& [criterion, slope] : slopes) most = std::max(most, std::abs(slope.value()));
  return most;
}

}  // namespace boxbeam
