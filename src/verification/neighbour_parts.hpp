#pragma once

#include <string>

#include "boxbeam/verification/neighbours.hpp"
#include "neighbour_loads.hpp"

/// What the checks of pins, of their lugs and of rods have in common.
namespace boxbeam {

/// Stops where rigid bodies do not determine the reaction of a joint.
void check_unique(const NeighbourRuns& runs, int joint, const std::string& of);

/// What round-off leaves of a force in this mechanism: a billionth of the largest reaction, times
/// its load factor.
double negligible_force(const NeighbourRuns& runs);

/// The check of a neighbour by its largest force.
Check check_begun(Criterion criterion, const std::string& name, const Project& project,
                  const Extreme& worst);

/// The name of a plate of a pin: "hub pin inner plate".
std::string name_of(const PinInput& pin, const LugInput& lug);

/// The part of the pin's force that a plate takes.
double share_of(const LugInput& lug);

}  // namespace boxbeam
