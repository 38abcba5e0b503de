#include "boxbeam/section/section_defect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace boxbeam {
namespace {

using Defect = std::optional<std::string>;

// A profile that fits exactly must not be refused for the round-off of two subtractions.
constexpr double slack = 1e-12;

std::string mm(Length x) { return fmt::format("{:.6g} mm", x.value() * 1e3); }

/// "two webs of 10 mm", "webs of 10 mm and 12 mm".
std::string both(const char* plates, Length one, Length other) {
  if (one == other) return fmt::format("two {} of {}", plates, mm(one));
  return fmt::format("{} of {} and {}", plates, mm(one), mm(other));
}

/// An upright rectangle, for what must not overlap.
struct Rectangle {
  double y_low, y_high, z_low, z_high;
};

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.y_low < b.y_high - slack && b.y_low < a.y_high - slack && a.z_low < b.z_high - slack &&
         b.z_low < a.z_high - slack;
}

Rectangle clear_space_of(const Box& box) {
  return {(box.right_web - 0.5 * box.width).value(), (0.5 * box.width - box.left_web).value(),
          (box.bottom_flange - 0.5 * box.height).value(),
          (0.5 * box.height - box.top_flange).value()};
}

Rectangle rectangle_of(const Stiffener& bar, const Rectangle& clear) {
  const double low = (bar.place - 0.5 * bar.thickness).value();
  const double high = (bar.place + 0.5 * bar.thickness).value();
  const double depth = bar.depth.value();
  switch (bar.plate) {
    case BoxPlate::top_flange: return {low, high, clear.z_high - depth, clear.z_high};
    case BoxPlate::bottom_flange: return {low, high, clear.z_low, clear.z_low + depth};
    case BoxPlate::left_web: return {clear.y_high - depth, clear.y_high, low, high};
    case BoxPlate::right_web: return {clear.y_low, clear.y_low + depth, low, high};
  }
  return {};
}

Defect defect_of(const Box& box) {
  const Length zero;
  if (box.width <= zero || box.height <= zero) return "width and height must be above zero";
  for (const Length& plate : {box.top_flange, box.bottom_flange, box.left_web, box.right_web}) {
    if (plate <= zero) return "every plate thickness must be above zero";
  }
  if (box.seam_throat < zero) return "the throat of the seam must not be below zero";
  if (box.top_flange + box.bottom_flange >= box.height) {
    return fmt::format("{} leave no clear height in {}",
                       both("flanges", box.top_flange, box.bottom_flange), mm(box.height));
  }
  if (box.left_web + box.right_web >= box.width) {
    return fmt::format("{} leave no clear width in {}", both("webs", box.left_web, box.right_web),
                       mm(box.width));
  }
  const Rectangle clear = clear_space_of(box);
  std::vector<Rectangle> bars;
  for (const Stiffener& bar : box.stiffeners) {
    const std::string name = fmt::format("stiffener {}", bars.size() + 1);
    if (bar.depth <= zero || bar.thickness <= zero) {
      return name + ": depth and thickness must be above zero";
    }
    const Rectangle at = rectangle_of(bar, clear);
    if (at.y_low < clear.y_low - slack || at.y_high > clear.y_high + slack ||
        at.z_low < clear.z_low - slack || at.z_high > clear.z_high + slack) {
      return name + " does not fit inside the box";
    }
    for (std::size_t i = 0; i < bars.size(); ++i) {
      if (overlap(bars[i], at)) return fmt::format("{} cuts into stiffener {}", name, i + 1);
    }
    bars.push_back(at);
  }
  return std::nullopt;
}

Defect defect_of(const RectangularTube& tube) {
  const Length zero;
  if (tube.width <= zero || tube.height <= zero) return "width and height must be above zero";
  if (tube.wall <= zero) return "every plate thickness must be above zero";
  const Length side = std::min(tube.width, tube.height);
  if (2.0 * tube.wall >= side) {
    return fmt::format("a wall of {} leaves no hollow in {}", mm(tube.wall), mm(side));
  }
  if (tube.outer_radius < zero || tube.inner_radius < zero) {
    return "corner radii must not be below zero";
  }
  if ((tube.outer_radius == zero) != (tube.inner_radius == zero)) {
    return "either both corner radii are zero or none";
  }
  // Where the walls are straight on both faces something must be left.
  const Length corner = std::max(tube.outer_radius, tube.wall + tube.inner_radius);
  if (tube.outer_radius > zero && 2.0 * corner >= side) {
    return fmt::format("corner radii of {} and {} do not fit a side of {}", mm(tube.outer_radius),
                       mm(tube.inner_radius), mm(side));
  }
  return std::nullopt;
}

Defect defect_of(const RoundTube& tube) {
  const Length zero;
  if (tube.diameter <= zero || tube.wall <= zero) return "diameter and wall must be above zero";
  if (2.0 * tube.wall >= tube.diameter) {
    return fmt::format("a wall of {} leaves no hollow in a diameter of {}", mm(tube.wall),
                       mm(tube.diameter));
  }
  return std::nullopt;
}

