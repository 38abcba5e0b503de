#pragma once

#include "boxbeam/mechanism/planar/motion.hpp"

namespace boxbeam::planar {

/// The mass that the mechanism feels like where it is driven.
struct EquivalentMass {
  double given = 0.0;     ///< of the mechanism as it is [kg]
  double per_mass = 0.0;  ///< its increase per kg of the adjustable body
  double needed = 0.0;    ///< mass of that body for the wanted equivalent mass [kg]
};

/// First harmonic of the force that joint `joint` exerts on body `on`, in phase with the
/// acceleration of the joint's point, divided by the first harmonic of that acceleration:
///
///     m_eq = <F_1, a_1> / <a_1, a_1>
///
/// The motion is given, so forces and m_eq are linear in every mass: two evaluations give the mass
/// of body `adjustable` (whose moment of inertia stays) that brings m_eq to `wanted` [kg].
/// `motion` is that of this mechanism, reactions included. Throws AnalysisError where the point
/// does not move or the body has no influence.
EquivalentMass equivalent_mass_of(const Mechanism& mechanism, const Motion& motion, int joint,
                                  int on, int adjustable, double wanted);

}  // namespace boxbeam::planar
