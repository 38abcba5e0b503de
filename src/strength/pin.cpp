#include "boxbeam/strength/pin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boxbeam {
namespace {

SectionModulus elastic_modulus_of(const PinJoint& joint) {
  return std::numbers::pi / 32.0 * joint.diameter * joint.diameter * joint.diameter;
}

Force size_of(Force force) { return si<Force>(std::abs(force.value())); }

}  // namespace

Moment pin_moment(Force force, const PinJoint& joint) {
  return 0.125 * force * (joint.inner_plate + 4.0 * joint.gap + 2.0 * joint.outer_plate);
}

Force pin_shear_resistance(const PinJoint& joint, const PinStrength& strength) {
  const Area area = 0.25 * std::numbers::pi * joint.diameter * joint.diameter;
  return 0.6 * area * strength.pin_tensile / strength.gamma_M2;
}

Moment pin_bending_resistance(const PinJoint& joint, const PinStrength& strength) {
  return 1.5 * elastic_modulus_of(joint) * strength.pin_yield / strength.gamma_M0;
}

Force pin_bearing_resistance(Length thickness, Stress plate_yield, const PinJoint& joint,
                             const PinStrength& strength) {
  return 1.5 * thickness * joint.diameter * std::min(plate_yield, strength.pin_yield) /
         strength.gamma_M0;
}

PinUtilisation pin_utilisation(Force force, const PinJoint& joint, const PinStrength& strength) {
  const Force F = size_of(force);
  PinUtilisation use;
  use.shear = 0.5 * F / pin_shear_resistance(joint, strength);
  use.bearing_inner =
      F / pin_bearing_resistance(joint.inner_plate, strength.inner_yield, joint, strength);
  use.bearing_outer =
      0.5 * F / pin_bearing_resistance(joint.outer_plate, strength.outer_yield, joint, strength);
  use.bending = pin_moment(F, joint) / pin_bending_resistance(joint, strength);
  use.combined = use.bending * use.bending + use.shear * use.shear;
  return use;
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
      pin_moment(F, joint) * gamma / (0.8 * elastic_modulus_of(joint) * strength.pin_yield);
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
