#pragma once

namespace boxbeam {

/// What bends and moves a beam beside its cut forces, in the plane of its z.
struct BeamShift {
  double w = 0.0;          ///< of its start, along z [m]
  double slope = 0.0;      ///< of its start's section, dw/ds without shear
  double curvature = 0.0;  ///< by heat, all along; positive lengthens +z [1/m]
};

}  // namespace boxbeam
