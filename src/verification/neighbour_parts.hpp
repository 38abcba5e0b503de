#pragma once

#include <optional>
#include <string>

#include "boxbeam/verification/neighbours.hpp"

/// What the checks of pins, of their lugs and of rods have in common.
namespace boxbeam {

/// Stops where rigid bodies do not determine the reaction of a joint.
void check_unique(const Project& project, const std::deque<SituationRun>& runs, int joint,
                  const std::string& of);

/// What round-off leaves of a force in this mechanism: a billionth of the largest reaction, times
/// its load factor.
double negligible_force(const Project& project, const std::deque<SituationRun>& runs);

/// The check of a neighbour by its largest force.
Check check_begun(Criterion criterion, const std::string& name, const Project& project,
                  const Extreme& worst);

/// What a rod is bent by its own weight and inertia, at the instants of the motion, where it
/// counts.
std::optional<NotJudged> own_bending_of(const Project& project,
                                        const std::deque<SituationRun>& runs, const RodInput& rod);

/// The name of a plate of a pin: "hub pin inner plate".
std::string name_of(const PinInput& pin, const LugInput& lug);

/// The part of the pin's force that a plate takes.
double share_of(const LugInput& lug);

}  // namespace boxbeam
