#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "boxbeam/strength/plate_materials.hpp"
#include "boxbeam/strength/section_class.hpp"

namespace boxbeam {

/// How slender a plate is.
struct SlenderPlate {
  std::string plate;   ///< "flange", "web", "top flange", "round wall", "walls 2, 3", ...
  double ratio = 0.0;  ///< c/t of the clear plate between walls and stiffeners, or D/t
  double limit = 0.0;  ///< of class 3
  ClassLimits limits;
};

/// The yield strength by which a plate's class is found: its own; of a web that of its flanges
/// where they are of a stronger steel. Nothing where it is thicker than its material's table goes.
/// Source: EN 1993-1-5:2006, 4.3(6).
std::optional<Stress> class_yield_of(const Profile& profile, const PlateMaterials& materials,
                                     PlateKind plate, Length thickness);

/// The plates of a profile and the limits of class 3:
///
///     flange c/t <= 42 eps (compression),  web c/t <= 124 eps (bending),  tube D/t <= 90 eps^2,
///     outstand (a stiffener, a wall with a free edge) c/t <= 14 eps,  eps = sqrt(235 MPa/f_y)
///
/// A necessary condition: axial compression lowers the web's limit; a web divided by stiffeners is
/// taken as compressed. The walls of a path are the plates of `plates_of`. Plates without a yield
/// strength in their material's table are left out, solids have none. Source: EN 1993-1-1:2005,
/// table 5.2.
std::vector<SlenderPlate> plate_slenderness_of(const Profile& profile,
                                               const PlateMaterials& materials);

/// Those beyond the limit, where the section is class 4: they may buckle before they yield, and
/// elastic stresses on the gross section mean nothing.
std::vector<SlenderPlate> slender_plates_of(const Profile& profile,
                                            const PlateMaterials& materials);

}  // namespace boxbeam
