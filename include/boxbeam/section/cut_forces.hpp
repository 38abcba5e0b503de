#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Cut forces on the face with outward normal +x. N > 0 is tension, V_y and V_z act along +y and
/// +z, T about +x, M_y > 0 puts +z in tension, M_z > 0 puts -y in tension.
struct CutForces {
  Force N, V_y, V_z;
  Moment T, M_y, M_z;
};

}  // namespace boxbeam
