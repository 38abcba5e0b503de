#include "boxbeam/section/wall_stretches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "boxbeam/core/angle.hpp"
#include "wall_places.hpp"

namespace boxbeam {

using namespace wall_places;

namespace {

const char* name_of(WallPart part) {
  switch (part) {
    case WallPart::top_flange: return "top flange";
    case WallPart::bottom_flange: return "bottom flange";
    case WallPart::left_web: return "left web";
    case WallPart::right_web: return "right web";
    case WallPart::corner:
    case WallPart::stiffener:
    case WallPart::path: break;
  }
  return "wall";
}

/// The fractions of a wall of a box or tube that lie between the inner faces of its neighbours;
/// nothing where the wall is no such plate, a hole, or the edge of a flange beyond a web.
std::optional<std::pair<double, double>> clear_part_of(const WallGraph& graph, const Wall& wall) {
  const bool web = is_web(wall);
  if (!web && wall.part != WallPart::top_flange && wall.part != WallPart::bottom_flange) return {};
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  const Eigen::Index along = web ? 1 : 0;
  for (const Wall& other : graph.walls) {
    if (other.inner != wall.inner) continue;
    const double face = other.start[along];
    const double half = 0.5 * other.thickness;
    if (other.part == (web ? WallPart::bottom_flange : WallPart::right_web)) low = face + half;
    if (other.part == (web ? WallPart::top_flange : WallPart::left_web)) high = face - half;
  }
  const double start = wall.start[along], length = wall.end[along] - start;
  const double from = std::max(0.0, (low - start) / length);
  const double to = std::min(1.0, (high - start) / length);
  if (!wall.solid || to - from < 1e-9) return {};
  return std::pair{from, to};
}

}  // namespace

namespace {

std::vector<WallStretch> solid_stretches_of(const StressField& field) {
  std::vector<WallStretch> stretches;
  const auto add = [&](const char* name, double y_from, double z_from, double y_to, double z_to) {
    WallStretch& stretch = stretches.emplace_back();
    stretch.name = name;
    stretch.solid = true;
    stretch.low = {si<Length>(y_from), si<Length>(z_from)};
    stretch.high = {si<Length>(y_to), si<Length>(z_to)};
    stretch.plate = wall_at(field.section, Length{});
  };
  const Extent extent = extent_of(field.section.outer);
  const double left = extent.y_high.value(), right = extent.y_low.value();
  const double top = extent.z_high.value(), bottom = extent.z_low.value();
  if (std::holds_alternative<Plate>(field.section.outer)) {
    add("side +y", left, bottom, left, top);
    stretches.back().left_side = true;
    add("side -y", right, bottom, right, top);
    add("top", right, top, left, top);
    add("bottom", right, bottom, left, bottom);
  } else if (std::holds_alternative<Polygon>(field.section.outer)) {
    const double y = field.sums.y / field.sums.area;
    add("height", y, bottom, y, top);
  }
  return stretches;
}

}  // namespace

std::vector<WallStretch> wall_stretches_of(const StressField& field) {
  std::vector<WallStretch> stretches;
  if (!field.flow) return solid_stretches_of(field);
  const WallGraph& graph = field.flow->at.graph;
  for (const bool inner : {false, true}) {
    if (inner && !field.section.inner) continue;
    const Profile& profile = inner ? *field.section.inner : field.section.outer;
    const std::string before = inner ? "inner " : "";
    if (std::holds_alternative<RoundTube>(profile)) {
      WallStretch around;
      around.name = before + "wall";
      around.round = true;
      around.inner = inner;
      around.plate = inner ? wall_at(profile, Length{}) : wall_at(field.section, Length{});
      stretches.push_back(around);
      continue;
    }
    const bool path = std::holds_alternative<ThinWalled>(profile);
    int parts[6] = {};
    for (std::size_t i = 0; i < graph.walls.size(); ++i) {
      const Wall& wall = graph.walls[i];
      if (wall.inner != inner) continue;
      WallStretch stretch;
      stretch.inner = inner;
      stretch.wall = i;
      if (path) {
        stretch.plate = si<Length>(wall.thickness);
        for (const double face : {1.0, -1.0}) {
          stretch.face = face;
          stretch.name = fmt::format("{}wall {} {}", before, i + 1, face > 0.0 ? "right" : "left");
          stretches.push_back(stretch);
        }
        continue;
      }
      if (wall.part == WallPart::corner) {
        stretch.name = fmt::format("{}corner {} {}", before, signed_axis(wall.centre.x(), 'y'),
                                   signed_axis(wall.centre.y(), 'z'));
        stretch.plate = wall_at(profile, Length{});
        stretches.push_back(stretch);
        continue;
      }
      const auto clear = clear_part_of(graph, wall);
      if (!clear) continue;
      std::tie(stretch.from, stretch.to) = *clear;
      const int number = ++parts[static_cast<std::size_t>(wall.part)];
      stretch.name = before + name_of(wall.part) + (number > 1 ? fmt::format(" {}", number) : "");
      const Length z =
          si<Length>(is_web(wall) ? 0.5 * (wall.start.y() + wall.end.y()) : outer_face_of(wall));
      const Length thickness = si<Length>(wall.thickness);
      stretch.plate = inner ? thickness : beside_inner(field.section, thickness, z);
      stretches.push_back(stretch);
    }
  }
  return stretches;
}

SectionPoint point_on_stretch(const StressField& field, const WallStretch& stretch, double part) {
  if (stretch.solid) {
    const auto mix = [&](Length SectionPlace::*of) {
      return (stretch.low.*of + part * (stretch.high.*of - stretch.low.*of)).value();
    };
    return point_in_solid(field, stretch.name, mix(&SectionPlace::y), mix(&SectionPlace::z));
  }
  const WallGraph& graph = field.flow->at.graph;
  if (stretch.round) {
    const Profile& profile = stretch.inner ? *field.section.inner : field.section.outer;
    const double radius = 0.5 * std::get<RoundTube>(profile).diameter.value();
    const double angle = full_turn * part;
    return wall_point(field, stretch.name, on_round(graph, stretch.inner, angle),
                      radius * std::cos(angle), radius * std::sin(angle), 0.0, stretch.plate);
  }
  const Wall& wall = graph.walls[stretch.wall];
  const double fraction = stretch.from + part * (stretch.to - stretch.from);
  Eigen::Vector2d at = point_on(wall, fraction);
  if (wall.part == WallPart::corner) {
    // On the rounding itself, whose centre is not that of the mid-line where its radius is small.
    const auto& tube =
        std::get<RectangularTube>(stretch.inner ? *field.section.inner : field.section.outer);
    const double radius = tube.outer_radius.value(), angle = wall.angle + fraction * wall.sweep;
    const Eigen::Vector2d reach(0.5 * tube.width.value() - radius,
                                0.5 * tube.height.value() - radius);
    at = Eigen::Vector2d(std::copysign(reach.x(), wall.centre.x()),
                         std::copysign(reach.y(), wall.centre.y())) +
         radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  } else if (stretch.face == 0.0) {
    at[is_web(wall) ? 0 : 1] = outer_face_of(wall);
  } else {
    const Eigen::Vector2d along = direction_on(wall, fraction);
    at -= stretch.face * 0.5 * wall.thickness * Eigen::Vector2d(-along.y(), along.x());
  }
  return wall_point(field, stretch.name, {stretch.wall, fraction}, at.x(), at.y(), stretch.face,
                    stretch.plate);
}

}  // namespace boxbeam
