#pragma once

#include "boxbeam/section/section_points.hpp"

namespace boxbeam {

/// The force that a plate of a box or rectangular tube carries in its own plane across the beam,
/// per cut force: the mean of its shear flow over its material, all the way between the mid-lines
/// of the plates on either side of it,
///
///     F = h int q du / int du
///
/// positive along +z in webs, along +y in flanges; of flanges what lies between the webs. Source:
/// equilibrium.
CutFactors plate_force_of(const ShearFlow& flow, WallPart plate);

/// A place beside the holes in a plate of a box or rectangular tube, where the force of the whole
/// plate goes through what they leave of it:
///
///     tau = F/(t (c - sum d))
///
/// c is its clear width. Source: EN 1993-1-1:2005, 6.2.6(1) to (3), (7).
struct PlateStrip {
  WallPart plate;      ///< `path` in a solid
  SectionPoint point;  ///< on an edge of the hole, with its normal stress of the net section
};

/// On both edges of a hole (of two in a flange the outer ones), in each plate that it goes through;
/// in the plane of a section that mirrors itself in the left web alone. Solid plates carry all of V
/// along themselves. `field`: of the section with its holes, `whole`: without them.
std::vector<PlateStrip> strips_beside(const StressField& field, const StressField& whole,
                                      const Hole& hole, PointSet set);

/// The places of a hole's centre in each plate that it goes through, in the section without it; in
/// the plane of a section that mirrors itself on its left half alone.
std::vector<SectionPoint> posts_at(const StressField& whole, const Hole& hole, PointSet set);

/// What the holes of a section take out of each plate that this one goes through.
Length taken_by_holes(const std::vector<Hole>& holes, HoleWalls walls);

/// The clear width of the plates that holes go through.
Length clear_for_holes(const Profile& profile, HoleWalls walls);

}  // namespace boxbeam
