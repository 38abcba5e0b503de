#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// A pin in double shear: a plate between two others.
struct PinJoint {
  Length diameter;     ///< of the pin, d
  Length hole;         ///< diameter of its hole, d_0
  Length outer_plate;  ///< thickness a of each outer plate
  Length inner_plate;  ///< thickness b of the inner plate
  Length gap;          ///< c, between inner and outer plate
};

/// Strengths of a pin joint and their partial factors (the standard's recommended ones).
struct PinStrength {
  Stress pin_yield;    ///< f_yp
  Stress pin_tensile;  ///< f_up
  Stress outer_yield;  ///< f_y of the outer plates
  Stress inner_yield;  ///< f_y of the inner plate
  double gamma_M0 = 1.0;
  double gamma_M2 = 1.25;
  double gamma_M6_ser = 1.0;
};

/// Utilisations of a pin joint at its limit state of strength.
///
///     F_v,Rd = 0.6 A f_up/gamma_M2 in each plane of shear
///     F_b,Rd = 1.5 t d f_y/gamma_M0, f_y the lower of plate and pin
///     M_Ed = F (b + 4 c + 2 a)/8, the plates press evenly;  M_Rd = 1.5 W_el f_yp/gamma_M0
///
/// Source: EN 1993-1-8:2005, table 3.10 and figure 3.11.
struct PinUtilisation {
  double shear = 0.0;          ///< F/2 in each plane
  double bearing_inner = 0.0;  ///< F on the inner plate
  double bearing_outer = 0.0;  ///< F/2 on each outer plate
  double bending = 0.0;
  double combined = 0.0;  ///< (M_Ed/M_Rd)^2 + (F_v,Ed/F_v,Rd)^2, to be at most 1
};

/// `force`: the whole force of the inner plate, of either sign.
/// Source: EN 1993-1-8:2005, 3.13.2, table 3.10.
PinUtilisation pin_utilisation(Force force, const PinJoint& joint, const PinStrength& strength);

/// The utilisation that grows with the force and is 1 where the joint is used up,
/// max(u_v, u_b, u_a, u_m, sqrt(u_c)). Source: as above.
double governing_utilisation(const PinUtilisation& use);

/// The factor on a force, one over that, from the size of the force on, step by step.
void derive_pin_factor(Derivation& steps, const Traced& force, const PinJoint& joint,
                       const PinStrength& strength);

/// Utilisations of a pin that is to be replaceable, under the service force.
///
///     sigma_h,Ed = 0.591 sqrt(E F (d_0 - d)/(d^2 t)) (Hertz, both of steel, d_0 near d)
///
struct ReplaceablePinUtilisation {
  double bearing_inner = 0.0;  ///< against 0.6 t d f_y/gamma_M6,ser
  double bearing_outer = 0.0;
  double bending = 0.0;        ///< against 0.8 W_el f_yp/gamma_M6,ser
  double contact_inner = 0.0;  ///< sigma_h,Ed against 2.5 f_y/gamma_M6,ser
  double contact_outer = 0.0;
};

/// The utilisation that grows with the force and is 1 where the joint is used up; the contact
/// stress grows with its root, max(u_b, u_a, u_m, u_h^2). Source: as below.
double governing_utilisation(const ReplaceablePinUtilisation& use);

/// The factor on a service force, one over that, step by step.
void derive_replaceable_pin_factor(Derivation& steps, const Traced& service_force,
                                   Stress youngs_modulus, const PinJoint& joint,
                                   const PinStrength& strength);

/// Source: EN 1993-1-8:2005, 3.13.2(3), table 3.10 and equations 3.14 to 3.16.
ReplaceablePinUtilisation replaceable_pin_utilisation(Force service_force, Stress youngs_modulus,
                                                      const PinJoint& joint,
                                                      const PinStrength& strength);

}  // namespace boxbeam