Defect defect_of(const Plate& plate) {
  if (plate.width <= Length{} || plate.height <= Length{}) {
    return "width and height must be above zero";
  }
  return std::nullopt;
}

double cross(const SectionPlace& o, const SectionPlace& a, const SectionPlace& b) {
  return ((a.y - o.y) * (b.z - o.z) - (a.z - o.z) * (b.y - o.y)).value();
}

bool on_segment(const SectionPlace& a, const SectionPlace& b, const SectionPlace& p) {
  return std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y) && std::min(a.z, b.z) <= p.z &&
         p.z <= std::max(a.z, b.z);
}

/// Whether two straight lines have a point in common.
bool meet(const SectionPlace& a, const SectionPlace& b, const SectionPlace& c,
          const SectionPlace& d) {
  const double abc = cross(a, b, c), abd = cross(a, b, d);
  const double cda = cross(c, d, a), cdb = cross(c, d, b);
  if (((abc > 0.0 && abd < 0.0) || (abc < 0.0 && abd > 0.0)) &&
      ((cda > 0.0 && cdb < 0.0) || (cda < 0.0 && cdb > 0.0))) {
    return true;
  }
  return (abc == 0.0 && on_segment(a, b, c)) || (abd == 0.0 && on_segment(a, b, d)) ||
         (cda == 0.0 && on_segment(c, d, a)) || (cdb == 0.0 && on_segment(c, d, b));
}

using Loop = std::vector<SectionPlace>;

const SectionPlace& corner(const Loop& loop, std::size_t i) { return loop[i % loop.size()]; }

double area_of(const Loop& loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    twice += cross(SectionPlace{}, corner(loop, i), corner(loop, i + 1));
  }
  return 0.5 * twice;
}

Defect defect_of(const Loop& loop) {
  if (loop.size() < 3) return "a loop wants at least three corners";
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (std::size_t j = i + 1; j < loop.size(); ++j) {
      if (corner(loop, i) == corner(loop, j)) {
        return fmt::format("the corners {} and {} are the same place", i + 1, j + 1);
      }
    }
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (std::size_t j = i + 2; j < loop.size(); ++j) {
      if (i == 0 && j + 1 == loop.size()) continue;  // neighbours round the end
      if (meet(corner(loop, i), corner(loop, i + 1), corner(loop, j), corner(loop, j + 1))) {
        return fmt::format("the sides behind the corners {} and {} cross each other", i + 1, j + 1);
      }
    }
  }
  if (area_of(loop) == 0.0) return "the loop encloses no area";
  return std::nullopt;
}

bool cross_each_other(const Loop& a, const Loop& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (meet(corner(a, i), corner(a, i + 1), corner(b, j), corner(b, j + 1))) return true;
    }
  }
  return false;
}

bool contains(const Loop& loop, const SectionPlace& p) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const SectionPlace& a = corner(loop, i);
    const SectionPlace& b = corner(loop, i + 1);
    if ((a.z > p.z) == (b.z > p.z)) continue;
    if (p.y < a.y + (b.y - a.y) * ((p.z - a.z) / (b.z - a.z))) inside = !inside;
  }
  return inside;
}

Defect defect_of(const Polygon& polygon) {
  if (auto defect = defect_of(polygon.outer)) return defect;
  for (std::size_t i = 0; i < polygon.hollows.size(); ++i) {
    const Loop& hollow = polygon.hollows[i];
    if (auto defect = defect_of(hollow)) return fmt::format("hollow {}: {}", i + 1, *defect);
    if (cross_each_other(polygon.outer, hollow) || !contains(polygon.outer, hollow.front())) {
      return fmt::format("hollow {} does not lie inside the outer loop", i + 1);
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Loop& other = polygon.hollows[j];
      if (cross_each_other(other, hollow) || contains(other, hollow.front()) ||
          contains(hollow, other.front())) {
        return fmt::format("the hollows {} and {} overlap", j + 1, i + 1);
      }
    }
  }
  return std::nullopt;
}

