#pragma once

#include <string>
#include <vector>

#include "boxbeam/mechanism/spatial/mesh.hpp"
#include "readers.hpp"

namespace boxbeam::readers {

/// A gear or a rack as written, by the names of its joints and of the body where its teeth meet.
struct GearingDraft {
  std::size_t closing = 0;  ///< index among the closing joints
  std::string first, second;
  spatial::Gearing gearing;
  std::string body;  ///< of the place where teeth meet, before bodies have been sorted
};

/// Before joints and bodies stand in the order of the tree.
GearingDraft read_gearing(TableReader& table, spatial::ClosingKind kind,
                          const spatial::Mechanism& mechanism);

/// Behind that: finds their joints and where their teeth meet.
void mesh_gearings(TableReader& root, const std::vector<GearingDraft>& drafts,
                   spatial::Mechanism& mechanism);

}  // namespace boxbeam::readers
