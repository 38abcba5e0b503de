#pragma once

#include <set>
#include <vector>

#include "beside.hpp"
#include "boxbeam/verification/bending_zones.hpp"

namespace oracle {

/// Every place where something begins, ends, jumps or bends [m].
std::set<double> cut_places_of(const Project& project, const std::vector<Run>& sampled,
                               const std::vector<boxbeam::BendingZone>& zones);

/// Both sides of the cuts first, then a grid from coarse to fine, so that most places can soon be
/// seen to be milder than the worst.
std::vector<boxbeam::Station> stations_of(const Project& project, const std::vector<Run>& sampled,
                                          const std::vector<boxbeam::BendingZone>& zones,
                                          const Density& density);

}  // namespace oracle
