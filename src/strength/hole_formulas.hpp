#pragma once

#include <array>
#include <cmath>

#include "boxbeam/core/derivation.hpp"

/// Formulas of hole_concentration.hpp over a recorder and its values.
namespace boxbeam::hole {

template <class Record, class Number>
Number membrane_concentration(Record& record, const Number& a) {
  const std::array<Number, 4> c{record.constant("2", 2.0), record.constant("0.284", 0.284),
                                record.constant("-0.600", -0.600), record.constant("1.32", 1.32)};
  return record.define("K_t", polynomial(Number(1.0 - a), c));
}

template <class Record, class Number>
Number published_concentration(Record& record, const Number& diameter_to_width) {
  using std::exp;
  return record.define(
      "K_t", Number(record.constant("2.68750", 2.68750)) * exp(-0.7128 * diameter_to_width));
}

/// The membrane factor on the gross section.
template <class Number>
Number on_gross(const Number& on_net, const Number& a) {
  return on_net / (1.0 - a);
}

template <class Record, class Number>
Number plate_bending_concentration(Record& record, const Number& diameter_to_thickness,
                                   const Number& a) {
  const Number& k = diameter_to_thickness;
  const Number infinite =
      1.79 + 0.25 / (0.39 + k) + 0.81 / (1.0 + k * k) - 0.26 / (1.0 + k * k * k);
  return record.define("K_b", infinite * polynomial(a, std::array<Number, 3>{1.0, -1.04, 1.22}));
}

/// What the stresses of a wall around a hole in it are multiplied by at a place of its edge.
template <class Number, class Radius>
struct EdgeFactors {
  Number along;    ///< on the direct stress of the gross section at the hole's centre
  Number sheared;  ///< on the shear stress there
  Radius across;   ///< on the slope of the direct stress across the hole
};

template <class Number, class Radius>
EdgeFactors<Number, Radius> edge_factors(const Number& K_g, const Number& theta, const Number& a,
                                         const Radius& radius) {
  using std::cos;
  using std::sin;
  return {K_g / 3.0 * (1.0 - 2.0 * cos(2.0 * theta)), 4.0 / (1.0 - a) * sin(2.0 * theta),
          radius * (sin(theta) - sin(3.0 * theta))};
}

template <class Number, class Radius, class Stress, class Slope>
Stress edge_stress(const EdgeFactors<Number, Radius>& factors, const Stress& sigma_0,
                   const Stress& tau_0, const Slope& slope) {
  return factors.along * sigma_0 - factors.sheared * tau_0 + factors.across * slope;
}

}  // namespace boxbeam::hole
