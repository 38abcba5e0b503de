#pragma once

#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/strength/plate_materials.hpp"

namespace boxbeam {

/// The materials of a segment's plates.
PlateMaterials materials_of(const Project& project, std::size_t segment);

/// All materials of the beam, that of [material] first.
std::vector<const Material*> materials_of(const Project& project);

/// A material and the thickness by which its strengths are taken.
struct PlateOf {
  const Material* material = nullptr;
  Length thickness;
};

/// The plates that hold or touch a place of a section.
std::vector<PlateOf> plates_at(const PlateMaterials& materials, const Section& section, Length y,
                               Length z);

/// All plates on both faces of a station, as thick as given: what is joined there where nothing
/// says which of them.
std::vector<PlateOf> plates_around(const Project& project, Length s, Length thickness);

/// The one with the lowest yield strength. One that is thicker than its material's table goes comes
/// before all others. Precondition: at least one.
PlateOf first_to_yield(const std::vector<PlateOf>& plates);

/// The one by which a weld that joins them is weakest: least f_u/beta_w; likewise. Source: EN
/// 1993-1-8:2005, 4.5.3.2(6), f_u of the weaker part joined.
PlateOf weakest_to_weld(const std::vector<PlateOf>& plates);

}  // namespace boxbeam
