#pragma once

#include <string>
#include <vector>

#include "boxbeam/section/section_points.hpp"

/// Places of sections without thin walls.
namespace boxbeam {

/// Whether a level is cut out of a section.
bool in_hole(const StressField& field, Length z);

/// A place in a solid, or the mean over a level of any other section, at y.
SectionPoint level_point(const StressField& field, const std::string& name, double y, double z);

/// Plates: the level's mean for V_z on the sides, for V_y on top and bottom, T by the series.
SectionPoint plate_point(const StressField& field, const std::string& name, double y, double z);

/// The shear stress of V_y and T is not known there.
SectionPoint polygon_point(const StressField& field, const std::string& name, double y, double z);

void add_polygon_points(const StressField& field, std::vector<SectionPoint>& points);

void add_plate_points(const StressField& field, PointSet set, std::vector<SectionPoint>& points);

}  // namespace boxbeam
