#pragma once

#include <string>
#include <vector>

#include "boxbeam/section/section_points.hpp"

namespace boxbeam {

/// A stretch of wall along which the stress varies smoothly: where on it a stress is worst depends
/// on the loads, in biaxial bending of a round tube at any angle.
struct WallStretch {
  std::string name;      ///< "left web", "top flange 2" beside a hole, "wall", "wall 3 right"
  bool round = false;    ///< all around a round tube, from +y towards +z
  bool inner = false;    ///< of the section's inner profile
  std::size_t wall = 0;  ///< straight: of the flow's walls
  double from = 0.0, to = 1.0;  ///< fractions of the wall between which it is clear of others
  double face = 0.0;            ///< 1 the right face, -1 the left one; 0 the outer one of a cell
  Length plate;                 ///< thickness that decides the yield strength
  bool solid = false;           ///< on a face of a solid, or across it: between `low` and `high`
  bool left_side = false;  ///< of a plate, its side at +y: in the plane both are stressed alike
  SectionPlace low, high;
};

/// The walls between the corners of boxes and tubes, on their outer faces, the rounded corners of
/// rolled tubes, round tubes all around, every wall of a path on both faces; the four faces of a
/// plate, and the height of a polygon at its centroid. Holes in walls are left out.
std::vector<WallStretch> wall_stretches_of(const StressField& field);

/// The place at a part of a stretch, 0 to 1.
SectionPoint point_on_stretch(const StressField& field, const WallStretch& stretch, double part);

}  // namespace boxbeam
