#pragma once

#include <optional>

#include "boxbeam/core/units.hpp"
#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A part of a polygon that is thin beside its length along the border.
struct PolygonWall {
  Length length, thickness;
  double slenderness() const { return length / thickness; }
};

/// The stretch of a border with the largest length over thickness. Thickness is what stands behind
/// a place, square to the border; a stretch goes on while that is at most 1.5 times the least and
/// the border turns by no more than 30 degrees. Each edge is looked at in steps of a 32nd, longer
/// ones in outlines of many edges. Nothing for an outline without area.
std::optional<PolygonWall> most_slender_wall_of(const Polygon& polygon);

/// I_T is no less than this. Of solids Saint-Venant's A^4/(4 pi^2 I_p), exact for ellipses, above
/// the closed forms by 7 % for a square and 13 % for an equal-sided triangle, below them for thin
/// shapes of several legs, 0.85 of it. With hollows also Bredt's formula for a wall as thin as it
/// is where it is thinnest, t: 4 t (A_outer - U t)^2/U, a lower bound by Prandtl's stress function
/// min(distance from the outer border, t).
/// Source: Saint-Venant (1855); Timoshenko, Goodier, Theory of Elasticity, sections 109, 115.
SecondMoment least_torsion_constant_of(const Polygon& polygon);

}  // namespace boxbeam
