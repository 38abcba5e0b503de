#pragma once

#include <cmath>

#include "boxbeam/core/derivation.hpp"

/// Formulas of section_class.hpp and effective_width.hpp over a recorder and its values.
namespace boxbeam::plate {

template <class Record, class F>
auto epsilon(Record& record, const F& yield_strength) {
  using std::sqrt;
  return record.define("epsilon",
                       sqrt(record.constant("235 MPa", 235e6 * pascal) / yield_strength));
}

template <class Record, class Ratio, class Epsilon, class K>
auto slenderness(Record& record, const Ratio& width_to_thickness, const Epsilon& epsilon,
                 const K& k_sigma) {
  using std::sqrt;
  return record.define("lambda_p", width_to_thickness / (28.4 * epsilon * sqrt(k_sigma)));
}

/// Beyond the slenderness up to which all of the plate is effective.
template <class Record, class Number, class Psi>
auto internal_reduction(Record& record, const Number& lambda_p, const Psi& psi) {
  return record.define("rho", (lambda_p - 0.055 * (3.0 + psi)) / (lambda_p * lambda_p));
}

}  // namespace boxbeam::plate
