#pragma once

#include <utility>
#include <vector>

#include "boxbeam/section/section.hpp"

/// Thin-walled paths by their dimensions in mm.
namespace paths {

using namespace boxbeam;

inline Length mm(double x) { return si<Length>(1e-3 * x); }
inline SectionPlace mm_place(double y, double z) { return {mm(y), mm(z)}; }

inline std::size_t add_node(ThinWalled& path, const SectionPlace& at) {
  path.nodes.push_back(at);
  return path.nodes.size() - 1;
}

inline void add_wall(ThinWalled& path, std::size_t from, std::size_t to, double thickness,
                     double trim_from = 0.0, double trim_to = 0.0) {
  path.walls.push_back({from, to, mm(thickness), mm(trim_from), mm(trim_to)});
}

/// Of two flanges and the web between their inner faces. Walls: top flange left and right, bottom
/// flange left and right, web.
inline ThinWalled i_section(double width, double top, double depth, double web, double bottom = 0.0,
                            double bottom_width = 0.0) {
  const double lower = bottom > 0.0 ? bottom : top,
               wide = bottom_width > 0.0 ? bottom_width : width;
  const double high = 0.5 * (depth + top), low = -0.5 * (depth + lower);
  ThinWalled path;
  const std::size_t a = add_node(path, mm_place(0.0, high)), b = add_node(path, mm_place(0.0, low));
  add_wall(path, add_node(path, mm_place(0.5 * width, high)), a, top);
  add_wall(path, a, add_node(path, mm_place(-0.5 * width, high)), top);
  add_wall(path, add_node(path, mm_place(0.5 * wide, low)), b, lower);
  add_wall(path, b, add_node(path, mm_place(-0.5 * wide, low)), lower);
  add_wall(path, a, b, web, 0.5 * top, 0.5 * lower);
  return path;
}

/// A box as `Box` has it: its flanges reach beyond the webs' mid-lines to their outer faces. Nodes:
/// top left, top right, bottom left, bottom right; walls: flanges, webs.
inline ThinWalled box_path(double width, double height, double flange, double web,
                           double bottom = 0.0) {
  const double lower = bottom > 0.0 ? bottom : flange;
  const double y = 0.5 * (width - web), high = 0.5 * (height - flange),
               low = 0.5 * (lower - height);
  ThinWalled path;
  const std::size_t a = add_node(path, mm_place(y, high)), b = add_node(path, mm_place(-y, high));
  const std::size_t c = add_node(path, mm_place(y, low)), d = add_node(path, mm_place(-y, low));
  add_wall(path, a, b, flange, -0.5 * web, -0.5 * web);
  add_wall(path, c, d, lower, -0.5 * web, -0.5 * web);
  add_wall(path, a, c, web, 0.5 * flange, 0.5 * lower);
  add_wall(path, b, d, web, 0.5 * flange, 0.5 * lower);
  return path;
}

/// A web along z at y = 0 and flanges to y = width, mid-lines; as long as its walls are.
inline ThinWalled channel(double depth, double width, double web, double flange) {
  const double z = 0.5 * (depth - flange);
  ThinWalled path;
  const std::size_t a = add_node(path, mm_place(width, z)), b = add_node(path, mm_place(0.0, z));
  const std::size_t c = add_node(path, mm_place(0.0, -z));
  add_wall(path, a, b, flange);
  add_wall(path, b, c, web);
  add_wall(path, c, add_node(path, mm_place(width, -z)), flange);
  return path;
}

/// The path with a node at a share of a wall's length.
inline ThinWalled split(ThinWalled path, std::size_t wall, double share) {
  ThinWall& first = path.walls[wall];
  const SectionPlace a = path.nodes[first.from], b = path.nodes[first.to];
  const std::size_t middle = add_node(path, {a.y + share * (b.y - a.y), a.z + share * (b.z - a.z)});
  ThinWall second = first;
  second.from = middle;
  second.trim_from = {};
  first.to = middle;
  first.trim_to = {};
  path.walls.push_back(second);
  return path;
}

/// Puts a node on the wall between two nodes.
inline std::size_t split_at(ThinWalled& path, std::size_t from, std::size_t to,
                            const SectionPlace& at) {
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    if (path.walls[i].from != from || path.walls[i].to != to) continue;
    const SectionPlace &a = path.nodes[from], &b = path.nodes[to];
    path = split(path, i, ((at.y - a.y) / (b.y - a.y)).value());
    return path.nodes.size() - 1;
  }
  return path.nodes.size();
}

}  // namespace paths
