#include "boxbeam/study/sensitivities.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

constexpr double h = 0.005, probe_step = h / 8.0;

using FactorsAt = std::optional<std::map<Criterion, double>>;

/// Nothing where there is none or it is infinite.
std::optional<double> factor_in(const FactorsAt& results, Criterion which) {
  if (!results) return std::nullopt;
  const auto found = results->find(which);
  if (found == results->end() || !std::isfinite(found->second)) return std::nullopt;
  return found->second;
}

/// The factor of a criterion at equal steps of an input from its own value.
struct FiveFactors {
  std::optional<double> far_down, down;
  double own = 0.0;
  std::optional<double> up, far_up;

  bool all() const { return far_down && down && up && far_up; }
};

/// d(ln f)/d(ln x) from three values, of second order, towards the side of `sign`.
double one_sided(double own, double near, double far, double sign) {
  return sign * (-3.0 * own + 4.0 * near - far) / (2.0 * h * own);
}

/// Where all five lie on a smooth curve.
std::optional<Slope> smooth_slope(const FiveFactors& of) {
  if (!of.all()) return std::nullopt;
  const double d2 = *of.far_down, d1 = *of.down, f = of.own, u1 = *of.up, u2 = *of.far_up;
  // A kink by J up to 5/3 h away leaves a third of J in one of these, or more.
  const double rough =
      std::max({std::abs(u2 - 3.0 * u1 + 3.0 * f - d1), std::abs(d2 - 3.0 * d1 + 3.0 * f - u1),
                0.5 * std::abs(d2 - 4.0 * d1 + 6.0 * f - 4.0 * u1 + u2)}) /
      (h * std::abs(f));
  const double steepest =
      std::max(std::abs(one_sided(f, d1, d2, -1.0)), std::abs(one_sided(f, u1, u2, 1.0)));
  constexpr double alike = 0.05;
  if (rough > std::max(10.0 * least_slope, alike * steepest)) return std::nullopt;
  const double coarse = (u2 - d2) / (4.0 * h * f), fine = (u1 - d1) / (2.0 * h * f);
  const double slope = (4.0 * fine - coarse) / 3.0;
  const double error = std::max(std::abs(fine - coarse) / 3.0, 0.5 * rough);
  return Slope{SideSlope{slope, error}, SideSlope{slope, error}};
}

/// Of one side by itself.
SideSlope side_slope(double own, double near, double far, std::optional<double> beside_it,
                     double sign) {
  SideSlope side{one_sided(own, near, far, sign), 0.0};
  side.error = std::abs(sign * (near - own) / (h * own) - side.slope);
  // Where it is not judged so close by, nothing says what it is there.
  const double nearest = beside_it ? sign * (*beside_it - own) / (probe_step * own) : 0.0;
  side.error = std::max(side.error, std::abs(nearest - side.slope));
  return side;
}

/// The results at some factors of an input, each asked for once.
class AskedResults {
 public:
  explicit AskedResults(const ResultsAt& at) : at_(&at) {}
  const FactorsAt& operator()(double factor) {
    const auto known = asked_.find(factor);
    return known != asked_.end() ? known->second
                                 : asked_.emplace(factor, (*at_)(factor)).first->second;
  }

 private:
  const ResultsAt* at_;
  std::map<double, FactorsAt> asked_;
};

}  // namespace

SideSlope Slope::of_both() const {
  if (!down || !up) return down ? *down : up.value_or(SideSlope{});
  if (down->is_known() != up->is_known()) return down->is_known() ? *down : *up;
  return std::abs(down->slope) > std::abs(up->slope) ? *down : *up;
}

std::map<Criterion, Slope> slopes_of(const std::map<Criterion, double>& as_it_is,
                                     const ResultsAt& results_at) {
  std::map<Criterion, Slope> slopes;
  AskedResults at(results_at);
  for (const auto& [which, own] : as_it_is) {
    if (!std::isfinite(own) || own == 0.0) continue;
    const auto factor = [&, name = which](double of) { return factor_in(at(of), name); };
    const FiveFactors five{factor(1.0 - 2.0 * h), factor(1.0 - h), own, factor(1.0 + h),
                           factor(1.0 + 2.0 * h)};
    Slope slope;
    if (const std::optional<Slope> smooth = smooth_slope(five)) {
      slope = *smooth;
    } else {
      if (five.down && five.far_down)
        slope.down = side_slope(own, *five.down, *five.far_down, factor(1.0 - probe_step), -1.0);
      if (five.up && five.far_up)
        slope.up = side_slope(own, *five.up, *five.far_up, factor(1.0 + probe_step), 1.0);
    }
    if (slope.down || slope.up) slopes[which] = slope;
  }
  return slopes;
}

bool Sensitivity::has_no_effect() const {
  const auto is_nothing = [](const std::optional<SideSlope>& side) {
    return !side || (side->is_known() && std::abs(side->slope) < least_slope);
  };
  return std::all_of(slopes.begin(), slopes.end(), [&](const auto& of) {
    return is_nothing(of.second.down) && is_nothing(of.second.up);
  });
}

}  // namespace boxbeam
