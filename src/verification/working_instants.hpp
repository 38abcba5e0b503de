#pragma once

#include <memory>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// The instants of a long record at which cut forces and stresses of the beam are largest or
/// smallest: at the ends and in the middle of every stretch between places of the beam and loads,
/// for each cut force, at each point of the section for direct and shear stress and the parts of
/// the equivalent stress, for what buckling plates are used by, the bending of the whole
/// beam, what acts at each place, and what webs get of forces near each other
/// (`pressing_sums_of`). Beside those that the channels have already.
std::shared_ptr<const recorded::Channels> working_instants(const Project& project,
                                                           const recorded::ChannelLoads& loads);

}  // namespace boxbeam
