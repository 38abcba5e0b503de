#include "fitted_order.hpp"

#include <cmath>

namespace boxbeam::study {

double fitted_order(const Series& series, double floor) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& point : series.points) {
    if (!point.failure.empty() || !(point.parameter > 0.0) || !(point.error > floor)) continue;
    const double a = std::log(point.parameter), b = std::log(point.error);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const double spread = n * xx - x * x;
  return spread > 0.0 ? -(n * xy - x * y) / spread : 0.0;
}

}  // namespace boxbeam::study
