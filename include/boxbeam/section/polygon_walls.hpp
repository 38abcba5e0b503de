#pragma once

#include <optional>

#include "boxbeam/core/units.hpp"
#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A part of a polygon that is thin beside its length along the border.
struct PolygonWall {
  Length length, thickness;
  bool of_cell = false;  ///< between two borders: what stands behind is another one than its own
  double slenderness() const { return length / thickness; }
};

/// The stretch of a border with the largest length over thickness, a third of which counts of walls
/// of cells. Thickness is what stands behind
/// a place, square to the border; a stretch goes on while that is at most 1.5 times the least and
/// the border turns by no more than 30 degrees. Each edge is looked at in steps of a 32nd, longer
/// ones in outlines of many edges. Nothing for an outline without area.
std::optional<PolygonWall> most_slender_wall_of(const Polygon& polygon);

/// I_T is no less than this, by Prandtl's stress function, any of which makes
/// 4 (int phi dA)^2/(int |grad phi|^2 dA) a lower bound: the distance from the border (thin strips
/// 3/4 of I_T, a circle 8/9, a square 4/5, less 10 % for the grid), and with hollows the distance
/// from the outer border up to the thinnest wall, which is Bredt's formula for an even one.
/// Source: Timoshenko, Goodier, Theory of Elasticity, sections 104, 111, 115.
SecondMoment least_torsion_constant_of(const Polygon& polygon);

}  // namespace boxbeam
