#pragma once

#include <cmath>

#include "boxbeam/core/derivation.hpp"

/// Formulas of S-N curves over values: doubles where damage is summed, expressions on a sheet.
namespace boxbeam::sn {

/// x^m; the slopes of most codes are whole numbers.
inline double power(double x, double m) {
  if (m == 3.0) return x * x * x;
  if (m == 5.0) return (x * x) * (x * x) * x;
  return std::pow(x, m);
}
inline Traced power(const Traced& x, double m) { return pow(x, m); }

inline double root(double x, double m) { return m == 3.0 ? std::cbrt(x) : std::pow(x, 1.0 / m); }
inline Traced root(const Traced& x, double m) { return pow(x, 1.0 / Traced(m)); }

/// The strength at some cycles on the branch through a point of a curve.
template <class Stress, class Number>
Stress strength_from(const Stress& strength, const Number& its_cycles, const Number& cycles,
                     double slope) {
  return strength * root(its_cycles / cycles, slope);
}

/// Cycles to failure of a range on the branch through a point of a curve.
template <class Stress, class Number>
Number endured_from(const Stress& strength, const Number& its_cycles, const Stress& range,
                    double slope) {
  return its_cycles * power(strength / range, slope);
}

/// The range whose cycles do a damage at as many cycles as the strength is given at.
template <class Stress, class Number>
Stress equivalent_from(const Stress& strength, const Number& damage, double slope,
                       const Number& gammas) {
  using std::pow;
  return strength * pow(damage, Number(1.0) / Number(slope)) / gammas;
}

}  // namespace boxbeam::sn
