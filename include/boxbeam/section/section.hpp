#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/core/units.hpp"

/// Cross-sections: the beam axis is x, z the left normal of the axis in the plane of motion (the
/// height of a section), y across (its width). Origin at mid-height and mid-width.
namespace boxbeam {

/// A rectangle with a rectangular hollow: a welded box of two flanges and two webs, or a
/// rectangular tube where both are the wall. Sharp corners.
struct HollowRectangle {
  Length width;   ///< along y, outside
  Length height;  ///< along z, outside
  Length flange;  ///< thickness of the two plates at z = +-height/2
  Length web;     ///< thickness of the two plates at y = +-width/2

  friend bool operator==(const HollowRectangle&, const HollowRectangle&) = default;
};

/// A round tube.
struct RoundTube {
  Length diameter;  ///< outside
  Length wall;

  friend bool operator==(const RoundTube&, const RoundTube&) = default;
};

using Profile = std::variant<HollowRectangle, RoundTube>;

/// A profile, and possibly a second one inside that shares its axis and acts together with it.
struct Section {
  Profile outer;
  std::optional<Profile> inner;

  friend bool operator==(const Section&, const Section&) = default;
};

/// The walls of a section that a hole goes through.
enum class HoleWalls {
  webs,     ///< both webs, at the level z = position
  flanges,  ///< both flanges, at y = +position and y = -position
};

/// A round hole, drilled square through walls of the outer profile. In the section through its
/// centre it takes a strip as wide as its diameter and as deep as the wall.
/// Holes come in pairs symmetric about z, so that bending stays in the plane of motion.
struct Hole {
  std::string name;
  Length diameter;
  HoleWalls walls = HoleWalls::webs;
  Length position;  ///< level z of the centre for webs, |y| of the centres for flanges
};

/// The section between two of the same kind: every dimension varies linearly with `fraction`.
/// Precondition: both have the same profiles.
Section interpolate(const Section& from, const Section& to, double fraction);

/// Whether two sections have the same kinds of profile, so that one can taper into the other.
bool same_kind(const Section& a, const Section& b);

/// What is impossible about a section (a wall thicker than half the profile, a non-positive
/// dimension, an inner profile that does not fit the clear space), or nothing.
std::optional<std::string> defect_of(const Section& section);

/// Outside height (along z) of a profile.
Length height_of(const Profile& profile);

/// Wall thickness that decides the yield strength at level z: the flange beyond the clear height
/// of a hollow rectangle, the web within it, the wall of a tube.
Length wall_at(const Profile& profile, Length z);

/// Half of the clear height inside a profile: the level where the webs meet the flanges.
Length half_clear_height(const Profile& profile);

}  // namespace boxbeam
