#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A piece of the border of a section, SI, in the plane (y, z): straight, or a circular arc of at
/// most a quarter that does not pass a level tangent inside it.
struct BorderPiece {
  Eigen::Vector2d from, to;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< arcs only
  double radius = 0.0;                               ///< 0: straight
  double angle = 0.0;                                ///< where an arc begins, from +y towards +z
  double sweep = 0.0;                                ///< negative turns clockwise
};

/// The border of an area: material to the left, so that outer loops turn counter-clockwise and
/// hollows clockwise. Loops may lie apart.
using Outline = std::vector<BorderPiece>;

/// Integrals over an area, SI, about the origin.
struct AreaSums {
  double area = 0.0;
  double y = 0.0, z = 0.0;              ///< of y dA, z dA [m^3]
  double yy = 0.0, zz = 0.0, yz = 0.0;  ///< of y^2 dA, z^2 dA, y z dA [m^4]
};

/// The border of a profile, of a section with its holes taken out as strips.
Outline outline_of(const Profile& profile);
Outline outline_of(const Section& section, const std::vector<Hole>& holes);

/// The border of an upright rectangle; of a hollow or strip taken out with `sign` -1.
void add_rectangle(Outline& outline, double y_low, double y_high, double z_low, double z_high,
                   double sign);

/// Area integrals by Green's theorem along the border:
///
///     A = int y dz,  int z dA = int y z dz,  int y dA = int y^2/2 dz,  int z^2 dA = int y z^2 dz,
///     int y^2 dA = int y^3/3 dz,  int y z dA = int y^2 z/2 dz
///
/// By Gauss' rule: exact along straight lines, to round-off along arcs.
AreaSums sums_of(const Outline& outline);

/// Of the part beyond a level, z' > z.
AreaSums sums_beyond(const Outline& outline, double z);

/// Width of material at a level. Where it jumps (the inner face of a flange, the edge of a hole)
/// the smaller of both sides that is not zero.
double width_at(const Outline& outline, double z);

}  // namespace boxbeam
