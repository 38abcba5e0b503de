#pragma once

#include <cmath>
#include <numbers>

#include "boxbeam/core/derivation.hpp"

/// Formulas of stiffened_plate.hpp over a recorder and its values.
namespace boxbeam::stiffened {

inline constexpr Stress youngs_modulus = Stress::from_value(210e9);
inline constexpr double one_less_nu_squared = 1.0 - 0.3 * 0.3;

template <class Record, class I, class L>
auto held_wave(Record& record, const I& inertia, const L& b_1, const L& b_2, const L& thickness) {
  using std::sqrt;
  const auto fourth_power =
      inertia * b_1 * b_1 * b_2 * b_2 / (thickness * thickness * thickness * (b_1 + b_2));
  return record.define("a_c", 4.33 * sqrt(sqrt(fourth_power)));
}

template <class Record, class S, class A, class I, class L>
auto column_stress(Record& record, Symbol symbol, const S& E, const A& area, const I& inertia,
                   const L& length) {
  const auto pi = record.constant("pi", std::numbers::pi);
  return record.define(symbol, pi * pi * E * inertia / (area * length * length));
}

template <class Record, class S, class A, class I, class L>
auto long_held_stress(Record& record, const S& E, const A& area, const I& inertia, const L& b_1,
                      const L& b_2, const L& thickness) {
  using std::sqrt;
  return record.define("sigma_cr,sl",
                       1.05 * E * sqrt(inertia * thickness * thickness * thickness * (b_1 + b_2)) /
                           (area * b_1 * b_2),
                       "a >= a_c, A.2.2");
}

template <class Record, class S, class A, class I, class L>
auto short_held_stress(Record& record, const S& E, const A& area, const I& inertia, const L& b_1,
                       const L& b_2, const L& thickness, const L& length) {
  const auto pi = record.constant("pi", std::numbers::pi);
  return record.define("sigma_cr,sl",
                       pi * pi * E * inertia / (area * length * length) +
                           E * thickness * thickness * thickness * (b_1 + b_2) * length * length /
                               (4.0 * one_less_nu_squared * pi * pi * area * b_1 * b_1 * b_2 * b_2),
                       "a < a_c, A.2.2");
}

template <class Record, class Number>
Number long_orthotropic_factor(Record& record, const Number& psi, const Number& gamma,
                               const Number& delta) {
  using std::sqrt;
  return record.define("k_sigma,p", 4.0 * (1.0 + sqrt(gamma)) / ((psi + 1.0) * (1.0 + delta)),
                       "alpha above gamma^(1/4), A.1(2)");
}

template <class Record, class Number>
Number short_orthotropic_factor(Record& record, const Number& alpha, const Number& psi,
                                const Number& gamma, const Number& delta) {
  const auto square = alpha * alpha;
  return record.define("k_sigma,p",
                       2.0 * ((1.0 + square) * (1.0 + square) + gamma - 1.0) /
                           (square * (psi + 1.0) * (1.0 + delta)),
                       "alpha up to gamma^(1/4), A.1(2)");
}

template <class Record, class S, class L>
auto euler_stress(Record& record, Symbol symbol, const S& E, const L& thickness, const L& width) {
  const auto pi = record.constant("pi", std::numbers::pi);
  return record.define(
      symbol, pi * pi * E * thickness * thickness / (12.0 * one_less_nu_squared * width * width));
}

template <class Record, class L>
auto imperfection(Record& record, const L& e, const L& radius) {
  return record.define("alpha_e", 0.49 + 0.09 * e / radius, "open stiffeners, 4.5.3(5)");
}

template <class Record, class Number>
Number column_reduction(Record& record, const Number& lambda, const Number& alpha) {
  using std::sqrt;
  constexpr double plateau = 0.2;
  if (lambda <= plateau) {
    return Number(
        record.given("chi_c", 1.0, {ValueKind::factor}, "lambda_c is not above 0.2: no reduction"));
  }
  const auto phi = record.define("phi", 0.5 * (1.0 + alpha * (lambda - plateau) + lambda * lambda));
  return record.define("chi_c", 1.0 / (phi + sqrt(phi * phi - lambda * lambda)));
}

template <class Number>
Number interpolated(const Number& rho, const Number& chi, const Number& xi) {
  return (rho - chi) * xi * (2.0 - xi) + chi;
}

}  // namespace boxbeam::stiffened
