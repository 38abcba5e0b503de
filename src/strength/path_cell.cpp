#include "path_cell.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace boxbeam {
namespace {

constexpr double round_off = 1e-9;  // of the sum of both sides

bool alike(Length a, Length b, Length size) { return abs(a - b) <= round_off * size; }

/// How many of the walls that count meet at each node.
std::vector<std::size_t> meeting(const ThinWalled& path, const std::vector<bool>& counts) {
  std::vector<std::size_t> number(path.nodes.size(), 0);
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    if (!counts[i]) continue;
    ++number[path.walls[i].from];
    ++number[path.walls[i].to];
  }
  return number;
}

/// Walls that lead around cells: what ends freely is taken off, one after the other.
std::vector<bool> around_cells(const ThinWalled& path) {
  std::vector<bool> around(path.walls.size(), true);
  for (bool changed = true; changed;) {
    changed = false;
    const std::vector<std::size_t> number = meeting(path, around);
    for (std::size_t i = 0; i < path.walls.size(); ++i) {
      const ThinWall& wall = path.walls[i];
      if (!around[i] || (number[wall.from] > 1 && number[wall.to] > 1)) continue;
      around[i] = false;
      changed = true;
    }
  }
  return around;
}

/// The lines around the nodes of these walls; nothing of it says that walls lie on them.
PathCell lines_around(const ThinWalled& path, const std::vector<bool>& around) {
  PathCell of;
  bool first = true;
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    if (!around[i]) continue;
    for (const std::size_t node : {path.walls[i].from, path.walls[i].to}) {
      const SectionPlace& at = path.nodes[node];
      of.left = first ? at.y : std::max(of.left, at.y);
      of.right = first ? at.y : std::min(of.right, at.y);
      of.top = first ? at.z : std::max(of.top, at.z);
      of.bottom = first ? at.z : std::min(of.bottom, at.z);
      first = false;
    }
  }
  of.cell.width = of.left - of.right;
  of.cell.height = of.top - of.bottom;
  return of;
}

/// Of which plate of the cell a wall is part or leads it on.
std::optional<BoxPlate> plate_of(const PathCell& of, const SectionPlace& a, const SectionPlace& b) {
  using enum BoxPlate;
  const Length size = of.cell.width + of.cell.height;
  const auto lies = [&](Length p, Length q, Length on) {
    return alike(p, on, size) && alike(q, on, size);
  };
  if (lies(a.z, b.z, of.top)) return top_flange;
  if (lies(a.z, b.z, of.bottom)) return bottom_flange;
  if (lies(a.y, b.y, of.left)) return left_web;
  if (lies(a.y, b.y, of.right)) return right_web;
  return std::nullopt;
}

/// Places on it would lie outside the plate that it leads on.
bool leads_on_thicker(const ThinWalled& path, const std::vector<bool>& around, const PathCell& of) {
  const Length near = round_off * (of.cell.width + of.cell.height);
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    const ThinWall& wall = path.walls[i];
    const auto plate = plate_of(of, path.nodes[wall.from], path.nodes[wall.to]);
    if (!around[i] && plate &&
        wall.thickness > of.cell.thickness[static_cast<std::size_t>(*plate)] + near)
      return true;
  }
  return false;
}

bool lies_within(const PathCell& of, const SectionPlace& at) {
  const Length near = round_off * (of.cell.width + of.cell.height);
  return at.y <= of.left + near && at.y >= of.right - near && at.z <= of.top + near &&
         at.z >= of.bottom - near;
}

}  // namespace

std::optional<PathCell> path_cell_of(const ThinWalled& path) {
  const std::vector<bool> around = around_cells(path);
  PathCell of = lines_around(path, around);
  if (!(of.cell.width > Length{}) || !(of.cell.height > Length{})) return std::nullopt;
  for (const std::size_t number : meeting(path, around))
    if (number != 0 && number != 2) return std::nullopt;
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    const ThinWall& wall = path.walls[i];
    const SectionPlace &a = path.nodes[wall.from], &b = path.nodes[wall.to];
    const auto plate = plate_of(of, a, b);
    if (!around[i]) {
      if (!plate && !(lies_within(of, a) && lies_within(of, b))) return std::nullopt;
      continue;
    }
    if (!plate) return std::nullopt;
    Length& thickness = of.cell.thickness[static_cast<std::size_t>(*plate)];
    const Length size = of.cell.width + of.cell.height;
    if (thickness > Length{} && !alike(thickness, wall.thickness, size)) return std::nullopt;
    thickness = wall.thickness;
  }
  return leads_on_thicker(path, around, of) ? std::nullopt : std::optional(of);
}

}  // namespace boxbeam
