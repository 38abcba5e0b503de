#pragma once

#include <cmath>
#include <optional>

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

/// What Winter's curve takes off lambda_p, of an internal part and of an outstand one.
template <class Psi>
auto internal_loss(const Psi& psi) {
  return 0.055 * (3.0 + psi);
}
inline constexpr double outstand_loss = 0.188;

/// Beyond the slenderness up to which all of the plate is effective.
template <class Record, class Number, class Psi>
auto internal_reduction(Record& record, const Number& lambda_p, const Psi& psi) {
  return record.define("rho", (lambda_p - internal_loss(psi)) / (lambda_p * lambda_p));
}

/// Of an outstand part, likewise.
template <class Record, class Number>
auto outstand_reduction(Record& record, const Number& lambda_p) {
  return record.define("rho", (lambda_p - outstand_loss) / (lambda_p * lambda_p));
}

/// lambda_p of a part below yield.
template <class Record, class Number>
auto reduced_slenderness(Record& record, const Number& lambda_p, double share) {
  using std::sqrt;
  const auto part = record.given("sigma_com/f_y", share, {ValueKind::number},
                                 "largest compression of the plate where the worst place yields");
  return record.define("lambda_p,red", lambda_p * sqrt(part), "4.4(4)");
}

/// A part below yield, by annex E.
template <class Record, class Number, class Loss>
auto annex_E_reduction(Record& record, const Number& lambda_p, const Number& lambda_red,
                       const Loss& loss) {
  return record.define("rho", (1.0 - loss / lambda_red) / lambda_red +
                                  0.18 * (lambda_p - lambda_red) / (lambda_p - 0.6));
}

/// Stress at a corner of effective sections, and with bending about one axis.
template <class N, class A, class M, class W>
auto corner_stress(const N& force, const A& area, const M& M_y, const W& W_y) {
  return force / area + M_y / W_y;
}
template <class N, class A, class M, class W>
auto corner_stress(const N& force, const A& area, const M& M_y, const W& W_y, const M& M_z,
                   const W& W_z) {
  return force / area + M_y / W_y + M_z / W_z;
}

/// The moment about the centroid of N at a lever arm.
template <class M, class N, class L>
auto shifted_moment(const M& moment, const N& force, const L& arm) {
  return moment - force * arm;
}

/// The factor on both uses at which f eta_1 + (2 f eta_3 - 1)^2 = 1.
template <class Number>
auto interaction_factor(const Number& eta_1, const Number& eta_3) {
  return (4.0 * eta_3 - eta_1) / (4.0 * eta_3 * eta_3);
}

/// That at which f eta_1 + p (2 f eta_3 - 1)^2 = 1, p of the whole moment being the webs'.
template <class Number>
Number interaction_factor(const Number& eta_1, const Number& eta_3, const Number& part) {
  using std::sqrt;
  const Number b = 4.0 * part * eta_3 - eta_1;
  return (b + sqrt(b * b + 16.0 * part * (1.0 - part) * eta_3 * eta_3)) /
         (8.0 * part * eta_3 * eta_3);
}

/// k_tau = 5.34 + 4 (h/a)^2 of a panel that is longer than deep, else 4 + 5.34 (h/a)^2.
template <class Record, class Ratio>
auto shear_factor(Record& record, Symbol symbol, const Ratio& depth_to_length, bool longer) {
  const auto square = depth_to_length * depth_to_length;
  return record.define(symbol, longer ? 5.34 + 4.0 * square : 4.0 + 5.34 * square);
}

/// k_tau of a plate of some depth, without stiffeners; `again`: its length has been said.
template <class Number, class Record, class L>
Number bare_shear_factor(Record& record, const char* symbol, const L& depth, Length known_depth,
                         const std::optional<Length>& length, bool again = false) {
  if (!length) {
    return Number(record.given(symbol, 5.34, {ValueKind::factor},
                               "between the ends of the beam: nothing shortens the panel"));
  }
  const auto a =
      again ? record.known("a", *length) : record.given("a", *length, "between diaphragms");
  return Number(shear_factor(record, symbol, depth / a, *length >= known_depth));
}

/// What stiffeners add to it, theta = I_sl/(t^3 h_w); for a panel without length the least.
template <class Number, class Record>
Number shear_factor_of_stiffeners(Record& record, const Number& theta) {
  using std::pow;
  return 2.1 * pow(theta, record.constant("1/3", 1.0 / 3.0));
}
template <class Number, class Record>
Number shear_factor_of_stiffeners(Record& record, const Number& theta,
                                  const Number& depth_to_length) {
  using std::pow;
  return largest_of(
      {Number(9.0 * depth_to_length * depth_to_length * pow(theta, record.constant("3/4", 0.75))),
       shear_factor_of_stiffeners(record, theta)});
}

/// k_tau of a panel shorter than three depths with one or two stiffeners.
template <class Number, class Record>
Number few_stiffeners_shear_factor(Record& record, const Number& theta,
                                   const Number& depth_to_length) {
  using std::pow;
  return record.define("k_tau", 4.1 + (6.3 + 0.18 * theta) * depth_to_length * depth_to_length +
                                    2.2 * pow(theta, record.constant("1/3", 1.0 / 3.0)));
}

template <class Record, class Ratio, class Epsilon, class K>
auto shear_slenderness(Record& record, Symbol symbol, const Ratio& depth_to_thickness,
                       const Epsilon& epsilon, const K& k_tau) {
  using std::sqrt;
  return record.define(symbol, depth_to_thickness / (37.4 * epsilon * sqrt(k_tau)));
}

template <class Record, class Number>
Number shear_reduction(Record& record, const Number& lambda_w, double eta, bool rigid_end_post) {
  constexpr double elastic = 0.83, slender = 1.08;
  if (lambda_w < elastic / eta) {
    return Number(record.given("chi_w", eta, {ValueKind::factor},
                               "eta: lambda_w is below 0.83/eta, it yields before it buckles"));
  }
  if (rigid_end_post && lambda_w >= slender)
    return record.define("chi_w", 1.37 / (0.7 + lambda_w), "rigid end post");
  return record.define("chi_w", elastic / lambda_w);
}

template <class Record, class Number, class F, class L>
auto shear_resistance(Record& record, const Number& chi, const F& yield_strength, const L& depth,
                      const L& thickness, double gamma_M1) {
  using std::sqrt;
  const auto gamma = record.known("gamma_M1", gamma_M1, {ValueKind::factor});
  const auto three = record.constant("3", 3.0);
  return record.define("V_bw,Rd", chi * yield_strength * depth * thickness / (sqrt(three) * gamma));
}

}  // namespace boxbeam::plate
