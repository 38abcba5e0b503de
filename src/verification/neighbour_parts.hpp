#pragma once

#include <string>

#include "boxbeam/verification/neighbours.hpp"
#include "neighbour_loads.hpp"

/// What the checks of pins, of their lugs and of rods have in common.
namespace boxbeam {

/// The moduli of structural steel. Source: EN 1993-1-1:2005, 3.2.6.
inline constexpr Stress steel_modulus = 210e9 * pascal, steel_shear_modulus = 81e9 * pascal;

/// Of the case's material or of structural steel, which rods may be of, the one that makes them
/// softer.
Stress rod_modulus_of(const Project& project);
Stress rod_shear_modulus_of(const Project& project);

/// Stops where rigid bodies do not determine the reaction of a joint.
void check_unique(const NeighbourRuns& runs, int joint, const std::string& of);

/// What round-off leaves of a force in this mechanism: a billionth of the largest reaction, times
/// its load factor.
double negligible_force(const NeighbourRuns& runs);

/// The check of a neighbour by its largest force.
Check check_begun(Criterion criterion, const std::string& name, const Project& project,
                  const Extreme& worst);

/// The largest stress by which a rod bends about its weaker axis, in the plane by its own weight
/// and inertia, in space by all that acts on it, at the instants of the motion, times the load
/// factors of their situations.
Stress own_bending_of(const NeighbourRuns& runs, const RodInput& rod);

/// How far a rod is used by its axial force and by what bends it, where `use` is by the first
/// alone:
///
///     use + k sigma gamma/f_y,  k = 1 + 0.6 use under compression, else 1
///
/// sigma times A/A_eff where plates buckle; all with the safety factor that is asked for.
/// Source: EN 1993-1-1:2005, 6.3.3, equations 6.61 and 6.62, k of annex B, table B.1, of sections
/// of class 3 with C_m = 1 and the slenderness 1, above which it grows no more; under tension
/// 6.2.9.2.
double use_with_bending(const RodInput& rod, const NeighbourResult& result, Stress bending);

/// The name of a plate of a pin: "hub pin inner plate".
std::string name_of(const PinInput& pin, const LugInput& lug);

/// The part of the pin's force that a plate takes.
double share_of(const LugInput& lug);

}  // namespace boxbeam
