#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/strength/column_buckling.hpp"

/// The formulas of column_buckling.hpp over a recorder and its values.
namespace boxbeam::column {

template <class Record, class E, class I, class L>
auto euler_force(Record& record, const E& youngs_modulus, const I& inertia, const L& length) {
  const auto pi = record.constant("pi", std::numbers::pi);
  return record.define("N_cr", pi * pi * youngs_modulus * inertia / (length * length));
}

/// Relative slenderness; A the effective area in class 4. Source: EN 1993-1-1:2005, 6.3.1.2(1).
template <class Record, class A, class F, class N>
auto slenderness(Record& record, const A& area, const F& yield_strength, const N& critical_force) {
  using std::sqrt;
  return record.define("lambda", sqrt(area * yield_strength / critical_force));
}

/// Reduction factor for flexural buckling, at most 1; the slenderness not below 0.
///
///     chi = 1/(Phi + sqrt(Phi^2 - lambda^2)),  Phi = [1 + alpha (lambda - 0.2) + lambda^2]/2
///
/// Source: EN 1993-1-1:2005, 6.3.1.2(1), equation 6.49.
template <class Record, class Number>
Number reduction(Record& record, const Number& lambda, BucklingCurve curve) {
  using std::sqrt;
  constexpr double plateau = 0.2;
  if (lambda <= plateau) {
    return Number(
        record.given("chi", 1.0, {ValueKind::factor}, "lambda is not above 0.2: no reduction"));
  }
  const auto alpha = record.known("alpha", imperfection_factor(curve), {ValueKind::factor});
  const auto phi = record.define("phi", 0.5 * (1.0 + alpha * (lambda - plateau) + lambda * lambda));
  record.note([&] { return std::string("buckling curve ") + to_text(curve); });
  return record.define("chi", 1.0 / (phi + sqrt(phi * phi - lambda * lambda)));
}

template <class Record, class Number, class A, class F>
auto resistance(Record& record, const Number& chi, const A& area, const F& yield_strength,
                double gamma_M1) {
  const auto gamma = record.known("gamma_M1", gamma_M1, {ValueKind::factor});
  return record.define("N_b,Rd", chi * area * yield_strength / gamma);
}

}  // namespace boxbeam::column
