#include "boxbeam/strength/pin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/derivation.hpp"

namespace boxbeam {
namespace {

Force size_of(Force force) { return si<Force>(std::abs(force.value())); }

constexpr NoDerivation nothing_kept;

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

}  // namespace

Moment pin_moment(Force force, const PinJoint& joint) {
  return moment_of(nothing_kept, force, joint);
}

Force pin_shear_resistance(const PinJoint& joint, const PinStrength& strength) {
  return shear_resistance_of(nothing_kept, joint, strength);
}

Moment pin_bending_resistance(const PinJoint& joint, const PinStrength& strength) {
  return bending_resistance_of(nothing_kept, joint, strength);
}

Force pin_bearing_resistance(Length thickness, Stress plate_yield, const PinJoint& joint,
                             const PinStrength& strength) {
  return bearing_resistance_of(nothing_kept, {thickness, plate_yield}, joint, strength);
}

PinUtilisation pin_utilisation(Force force, const PinJoint& joint, const PinStrength& strength) {
  const auto use = uses_of(nothing_kept, size_of(force), joint, strength);
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

ReplaceablePinUtilisation replaceable_pin_utilisation(Force service_force, Stress youngs_modulus,
                                                      const PinJoint& joint,
                                                      const PinStrength& strength) {
  const Force F = size_of(service_force);
  const double gamma = strength.gamma_M6_ser;
  const Stress inner = std::min(strength.inner_yield, strength.pin_yield);
  const Stress outer = std::min(strength.outer_yield, strength.pin_yield);
  ReplaceablePinUtilisation use;
  use.bearing_inner = F * gamma / (0.6 * joint.inner_plate * joint.diameter * inner);
  use.bearing_outer = 0.5 * F * gamma / (0.6 * joint.outer_plate * joint.diameter * outer);
  use.bending =
      pin_moment(F, joint) * gamma / (0.8 * modulus_of(nothing_kept, joint) * strength.pin_yield);
  use.contact_inner =
      pin_contact_stress(F, joint.inner_plate, youngs_modulus, joint) * gamma / (2.5 * inner);
  use.contact_outer =
      pin_contact_stress(0.5 * F, joint.outer_plate, youngs_modulus, joint) * gamma / (2.5 * outer);
  return use;
}

Stress pin_contact_stress(Force force_on_plate, Length thickness, Stress youngs_modulus,
                          const PinJoint& joint) {
  const double d = joint.diameter.value();
  return si<Stress>(0.591 * std::sqrt(youngs_modulus.value() * force_on_plate.value() *
                                      (joint.hole.value() - d) / (d * d * thickness.value())));
}

PinPlateEdges pin_plate_edges(Force force_on_plate, Length thickness, Length hole, Stress yield,
                              double gamma_M0) {
  const Length ligament = force_on_plate * gamma_M0 / (2.0 * thickness * yield);
  return {ligament + hole * (2.0 / 3.0), ligament + hole / 3.0};
}

Length pin_plate_thickness(Force force_on_plate, Length hole, Stress yield, double gamma_M0) {
  const double by_force = 0.7 * std::sqrt(force_on_plate.value() * gamma_M0 / yield.value());
  return std::max(si<Length>(by_force), hole / 2.5);
}

}  // namespace boxbeam
