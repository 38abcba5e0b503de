#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// What a wall is part of.
enum class WallPart { top_flange, bottom_flange, left_web, right_web, stiffener, corner, path };

/// A wall of a thin-walled section, SI, in the plane (y, z). Its material is exact: a rectangle
/// from `start` to `end` on its mid-line, which need not reach its nodes (a web ends at the inner
/// face of the flange, its node lies on the flange's mid-line); a sector of a ring; or, in the
/// corner of a rolled tube, a piece of known area and first moment.
struct Wall {
  std::size_t from = 0, to = 0;  ///< nodes
  Eigen::Vector2d start, end;    ///< of the material, on the mid-line
  double thickness = 0.0;
  WallPart part = WallPart::path;
  bool inner = false;  ///< of the section's inner profile
  bool solid = true;   ///< false: a strip taken out by a hole; shear flow passes, material is none
  // Arcs only:
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< of the mid-line; 0: straight
  double angle = 0.0, sweep = 0.0;
  /// Corners only: area and its first moments, of y dA and z dA, spread evenly along the arc.
  std::optional<Eigen::Vector3d> lump = std::nullopt;
};

/// The walls of a section and how they hang together; one component per profile.
struct WallGraph {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<Wall> walls;
};

/// The walls of a section with its holes, or nothing where a profile is solid.
std::optional<WallGraph> wall_graph_of(const Section& section, const std::vector<Hole>& holes);

/// Length of the material along the mid-line.
double length_of(const Wall& wall);

/// Mid-line point at a fraction of the material, and the direction of the wall there.
Eigen::Vector2d point_on(const Wall& wall, double fraction);
Eigen::Vector2d direction_on(const Wall& wall, double fraction);

/// Area and first moments (of y dA, of z dA) of the material from the start to a fraction of it.
Eigen::Vector3d material_up_to(const Wall& wall, double fraction);

}  // namespace boxbeam