Defect defect_of(const ThinWalled& path) {
  if (path.walls.empty()) return "it has no wall";
  std::vector<std::size_t> group(path.nodes.size());  // nodes that hang together share a number
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<bool> used(path.nodes.size(), false);
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    const ThinWall& wall = path.walls[i];
    const std::string name = fmt::format("wall {}", i + 1);
    if (wall.thickness <= Length{}) return name + ": the thickness must be above zero";
    const SectionPlace& a = path.nodes[wall.from];
    const SectionPlace& b = path.nodes[wall.to];
    const Length way = hypot(b.y - a.y, b.z - a.z);
    if (way.value() == 0.0) return name + " begins and ends at the same place";
    if (wall.trim_from + wall.trim_to >= way) return name + " is trimmed to nothing";
    const std::size_t old = group[wall.to];
    std::replace(group.begin(), group.end(), old, group[wall.from]);
    used[wall.from] = used[wall.to] = true;
  }
  for (std::size_t i = 0; i < path.walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const ThinWall& one = path.walls[j];
      const ThinWall& other = path.walls[i];
      const bool neighbours = one.from == other.from || one.from == other.to ||
                              one.to == other.from || one.to == other.to;
      if (!neighbours && meet(path.nodes[one.from], path.nodes[one.to], path.nodes[other.from],
                              path.nodes[other.to])) {
        return fmt::format("the walls {} and {} cross where there is no node", j + 1, i + 1);
      }
    }
  }
  for (std::size_t i = 0; i < path.nodes.size(); ++i) {
    if (!used[i] || group[i] != group[path.walls[0].from]) {
      return "not all nodes and walls hang together";
    }
  }
  return std::nullopt;
}

Defect defect_of(const Profile& profile) {
  return std::visit([](const auto& shape) { return defect_of(shape); }, profile);
}

/// The rectangle, inside a box or tube, in which an inner profile has room.
std::optional<std::array<Length, 2>> clear_rectangle_of(const Profile& outer) {
  if (const auto* box = std::get_if<Box>(&outer)) {
    // The inner profile shares the axis: the thicker of two opposite plates decides.
    return std::array{box->width - 2.0 * std::max(box->left_web, box->right_web),
                      box->height - 2.0 * std::max(box->top_flange, box->bottom_flange)};
  }
  if (const auto* tube = std::get_if<RectangularTube>(&outer)) {
    return std::array{tube->width - 2.0 * tube->wall, tube->height - 2.0 * tube->wall};
  }
  return std::nullopt;
}

bool is_hollow_section(const Profile& profile) {
  return std::holds_alternative<Box>(profile) || std::holds_alternative<RectangularTube>(profile) ||
         std::holds_alternative<RoundTube>(profile);
}

Defect misfit_of(const Profile& outer, const Profile& inner) {
  if (!is_hollow_section(outer) || !is_hollow_section(inner)) {
    return "only boxes and tubes can stand in one another";
  }
  const Extent extent = extent_of(inner);
  const Length width = extent.y_high - extent.y_low;
  const Length height = extent.z_high - extent.z_low;
  if (const auto* box = std::get_if<Box>(&outer); box != nullptr && !box->stiffeners.empty()) {
    return "the outer box has stiffeners where the inner profile stands";
  }
  if (const auto clear = clear_rectangle_of(outer)) {
    const auto& [clear_width, clear_height] = *clear;
    if (width.value() <= clear_width.value() + slack &&
        height.value() <= clear_height.value() + slack) {
      return std::nullopt;
    }
    return fmt::format(
        "the inner profile, {} x {}, does not fit the clear {} x {} of the outer one", mm(width),
        mm(height), mm(clear_width), mm(clear_height));
  }
  const auto& tube = std::get<RoundTube>(outer);
  const Length clear = tube.diameter - 2.0 * tube.wall;
  const bool round = std::holds_alternative<RoundTube>(inner);
  const double reach = round ? width.value() : std::hypot(width.value(), height.value());
  if (reach <= clear.value() + slack) return std::nullopt;
  return fmt::format("the inner profile needs {} and does not fit the clear diameter {}",
                     mm(si<Length>(reach)), mm(clear));
}

}  // namespace

Defect defect_of(const Section& section) {
  if (auto defect = defect_of(section.outer)) return defect;
  if (!section.inner) return std::nullopt;
  if (auto defect = defect_of(*section.inner)) return "inner profile: " + *defect;
  return misfit_of(section.outer, *section.inner);
}

std::optional<std::string> foil_in(const Section& section) {
  constexpr double thinnest = 1e-4;
  const auto thin = [&](const Profile& profile) {
    const Extent extent = extent_of(profile);
    const Length size = std::max(extent.y_high - extent.y_low, extent.z_high - extent.z_low);
    Length least = size;
    if (const auto* box = std::get_if<Box>(&profile))
      least = std::min({box->top_flange, box->bottom_flange, box->left_web, box->right_web},
                       std::less<>());
    else if (const auto* tube = std::get_if<RectangularTube>(&profile))
      least = tube->wall;
    else if (const auto* pipe = std::get_if<RoundTube>(&profile))
      least = pipe->wall;
    else if (const auto* path = std::get_if<ThinWalled>(&profile))
      for (const ThinWall& wall : path->walls) least = std::min(least, wall.thickness);
    return least < thinnest * size
               ? std::optional(fmt::format("{} thin in a profile of {}", mm(least), mm(size)))
               : std::nullopt;
  };
  auto found = thin(section.outer);
  if (!found && section.inner) found = thin(*section.inner);
  return found;
}

}  // namespace boxbeam
