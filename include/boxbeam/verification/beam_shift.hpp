#pragma once

#include <Eigen/Core>

namespace boxbeam {

/// What bends and moves a beam beside its cut forces, along its y and its z.
struct BeamShift {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();  ///< by which its start has moved [m]
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< of the section there, without shear
  double curvature = 0.0;  ///< by heat, all along; positive lengthens +z [1/m]
};

}  // namespace boxbeam
