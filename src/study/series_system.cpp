#include "boxbeam/study/series_system.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "boxbeam/study/distribution.hpp"

namespace boxbeam {

double both_below(double a, double b, double rho) {
  const double p_a = normal_share_below(-a), p_b = normal_share_below(-b);
  constexpr double one = 1.0 - 1e-14;
  if (rho >= one) return std::min(p_a, p_b);
  if (rho <= -one) return std::max(0.0, p_a + p_b - 1.0);
  const auto density = [&](double angle) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    return std::exp(-0.5 * (a * a - 2.0 * sine * a * b + b * b) / (cosine * cosine));
  };
  // In pieces that end in the same place: the density is a peak where the variables are nearly one.
  const double end = std::asin(rho);
  double sum = 0.0, from = 0.0;
  for (const double share : {0.5, 0.8, 0.93, 0.98, 1.0}) {
    sum += boost::math::quadrature::gauss<double, 30>::integrate(density, from, share * end);
    from = share * end;
  }
  return std::clamp(p_a * p_b + sum / (2.0 * std::numbers::pi), 0.0, std::min(p_a, p_b));
}

Bounds probability_of_any(std::vector<HalfSpace> of) {
  std::sort(of.begin(), of.end(),
            [](const HalfSpace& a, const HalfSpace& b) { return a.beta < b.beta; });
  Bounds bounds;
  for (std::size_t i = 0; i < of.size(); ++i) {
    const double alone = normal_share_below(-of[i].beta);
    double all = 0.0, most = 0.0;
    for (std::size_t j = 0; j < i; ++j) {
      const double both = both_below(of[i].beta, of[j].beta, of[i].alpha.dot(of[j].alpha));
      all += both;
      most = std::max(most, both);
    }
    bounds.low += std::max(0.0, alone - all);
    bounds.high += alone - most;
  }
  bounds.high = std::min(1.0, bounds.high);
  return bounds;
}

}  // namespace boxbeam
