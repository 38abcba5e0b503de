#pragma once

#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/front_end.hpp"

/// The front ends, each in a source of its own.
namespace boxbeam {

/// The front end for a kind of mechanism; of the mechanism only the kind counts.
std::unique_ptr<const FrontEnd> front_end_for(const planar::Mechanism&, const Project& project);
std::unique_ptr<const FrontEnd> front_end_for(const spatial::Mechanism&, const Project& project);
std::unique_ptr<const FrontEnd> front_end_for(const flexible::Mechanism&, const Project& project);
std::unique_ptr<const FrontEnd> front_end_for(const frame::Structure&, const Project& project);
std::unique_ptr<const FrontEnd> front_end_for(const recorded::Loads&, const Project& project);

/// The model of elastic links: the cheapest whose error of the governing stress is within the
/// tolerance that the case asks for, or the one that it demands.
ModelChoice choose_for_links(const Project& project);

/// Adds position, speed and acceleration of a coordinate at a time, and what drives it.
void add_sample(DriverLine& line, double time, const DriverState& motion,
                std::optional<double> force);

/// When drivers and forces are not smooth, within a time that is looked at.
std::vector<Time> break_times_in(const std::vector<DriverUse>& functions, double begin,
                                 double length);

/// The time of the motion of a mechanism in space, however long its loads are looked at.
LoadSpan span_of_motion_in_space(const SituationRun& run);

}  // namespace boxbeam
