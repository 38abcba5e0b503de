#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "boxbeam/section/wall_graph.hpp"

namespace boxbeam {

/// Elements across a plate.
inline constexpr std::size_t columns_across = 4;
/// Positions on a plate's mid-line: ends and middles of its elements.
inline constexpr std::size_t positions_of_plate = 2 * columns_across;
/// A plate between two corners of a profile's mid-line.
struct PlateLine {
  std::size_t from = 0, to = 0;
  double thickness = 0.0;
  WallPart part = WallPart::path;
};

/// A profile by the mid-lines of its plates, each beginning where the one before it ends.
struct MidLines {
  std::vector<Eigen::Vector2d> corners;
  std::vector<PlateLine> plates;
  bool closed = true;
  bool inner = false;

  std::size_t count() const { return plates.size() * positions_of_plate + (closed ? 0 : 1); }
  std::size_t next(std::size_t position, std::size_t by) const {
    return closed ? (position + by) % count() : position + by;
  }
  Eigen::Vector2d at(std::size_t position) const {
    const std::size_t plate = std::min(position / positions_of_plate, plates.size() - 1);
    const double fraction = static_cast<double>(position - plate * positions_of_plate) /
                            static_cast<double>(positions_of_plate);
    const PlateLine& of = plates[plate];
    return corners[of.from] + fraction * (corners[of.to] - corners[of.from]);
  }
};

/// Of boxes, rectangular tubes and upright plates; nothing of other profiles.
std::optional<MidLines> mid_lines_of(const Profile& profile);
/// The outer profile, then the inner one. Precondition: both have mid-lines.
std::vector<MidLines> mid_lines_of(const Section& section);

/// Whether both have their corners at the same places.
bool same_corners(const MidLines& a, const MidLines& b);

}  // namespace boxbeam
