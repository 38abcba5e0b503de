#include "boxbeam/section/path_webs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxbeam {
namespace {

Eigen::Vector2d node_of(const ThinWalled& path, std::size_t number) {
  const SectionPlace& of = path.nodes[number];
  return {of.y.value(), of.z.value()};
}

bool is_steep(const ThinWalled& path, const ThinWall& wall) {
  const Eigen::Vector2d way = node_of(path, wall.to) - node_of(path, wall.from);
  return std::abs(way.y()) > std::abs(way.x());
}

/// Walls that hang together by steep walls, as the least number of one of their nodes.
std::vector<std::size_t> steep_ways_of(const ThinWalled& path) {
  std::vector<std::size_t> way(path.nodes.size());
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (const ThinWall& wall : path.walls) {
      if (!is_steep(path, wall) || way[wall.from] == way[wall.to]) continue;
      way[wall.from] = way[wall.to] = std::min(way[wall.from], way[wall.to]);
      changed = true;
    }
  }
  return way;
}

double distance_to(const ThinWalled& path, const ThinWall& wall, const Eigen::Vector2d& place) {
  const Eigen::Vector2d from = node_of(path, wall.from), way = node_of(path, wall.to) - from;
  const double along = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (place - from - along * way).norm();
}

}  // namespace

std::vector<std::size_t> webs_of(const ThinWalled& path) {
  const std::vector<std::size_t> way = steep_ways_of(path);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> low(way.size(), infinite), high(way.size(), -infinite);
  double lowest = infinite, highest = -infinite;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const double z = path.nodes[i].z.value();
    low[way[i]] = std::min(low[way[i]], z);
    high[way[i]] = std::max(high[way[i]], z);
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  // Both ends of a way meet walls that are not steep.
  const double near = 1e-9 * (highest - lowest);
  std::vector<bool> at_low(way.size(), false), at_high(way.size(), false);
  for (const ThinWall& wall : path.walls) {
    if (is_steep(path, wall)) continue;
    for (const std::size_t node : {wall.from, wall.to}) {
      const double z = path.nodes[node].z.value();
      if (z <= low[way[node]] + near) at_low[way[node]] = true;
      if (z >= high[way[node]] - near) at_high[way[node]] = true;
    }
  }
  std::vector<std::size_t> webs;
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    const ThinWall& wall = path.walls[i];
    const std::size_t of = way[wall.from];
    const bool spans = high[of] - low[of] >= 0.5 * (highest - lowest) - near;
    if (is_steep(path, wall) && spans && at_low[of] && at_high[of]) webs.push_back(i);
  }
  return webs;
}

SectionPart part_in(const ThinWalled& path, const std::vector<std::size_t>& webs, Length y,
                    Length z) {
  const Eigen::Vector2d place(y.value(), z.value());
  double half = 0.0;  // of the thickest web there
  constexpr double slack = 1.0 + 1e-6;
  for (const std::size_t i : webs) {
    const double own = 0.5 * path.walls[i].thickness.value();
    if (distance_to(path, path.walls[i], place) <= slack * own) half = std::max(half, own);
  }
  if (half == 0.0) return SectionPart::fibre;
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    if (std::find(webs.begin(), webs.end(), i) != webs.end()) continue;
    const double both = half + 0.5 * path.walls[i].thickness.value();
    if (distance_to(path, path.walls[i], place) <= slack * both) return SectionPart::web_end;
  }
  return SectionPart::web;
}

bool has_webs(const Section& section) {
  const auto has = [](const Profile& of) {
    if (const auto* const path = std::get_if<ThinWalled>(&of)) return !webs_of(*path).empty();
    return std::holds_alternative<Box>(of) || std::holds_alternative<RectangularTube>(of);
  };
  return has(section.outer) || (section.inner && has(*section.inner));
}

}  // namespace boxbeam
