#pragma once

#include <cstddef>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Cut forces on the face with outward normal +x. N > 0 is tension, V_y and V_z act along +y and
/// +z, T about +x, M_y > 0 puts +z in tension, M_z > 0 puts -y in tension.
struct CutForces {
  Force N, V_y, V_z;
  Moment T, M_y, M_z;
};

/// The cut forces in their order, as places in arrays.
namespace cut_force {
enum Index : std::size_t { N, V_y, V_z, T, M_y, M_z };
inline constexpr std::size_t count = 6;
}  // namespace cut_force

/// One of the cut forces [N or N m].
constexpr double value_of(const CutForces& cut, cut_force::Index which) {
  switch (which) {
    case cut_force::N: return cut.N.value();
    case cut_force::V_y: return cut.V_y.value();
    case cut_force::V_z: return cut.V_z.value();
    case cut_force::T: return cut.T.value();
    case cut_force::M_y: return cut.M_y.value();
    case cut_force::M_z: return cut.M_z.value();
  }
  return 0.0;
}

}  // namespace boxbeam
