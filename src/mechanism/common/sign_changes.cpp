#include "boxbeam/mechanism/common/sign_changes.hpp"

#include <array>
#include <cmath>

namespace boxbeam {
namespace {

/// Where the cubic with these values and rates at 0 and 1 has its highest and lowest places; not a
/// number where it has none.
std::array<double, 2> extrema_of(const ValueAndRate& begin, const ValueAndRate& end) {
  // 3 b x^2 + 2 a x + c = 0
  const double rise = end.value - begin.value;
  const double a = 3.0 * rise - 2.0 * begin.rate - end.rate;
  const double b = begin.rate + end.rate - 2.0 * rise, c = begin.rate;
  const double q = -(a + std::copysign(std::sqrt(a * a - 3.0 * b * c), a));
  return {q / (3.0 * b), c / q};
}

}  // namespace

void add_sign_changes(double begin, double length, const std::function<ValueAndRate(double)>& at,
                      std::vector<double>& changes) {
  constexpr int looks = 3072, halvings = 50;
  const auto find = [&](double low, double high, bool positive) {
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      ((at(middle).value > 0.0) == positive ? low : high) = middle;
    }
    changes.push_back(high);
  };
  double from = begin;
  ValueAndRate before = at(from);
  for (int k = 1; k <= looks; ++k) {
    const double until = begin + length * k / looks, h = until - from;
    const ValueAndRate behind = at(until);
    const bool positive = before.value > 0.0;
    if ((behind.value > 0.0) != positive) {
      find(from, until, positive);
    } else {
      for (const double x :
           extrema_of({before.value, h * before.rate}, {behind.value, h * behind.rate})) {
        const double time = from + x * h;
        if (!(x > 0.0 && x < 1.0) || (at(time).value > 0.0) == positive) continue;
        find(from, time, positive);
        find(time, until, !positive);
        break;
      }
    }
    from = until;
    before = behind;
  }
}

}  // namespace boxbeam
