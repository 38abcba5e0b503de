#pragma once

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// Stresses on the surface of a plate before a weld's toe, across the weld, of one load: as
/// measured or from finite elements.
struct SurfaceStress {
  Stress near;  ///< 0.4 plate thicknesses from the toe
  Stress far;   ///< 1.0 plate thicknesses
};

/// Structural stress at the toe, extended linearly from the surface.
///
///     sigma_hs = near + (near - far) 0.4/(1.0 - 0.4) = 1.67 near - 0.67 far
///
/// Valid for toes on the face of a plate (types a), elements no longer than the plate is thick.
/// Source: IIW recommendations, fine mesh, as the usual complement of EN 1993-1-9:2005, annex B.
Stress hot_spot_stress_of(const SurfaceStress& surface);

}  // namespace boxbeam
