#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/core/units.hpp"

/// Cross-sections: the beam axis is x, z the left normal of the axis in the plane of motion (the
/// height of a section), y across (its width; +y is left when looking along +x with +z up). Origin
/// on the beam axis: at mid-height and mid-width of profiles that have a width and a height.
namespace boxbeam {

/// A place in a section.
struct SectionPlace {
  Length y, z;

  friend bool operator==(const SectionPlace&, const SectionPlace&) = default;
};

/// The plates of a box: +z is top, +y is left.
enum class BoxPlate { top_flange, bottom_flange, left_web, right_web };

/// A flat bar along a box, welded square onto the inside of a plate.
struct Stiffener {
  BoxPlate plate = BoxPlate::top_flange;
  Length place;  ///< y of its middle on a flange, z on a web
  Length depth;  ///< from the inner face of the plate
  Length thickness;

  friend bool operator==(const Stiffener&, const Stiffener&) = default;
};

/// A welded box of two flanges as wide as the box and two webs between them. Sharp corners.
struct Box {
  Length width;                                           ///< along y, outside
  Length height;                                          ///< along z, outside
  Length top_flange, bottom_flange, left_web, right_web;  ///< thicknesses
  std::vector<Stiffener> stiffeners = {};
  /// Throat of the seam between web and flange, all welds of one seam together; zero means full
  /// penetration, where the web's thickness carries.
  Length seam_throat = {};

  friend bool operator==(const Box&, const Box&) = default;
};

/// A box of two equal flanges and two equal webs, without stiffeners.
Box symmetric_box(Length width, Length height, Length flange, Length web);

/// A rectangular tube of one wall, rolled or folded. Radii of zero are sharp corners.
struct RectangularTube {
  Length width, height, wall;
  Length outer_radius = {}, inner_radius = {};

  friend bool operator==(const RectangularTube&, const RectangularTube&) = default;
};

/// A round tube.
struct RoundTube {
  Length diameter;  ///< outside
  Length wall;

  friend bool operator==(const RoundTube&, const RoundTube&) = default;
};

/// A solid rectangle.
struct Plate {
  Length width;   ///< along y
  Length height;  ///< along z

  friend bool operator==(const Plate&, const Plate&) = default;
};

/// A solid of any straight-edged shape, possibly with hollows. Loops in any sense of turning.
struct Polygon {
  std::vector<SectionPlace> outer;
  std::vector<std::vector<SectionPlace>> hollows = {};

  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// A straight wall between two nodes of a thin-walled section.
struct ThinWall {
  std::size_t from = 0, to = 0;
  Length thickness;
  /// How much shorter than the way between the nodes the plate is at each end: half the thickness
  /// of the wall it butts against. Material is counted exactly once then.
  Length trim_from = {}, trim_to = {};

  friend bool operator==(const ThinWall&, const ThinWall&) = default;
};

/// Straight walls along their mid-lines, open, branched, or around any number of cells.
struct ThinWalled {
  std::vector<SectionPlace> nodes;
  std::vector<ThinWall> walls;

  friend bool operator==(const ThinWalled&, const ThinWalled&) = default;
};

using Profile = std::variant<Box, RectangularTube, RoundTube, Plate, Polygon, ThinWalled>;

/// A profile, and possibly a second one inside that shares its axis and acts together with it.
struct Section {
  Profile outer;
  std::optional<Profile> inner;

  friend bool operator==(const Section&, const Section&) = default;
};

/// The walls of a section that a hole goes through.
enum class HoleWalls {
  webs,     ///< both webs of a box or tube, or a plate along y, at the level z = position
  flanges,  ///< both flanges, or a plate along z, at y = +position and y = -position
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

/// Whether holes are known in a profile: boxes, rectangular tubes and plates.
bool takes_holes(const Profile& profile);

/// "box", "rectangular tube", ...
const char* to_text(const Profile& profile);

/// The section between two of the same kind: every dimension and every place varies linearly with
/// `fraction`. Precondition: same_kind.
Section interpolate(const Section& from, const Section& to, double fraction);

/// Whether two sections have the same kinds of profile and, in them, the same plates, stiffeners,
/// vertices and walls in the same order, so that one can taper into the other.
bool same_kind(const Section& a, const Section& b);

/// Whether the left half of a section mirrors its right half. Polygons and thin-walled paths are
/// not looked into and count as unsymmetric.
bool is_symmetric_about_z(const Section& section);

/// How far a profile reaches from the beam axis.
struct Extent {
  Length y_low, y_high, z_low, z_high;
};

Extent extent_of(const Profile& profile);

/// Every length that shapes a section, in an order of its own kind: sizes, thicknesses, places.
std::vector<Length> dimensions_of(const Section& section);

/// The thicknesses of a section's plates and walls, stiffeners and inner profile included.
std::vector<Length> thicknesses_of(const Section& section);

/// Outside height (along z) of a profile.
Length height_of(const Profile& profile);

/// Wall thickness that decides the yield strength at level z: the flange beyond the clear height of
/// a box, the thicker web within it; the wall of a tube; of a plate its smaller side, of a polygon
/// the smaller side of the rectangle around it; the thickest wall of a thin-walled path.
Length wall_at(const Profile& profile, Length z);

/// The same of a section: where an inner profile stands beside the walls of the outer one, the
/// thicker of both, which is the weaker.
Length wall_at(const Section& section, Length z);

/// The thickness that decides at level z in a wall of the outer profile: its own, or that of an
/// inner profile that stands beside it, whichever is thicker.
Length beside_inner(const Section& section, Length wall, Length z);

/// Levels of the inner faces of the flanges, where the webs end; of other profiles of the outermost
/// fibres, of a round tube less its wall.
Length clear_top_of(const Profile& profile);
Length clear_bottom_of(const Profile& profile);

}  // namespace boxbeam
