#pragma once

#include "boxbeam/project/table_reader.hpp"

namespace boxbeam::readers {

/// Where a joint may have a stiffness: where it keeps a place or a distance, and an angle.
struct CanGiveWay {
  bool place = false, angle = false;
};

/// The stiffness of a joint and the damping beside it.
struct GivesWay {
  double stiffness, damping;                  ///< [N/m, N s/m]
  double turning_stiffness, turning_damping;  ///< [N m/rad, N m s/rad]
};

/// The keys of a joint that say so; infinite where they are not there.
GivesWay read_elasticity(TableReader& table, const CanGiveWay& gives_way);

}  // namespace boxbeam::readers
