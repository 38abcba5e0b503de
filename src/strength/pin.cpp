#include "boxbeam/strength/pin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/derivation.hpp"

namespace boxbeam {
namespace {

Force size_of(Force force) { return si<Force>(std::abs(force.value())); }

template <class Record>
auto modulus_of(Record& record, const PinJoint& joint) {
  const auto pi = record.constant("pi", std::numbers::pi);
  const auto d = record.known("d", joint.diameter);
  return record.define("W_el", pi * d * d * d / 32.0);
}

template <class Record, class F>
auto moment_of(Record& record, const F& force, const PinJoint& joint) {
  const auto a = record.known("a", joint.outer_plate), b = record.known("b", joint.inner_plate),
             c = record.known("c", joint.gap);
  return record.define("M_Ed", force * (b + 4.0 * c + 2.0 * a) / 8.0);
}

template <class Record>
auto shear_resistance_of(Record& record, const PinJoint& joint, const PinStrength& strength) {
  const auto pi = record.constant("pi", std::numbers::pi);
  const auto d = record.known("d", joint.diameter);
  const auto A = record.define("A", pi * d * d / 4.0);
  const auto f_up = record.known("f_up", strength.pin_tensile);
  const auto gamma_M2 = record.known("gamma_M2", strength.gamma_M2, {ValueKind::factor});
  return record.define("F_v,Rd", 0.6 * A * f_up / gamma_M2, "shear, one plane");
}

template <class Record>
auto bending_resistance_of(Record& record, const PinJoint& joint, const PinStrength& strength) {
  const auto W_el = modulus_of(record, joint);
  const auto f_yp = record.known("f_yp", strength.pin_yield);
  const auto gamma_M0 = record.known("gamma_M0", strength.gamma_M0, {ValueKind::factor});
  return record.define("M_Rd", 1.5 * W_el * f_yp / gamma_M0);
}

/// A plate that bears on the pin, and what a sheet calls it.
struct Bearing {
  Length thickness;
  Stress yield;
  const char* symbol = "t";
  const char* resistance = "F_b,Rd";
  const char* what = "";
};

template <class Record>
auto bearing_resistance_of(Record& record, const Bearing& plate, const PinJoint& joint,
                           const PinStrength& strength) {
  const auto t = record.known(plate.symbol, plate.thickness);
  const auto d = record.known("d", joint.diameter);
  const auto f_y = record.known("f_y", std::min(plate.yield, strength.pin_yield));
  const auto gamma_M0 = record.known("gamma_M0", strength.gamma_M0, {ValueKind::factor});
  return record.define(plate.resistance, 1.5 * t * d * f_y / gamma_M0, plate.what);
}

/// Utilisations, as numbers or as expressions.
template <class Number>
struct Uses {
  Number shear, bearing_inner, bearing_outer, bending, combined;
};
template <class Number>
Uses(Number, Number, Number, Number, Number) -> Uses<Number>;

template <class Record, class F>
auto uses_of(Record& record, const F& force, const PinJoint& joint, const PinStrength& strength) {
  record.given("d", joint.diameter, "pin");
  record.given("a", joint.outer_plate, "each outer plate");
  record.given("b", joint.inner_plate, "inner plate");
  record.given("c", joint.gap, "gap between them");
  const auto u_v =
      record.define("u_v", force / (2.0 * shear_resistance_of(record, joint, strength)));
  const Bearing inner{joint.inner_plate, strength.inner_yield, "b", "F_b,Rd",
                      "bearing of the inner plate; f_y the lower of plate and pin"};
  const auto u_b =
      record.define("u_b", force / bearing_resistance_of(record, inner, joint, strength));
  const Bearing outer{joint.outer_plate, strength.outer_yield, "a", "F_a,Rd",
                      "bearing of each outer plate"};
  const auto u_a =
      record.define("u_a", force / (2.0 * bearing_resistance_of(record, outer, joint, strength)));
  const auto M_Ed = moment_of(record, force, joint);
  const auto u_m = record.define("u_m", M_Ed / bending_resistance_of(record, joint, strength));
  const auto u_c = record.define("u_c", u_m * u_m + u_v * u_v);
  return Uses{u_v, u_b, u_a, u_m, u_c};
}

template <class Number>
Number largest_use(const Uses<Number>& use) {
  using std::sqrt;
  return largest_of(
      {use.shear, use.bearing_inner, use.bearing_outer, use.bending, Number(sqrt(use.combined))});
}

/// Hertz's pressure on a hole a little wider than the pin.
template <class Record, class F>
auto contact_stress_of(Record& record, const F& force, const Bearing& plate, Stress youngs_modulus,
                       const PinJoint& joint) {
  using std::sqrt;
  const auto t = record.known(plate.symbol, plate.thickness);
  const auto d = record.known("d", joint.diameter), d_0 = record.known("d_0", joint.hole);
  const auto E = record.known("E", youngs_modulus);
  return record.define(plate.resistance, 0.591 * sqrt(E * force * (d_0 - d) / (d * d * t)),
                       plate.what);
}

/// Of a pin that is to be replaceable, under its service force.
template <class Number>
struct ServiceUses {
  Number bearing_inner, bearing_outer, bending, contact_inner, contact_outer;
};
template <class Number>
ServiceUses(Number, Number, Number, Number, Number) -> ServiceUses<Number>;

template <class Record, class F>
auto service_uses_of(Record& record, const F& force, Stress youngs_modulus, const PinJoint& joint,
                     const PinStrength& strength) {
  record.given("d", joint.diameter, "pin");
  record.given("d_0", joint.hole, "its hole");
  record.given("E", youngs_modulus, "of pin and plates");
  record.given("a", joint.outer_plate, "each outer plate");
  record.given("b", joint.inner_plate, "inner plate");
  record.given("c", joint.gap, "gap between them");
  const auto d = record.known("d", joint.diameter);
  const auto gamma = record.known("gamma_M6,ser", strength.gamma_M6_ser, {ValueKind::factor});
  const auto weaker = [&](const char* symbol, Stress plate, const char* what) {
    return record.given(symbol, std::min(plate, strength.pin_yield), what);
  };
  const auto f_b = weaker("f_yb", strength.inner_yield, "the lower of inner plate and pin");
  const auto f_a = weaker("f_ya", strength.outer_yield, "the lower of outer plates and pin");
  const auto b = record.known("b", joint.inner_plate), a = record.known("a", joint.outer_plate);
  const auto F_b = record.define("F_b,Rd,ser", 0.6 * b * d * f_b / gamma, "bearing, inner plate");
  const auto u_b = record.define("u_b", force / F_b);
  const auto F_a =
      record.define("F_a,Rd,ser", 0.6 * a * d * f_a / gamma, "bearing, each outer plate");
  const auto u_a = record.define("u_a", force / (2.0 * F_a));
  const auto M_Ed = moment_of(record, force, joint);
  const auto W_el = modulus_of(record, joint);
  const auto f_yp = record.known("f_yp", strength.pin_yield);
  const auto M_Rd = record.define("M_Rd,ser", 0.8 * W_el * f_yp / gamma);
  const auto u_m = record.define("u_m", M_Ed / M_Rd);
  const auto sigma_b = contact_stress_of(
      record, force, {joint.inner_plate, {}, "b", "sigma_h,b", "contact with the inner plate"},
      youngs_modulus, joint);
  const auto u_h = record.define("u_h", sigma_b / (2.5 * f_b / gamma));
  const auto half = record.define("F_a", force / 2.0, "on each outer plate");
  const auto sigma_a = contact_stress_of(
      record, half, {joint.outer_plate, {}, "a", "sigma_h,a", "contact with an outer plate"},
      youngs_modulus, joint);
  const auto u_k = record.define("u_k", sigma_a / (2.5 * f_a / gamma));
  return ServiceUses{u_b, u_a, u_m, u_h, u_k};
}

}  // namespace

PinUtilisation pin_utilisation(Force force, const PinJoint& joint, const PinStrength& strength) {
  const auto use = uses_of(plainly, size_of(force), joint, strength);
  return {use.shear, use.bearing_inner, use.bearing_outer, use.bending, use.combined};
}

double governing_utilisation(const PinUtilisation& use) {
  return largest_use(
      Uses<double>{use.shear, use.bearing_inner, use.bearing_outer, use.bending, use.combined});
}

void derive_pin_factor(Derivation& steps, const Traced& force, const PinJoint& joint,
                       const PinStrength& strength) {
  steps.define("factor", 1.0 / largest_use(uses_of(steps, force, joint, strength)),
               "on the force, with which u_c grows by its square");
}

double governing_utilisation(const ReplaceablePinUtilisation& use) {
  return std::max({use.bearing_inner, use.bearing_outer, use.bending,
                   use.contact_inner * use.contact_inner, use.contact_outer * use.contact_outer});
}

void derive_replaceable_pin_factor(Derivation& steps, const Traced& service_force,
                                   Stress youngs_modulus, const PinJoint& joint,
                                   const PinStrength& strength) {
  const auto use = service_uses_of(steps, service_force, youngs_modulus, joint, strength);
  steps.define("factor",
               1.0 / largest_of({use.bearing_inner, use.bearing_outer, use.bending,
                                 use.contact_inner * use.contact_inner,
                                 use.contact_outer * use.contact_outer}),
               "on the force, with whose root u_h and u_k grow");
}

ReplaceablePinUtilisation replaceable_pin_utilisation(Force service_force, Stress youngs_modulus,
                                                      const PinJoint& joint,
                                                      const PinStrength& strength) {
  const auto use =
      service_uses_of(plainly, size_of(service_force), youngs_modulus, joint, strength);
  return {use.bearing_inner, use.bearing_outer, use.bending, use.contact_inner, use.contact_outer};
}

}  // namespace boxbeam
