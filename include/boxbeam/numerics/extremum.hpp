#pragma once

#include <boost/math/tools/minima.hpp>

#include <cstdint>

namespace boxbeam {

/// Place and value of an extremum.
struct Extremum {
  double at = 0.0;
  double value = 0.0;
};

/// The largest value of `f` between `low` and `high`, which bracket one maximum.
/// Brent's method (golden section and parabolas). The place is good to 2^-bits of the bracket, the
/// value of a smooth function to the square of that: at 22 bits to 1e-13 of its variation in the
/// bracket. Precondition: at most 26 bits, more than values in double can tell apart.
/// Source: Brent, Algorithms for Minimization without Derivatives (1973), chapter 5; Boost.Math.
template <class Function>
Extremum find_maximum(const Function& f, double low, double high, int bits = 22) {
  std::uintmax_t evaluations = 60;
  // The unknown is taken from the bracket's middle: Brent's tolerance is relative to the unknown.
  const double middle = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  const auto [x, negative] = boost::math::tools::brent_find_minima(
      [&](double u) { return -f(middle + half * u); }, -1.0, 1.0, bits, evaluations);
  return {middle + half * x, -negative};
}

}  // namespace boxbeam
