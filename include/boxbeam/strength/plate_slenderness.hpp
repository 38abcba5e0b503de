#pragma once

#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "boxbeam/strength/material.hpp"

namespace boxbeam {

/// A plate too slender for elastic stresses on the gross section: it may buckle before it yields.
struct SlenderPlate {
  std::string plate;   ///< "flange", "web", "round wall"
  double ratio = 0.0;  ///< c/t of the clear plate, or D/t
  double limit = 0.0;  ///< of class 3
};

/// The plates of a profile beyond the limit of class 3, where the section is class 4:
///
///     flange c/t <= 42 eps (compression),  web c/t <= 124 eps (bending),  tube D/t <= 90 eps^2
///     eps = sqrt(235 MPa/f_y)
///
/// A necessary condition: axial compression lowers the web's limit. Plates without a yield strength
/// in the material's table are left out. Source: EN 1993-1-1:2005, table 5.2.
std::vector<SlenderPlate> slender_plates_of(const Profile& profile, const Material& material);

}  // namespace boxbeam
