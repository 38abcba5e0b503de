#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "boxbeam/section/wall_graph.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/plate_materials.hpp"

/// The plates that the walls of a thin-walled path are, by what holds them.
namespace boxbeam {

/// How an end of a plate is held.
enum class PlateEnd {
  free,  ///< by nothing
  weak,  ///< by one outstand alone that is too weak to hold it: counts as free
  lip,   ///< by one outstand alone
  held,
};

/// A plate of a path: walls in a row between two ends that hold it, or to a free one.
struct PathPlate {
  /// A wall of the graph, along the plate.
  struct Part {
    std::size_t wall = 0;
    double from = 0.0, to = 0.0;  ///< where its nodes lie along the plate, from its first node [m]
  };
  std::vector<Part> parts;
  std::string name;           ///< "wall 3", "walls 3, 4"
  Eigen::Vector2d first;      ///< its first node [m]
  Eigen::Vector2d direction;  ///< of a straight one
  /// Ends of its clear width along it, on its mid-line: at the faces of what holds it [m].
  double low = 0.0, high = 0.0;
  Length thickness;  ///< of its thinnest wall
  /// The largest yield strength of its walls, by which it buckles, and the least of them; 0 where
  /// one is thicker than its material's table goes.
  Stress class_strength, yield_strength;
  std::array<PlateEnd, 2> ends{};      ///< at low, at high
  std::array<std::size_t, 2> nodes{};  ///< likewise
  bool straight = true;
  bool ribbed = false;     ///< something stands on it between its ends that does not hold it
  StressLevel level = {};  ///< at which it buckles

  Length clear() const { return si<Length>(high - low); }
  /// A place along it.
  Eigen::Vector2d at(double along) const { return first + along * direction; }
  bool outstand() const { return ends[0] <= PlateEnd::weak || ends[1] <= PlateEnd::weak; }
  /// The end that holds an outstand: its high one.
  bool held_at_high() const { return ends[0] <= PlateEnd::weak; }
};

/// The plates of a path.
///
/// Walls that meet at a node in a straight line are one plate unless what else stands on them there
/// holds them: more than an outstand, which reaches at least a quarter of the line's length and
/// half as far as the farthest of all that stands on it (a web does, a rib does not). A line that
/// nothing holds so, nor at an end, is held by whatever reaches half as far as the farthest (the
/// stem of a T). At a fold of less than 20 degrees nothing is held. Outstands alone (one, or the
/// two of a flange) hold the end of a plate where its moment of inertia is that of an edge
/// stiffener,
///
///     I_s = (sum of c)^3 t_c sin^2(theta)/12 >= I_a,  S = 1.28 sqrt(E/f_y)
///     I_a = 399 t^4 [(w/t)/S - 0.328]^3 <= t^4 [115 (w/t)/S + 5],  none up to w/t = 0.328 S
///
/// and, of a plate whose other end is held otherwise (a flange with a lip), where it is at least
/// 0.2 as wide as the plate. Sources: EN 1993-1-1:2005, table 5.2 (plates of I, channel and angle
/// sections); AISI S100, B4.2 (recalled, not confirmed); EN 1993-1-3:2006, 5.2(5); what holds
/// between the ends and the flat fold are bounds of our own, on the safe side.
std::vector<PathPlate> plates_of(const ThinWalled& path, const PlateMaterials& materials);

/// Why a plate beyond class 3 has no effective width here, "" where it has: it is held by a lip, or
/// too weakly, by nothing, is folded, or ribbed.
std::string width_obstacle(const PathPlate& plate);

}  // namespace boxbeam
