#include "boxbeam/section/section_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/section/section_properties.hpp"
#include "solid_points.hpp"
#include "wall_places.hpp"

namespace boxbeam {

using namespace wall_places;

namespace {

/// A fibre of a box or tube in the middle of its top or bottom; sign +1 or -1.
SectionPoint fibre(const StressField& field, const std::string& name, bool inner, double sign) {
  const Profile& profile = inner ? *field.section.inner : field.section.outer;
  const WallGraph& graph = field.flow->at.graph;
  const Extent extent = extent_of(profile);
  const Length z = sign > 0.0 ? extent.z_high : extent.z_low;
  const WallPlace place =
      has_webs(profile)
          ? nearest(graph, sign > 0.0 ? WallPart::top_flange : WallPart::bottom_flange, inner, 0.0)
          : on_round(graph, inner, sign * 0.5 * std::numbers::pi);
  const Length plate = inner ? wall_at(profile, z) : wall_at(field.section, z);
  return wall_point(field, name, place, 0.0, z.value(), 0.0, plate);
}

/// A place on a web, at its mid-line, in space on its outer face.
SectionPoint web_point(const StressField& field, const std::string& name, WallPart web, bool inner,
                       double z, PointSet set = PointSet::in_plane) {
  const WallPlace place = nearest(field.flow->at.graph, web, inner, z);
  const Wall& wall = field.flow->at.graph.walls[place.wall];
  const double y = set == PointSet::in_space ? outer_face_of(wall) : wall.start.x();
  const Length own = si<Length>(wall.thickness);
  const Length plate = inner ? own : beside_inner(field.section, own, si<Length>(z));
  return wall_point(field, name, place, y, z, 0.0, plate);
}

/// Where a web is joined to its flange, by a seam if it is of a box. `at`: which end.
SectionPoint web_end(const StressField& field, const std::string& at, WallPart web, bool inner,
                     double z, PointSet set = PointSet::in_plane) {
  const std::string before = inner ? "inner " : "";
  SectionPoint point = web_point(field, before + "web end " + at, web, inner, z, set);
  point.part = SectionPart::web_end;
  const auto* box = std::get_if<Box>(inner ? &*field.section.inner : &field.section.outer);
  if (box == nullptr) return point;
  const WallPlace place = nearest(field.flow->at.graph, web, inner, z);
  const double throat = box->seam_throat.value() > 0.0
                            ? box->seam_throat.value()
                            : field.flow->at.graph.walls[place.wall].thickness;
  // The weld carries the flow of the mid-line.
  StressInfluence weld;
  set_shear(weld, flow_at(*field.flow, place.wall, place.fraction) / throat);
  point.throat = SeamThroat{before + "seam " + at + " throat", weld};
  return point;
}

void add_tube_points(const StressField& field, bool inner, std::vector<SectionPoint>& points) {
  const Profile& profile = inner ? *field.section.inner : field.section.outer;
  const Extent extent = extent_of(profile);
  const double radius = extent.y_high.value();
  const std::string before = inner ? "inner " : "";
  for (int k = 0; k < 8; ++k) {
    const double angle = 0.25 * std::numbers::pi * k;
    points.push_back(wall_point(field, fmt::format("{}wall at {} deg", before, 45 * k),
                                on_round(field.flow->at.graph, inner, angle),
                                radius * std::cos(angle), radius * std::sin(angle), 0.0,
                                wall_at(profile, Length{})));
  }
}

bool is_rounded(const Profile& profile) {
  const auto* tube = std::get_if<RectangularTube>(&profile);
  return tube != nullptr && tube->outer_radius.value() > 0.0;
}

/// Corners, both webs and the flanges beside them, of a box or rectangular tube.
void add_box_points(const StressField& field, bool inner, PointSet set,
                    std::vector<SectionPoint>& points) {
  const Profile& profile = inner ? *field.section.inner : field.section.outer;
  const WallGraph& graph = field.flow->at.graph;
  const Extent extent = extent_of(profile);
  const std::string before = inner ? "inner " : "";
  const bool space = set == PointSet::in_space;
  const Length middle = properties_of(field.section, field.holes).centroid_z;
  for (const double side : {1.0, -1.0}) {
    const WallPart web = side > 0.0 ? WallPart::left_web : WallPart::right_web;
    const double face = (side > 0.0 ? extent.y_high : extent.y_low).value();
    const std::string y_name = signed_axis(side, 'y');
    for (const double up : {1.0, -1.0}) {
      const WallPart flange = up > 0.0 ? WallPart::top_flange : WallPart::bottom_flange;
      const Length outer = up > 0.0 ? extent.z_high : extent.z_low;
      const Length clear = up > 0.0 ? clear_top_of(profile) : clear_bottom_of(profile);
      const std::string at = fmt::format("{} {}", y_name, signed_axis(up, 'z'));
      // Both faces that meet in an outer corner are free of shear.
      if (!space || !is_rounded(profile)) {
        points.push_back(point_at(field, fmt::format("{}corner {}", before, at), face,
                                  outer.value(), wall_at(profile, outer)));
      }
      if (!space) {
        const Wall& at_web = graph.walls[nearest(graph, web, inner, clear.value()).wall];
        const double y = at_web.start.x() - side * 0.5 * at_web.thickness;
        points.push_back(wall_point(field, fmt::format("{}flange end {}", before, at),
                                    nearest(graph, flange, inner, y), y, outer.value(), 0.0,
                                    wall_at(profile, outer)));
      }
      points.push_back(web_end(field, at, web, inner, clear.value(), set));
    }
    const WallPlace half = nearest(graph, web, inner, 0.0);
    if (!space || graph.walls[half.wall].solid) {
      points.push_back(wall_point(field, fmt::format("{}fibre {}", before, y_name), half, face, 0.0,
                                  0.0, si<Length>(graph.walls[half.wall].thickness)));
    }
    if (!space && (inner || !in_hole(field, middle))) {
      const WallPlace neutral = nearest(graph, web, inner, middle.value());
      points.push_back(wall_point(field, fmt::format("{}neutral axis {}", before, y_name), neutral,
                                  face, middle.value(), 0.0,
                                  si<Length>(graph.walls[neutral.wall].thickness)));
      points.back().neutral = !inner;
    }
  }
}

void add_stiffener_points(const StressField& field, std::vector<SectionPoint>& points) {
  int number = 0;
  const WallGraph& graph = field.flow->at.graph;
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    if (wall.part != WallPart::stiffener) continue;
    points.push_back(wall_point(field, fmt::format("stiffener {} edge", ++number), {i, 1.0},
                                wall.end.x(), wall.end.y(), 0.0, si<Length>(wall.thickness)));
  }
}

void add_path_points(const StressField& field, std::vector<SectionPoint>& points) {
  const WallGraph& graph = field.flow->at.graph;
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    const auto add = [&](const char* where, double fraction) {
      const Eigen::Vector2d along = direction_on(wall, fraction);
      const Eigen::Vector2d left(-along.y(), along.x());
      for (const double face : {1.0, -1.0}) {
        const Eigen::Vector2d at = point_on(wall, fraction) - face * 0.5 * wall.thickness * left;
        points.push_back(wall_point(
            field, fmt::format("wall {} {} {}", i + 1, where, face > 0.0 ? "right" : "left"),
            {i, fraction}, at.x(), at.y(), face, si<Length>(wall.thickness)));
      }
    };
    add("start", 0.0);
    add("middle", 0.5);
    add("end", 1.0);
    // Where the stress of M_y changes its sign the flow of V_z is largest.
    const Eigen::Vector3d plane = field.flow->at.plane.col(1);
    const auto stress = [&](const Eigen::Vector2d& at) {
      return plane.dot(Eigen::Vector3d(1.0, at.x(), at.y()));
    };
    const double first = stress(wall.start), last = stress(wall.end);
    if ((first > 0.0) != (last > 0.0)) add("neutral axis", first / (first - last));
  }
}

/// The middles of the top and the bottom; in space not where a hole is, nor of round tubes, whose
/// wall is looked at all around.
void add_fibres(const StressField& field, bool inner, PointSet set,
                std::vector<SectionPoint>& points) {
  const Profile& profile = inner ? *field.section.inner : field.section.outer;
  const std::string name = inner ? "inner fibre " : "fibre ";
  for (const double up : {1.0, -1.0}) {
    if (set == PointSet::in_space) {
      if (!has_webs(profile)) continue;
      const WallPart flange = up > 0.0 ? WallPart::top_flange : WallPart::bottom_flange;
      const WallGraph& graph = field.flow->at.graph;
      if (!graph.walls[nearest(graph, flange, inner, 0.0).wall].solid) continue;
    }
    points.push_back(fibre(field, name + signed_axis(up, 'z'), inner, up));
  }
}

/// In the plane: of webs that are stressed alike, of one.
void add_web_ends(const StressField& field, bool inner, std::vector<SectionPoint>& points) {
  const Profile& profile = inner ? *field.section.inner : field.section.outer;
  if (!has_webs(profile)) return;
  for (const double up : {1.0, -1.0}) {
    const Length z = up > 0.0 ? clear_top_of(profile) : clear_bottom_of(profile);
    points.push_back(web_end(field, signed_axis(up, 'z'), WallPart::left_web, inner, z.value()));
  }
}

void add_hollow_points(const StressField& field, PointSet set, std::vector<SectionPoint>& points) {
  const Profile& outer = field.section.outer;
  const Length middle = si<Length>(field.sums.z / field.sums.area);
  add_fibres(field, false, set, points);
  if (set == PointSet::in_plane) {
    add_web_ends(field, false, points);
    // In a hole at mid-height there is no neutral fibre.
    for (SectionPoint& point : points_at_level(field, "neutral axis", middle, set)) {
      point.neutral = true;
      points.push_back(std::move(point));
    }
  } else if (has_webs(outer)) {
    add_box_points(field, false, set, points);
  } else if (set == PointSet::all) {
    add_tube_points(field, false, points);
  }
  add_stiffener_points(field, points);
  if (!field.section.inner) return;
  add_fibres(field, true, set, points);
  if (set == PointSet::in_plane) return add_web_ends(field, true, points);
  if (has_webs(*field.section.inner))
    add_box_points(field, true, set, points);
  else if (set == PointSet::all)
    add_tube_points(field, true, points);
}

/// The set with which a section shows all that its shape asks for.
PointSet fitting(PointSet set, const StressField& field) {
  return set == PointSet::in_plane && !is_mirrored(field) ? PointSet::all : set;
}

/// The walls of a path that a level crosses, on both faces; of a wall along it the middle.
std::vector<SectionPoint> path_points_at(const StressField& field, const std::string& name,
                                         double level) {
  std::vector<SectionPoint> points;
  const WallGraph& graph = field.flow->at.graph;
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    const double low = std::min(wall.start.y(), wall.end.y()) - 0.5 * wall.thickness;
    const double high = std::max(wall.start.y(), wall.end.y()) + 0.5 * wall.thickness;
    if (level < low || level > high) continue;
    const double rise = wall.end.y() - wall.start.y();
    const bool flat = std::abs(rise) < wall.thickness;
    const double fraction = flat ? 0.5 : std::clamp((level - wall.start.y()) / rise, 0.0, 1.0);
    const Eigen::Vector2d at = point_on(wall, fraction);
    for (const double face : {1.0, -1.0}) {
      points.push_back(wall_point(
          field, fmt::format("{} wall {} {}", name, i + 1, face > 0.0 ? "right" : "left"),
          {i, fraction}, at.x(), level, face, si<Length>(wall.thickness)));
    }
  }
  return points;
}

/// The places of a level on both sides of a section, for loads in space.
std::vector<SectionPoint> points_at_level_in_space(const StressField& field,
                                                   const std::string& name, Length z) {
  const Profile& outer = field.section.outer;
  const std::string left = name + " +y", right = name + " -y";
  if (const auto* tube = std::get_if<RoundTube>(&outer)) {
    const double middle = 0.5 * (tube->diameter - tube->wall).value();
    const double radius = 0.5 * tube->diameter.value();
    const double angle = std::asin(std::clamp(z.value() / middle, -1.0, 1.0));
    const double y = std::sqrt(std::max(0.0, radius * radius - z.value() * z.value()));
    const WallGraph& graph = field.flow->at.graph;
    const Length plate = wall_at(field.section, z);
    return {wall_point(field, left, on_round(graph, false, angle), y, z.value(), 0.0, plate),
            wall_point(field, right, on_round(graph, false, std::numbers::pi - angle), -y,
                       z.value(), 0.0, plate)};
  }
  if (has_webs(outer)) {
    if (z >= clear_bottom_of(outer) && z <= clear_top_of(outer)) {
      const PointSet set = PointSet::in_space;
      return {web_point(field, left, WallPart::left_web, false, z.value(), set),
              web_point(field, right, WallPart::right_web, false, z.value(), set)};
    }
    std::vector<SectionPoint> points;
    const Extent extent = extent_of(outer);
    for (const auto& [at, y] :
         {std::pair{name, Length{}}, {left, extent.y_high}, {right, extent.y_low}}) {
      SectionPoint point = point_on_flange(field, at, y, z.value() > 0.0 ? 1.0 : -1.0);
      point.z = z;
      const StressInfluence there = normal_influence(field.sums, y.value(), z.value());
      point.influence.normal = point.prismatic.normal = there.normal;
      points.push_back(std::move(point));
    }
    return points;
  }
  if (std::holds_alternative<Plate>(outer)) {
    const double y = extent_of(outer).y_high.value();
    return {plate_point(field, left, y, z.value()), plate_point(field, right, -y, z.value())};
  }
  if (std::holds_alternative<ThinWalled>(outer)) return path_points_at(field, name, z.value());
  return {level_point(field, name, 0.0, z.value())};
}

}  // namespace

StressField stress_field_of(const Section& section, const std::vector<Hole>& holes,
                            const Taper& taper, Prismatic prismatic) {
  StressField field{section, holes, taper, sums_of(outline_of(section, holes)), {}, {}};
  field.flow = shear_flow_of(section, holes, taper);
  if (field.flow && !taper.empty() && prismatic == Prismatic::found)
    field.prismatic = prismatic_flow_of(*field.flow, section);
  return field;
}

bool is_mirrored(const StressField& field) {
  return is_symmetric_about_z(field.section) &&
         std::all_of(field.taper.begin(), field.taper.end(),
                     [](const NearbySection& near) { return is_symmetric_about_z(near.section); });
}

std::vector<SectionPoint> points_of(const StressField& field, PointSet set) {
  const Profile& outer = field.section.outer;
  set = fitting(set, field);
  std::vector<SectionPoint> points;
  constexpr std::size_t usual = 16;
  points.reserve(usual);
  if (std::holds_alternative<Plate>(outer))
    add_plate_points(field, set, points);
  else if (std::holds_alternative<Polygon>(outer))
    add_polygon_points(field, points);
  else if (std::holds_alternative<ThinWalled>(outer) && set != PointSet::in_space)
    add_path_points(field, points);
  else
    add_hollow_points(field, set, points);
  return points;
}

std::vector<SectionPoint> points_at_level(const StressField& field, const std::string& name,
                                          Length z, PointSet set) {
  if (in_hole(field, z)) return {};
  if (set == PointSet::in_space) return points_at_level_in_space(field, name, z);
  const Profile& outer = field.section.outer;
  set = fitting(set, field);
  if (const auto* tube = std::get_if<RoundTube>(&outer)) {
    const double radius = 0.5 * (tube->diameter - tube->wall).value();
    const double angle = std::asin(std::clamp(z.value() / radius, -1.0, 1.0));
    const double y = std::sqrt(std::max(0.0, radius * radius - z.value() * z.value()));
    return {wall_point(field, name, on_round(field.flow->at.graph, false, angle), y, z.value(), 0.0,
                       wall_at(field.section, z))};
  }
  if (has_webs(outer) && z >= clear_bottom_of(outer) && z <= clear_top_of(outer)) {
    if (set == PointSet::in_plane) {
      return {web_point(field, name, WallPart::left_web, false, z.value())};
    }
    return {web_point(field, name + " +y", WallPart::left_web, false, z.value()),
            web_point(field, name + " -y", WallPart::right_web, false, z.value())};
  }
  SectionPoint point = std::holds_alternative<Plate>(outer)
                           ? plate_point(field, name, extent_of(outer).y_high.value(), z.value())
                           : level_point(field, name, 0.0, z.value());
  if (has_webs(outer)) {
    // V_y, M_z and T act along a flange, which a level does not cut.
    const WallPart flange = z.value() > 0.0 ? WallPart::top_flange : WallPart::bottom_flange;
    const WallPlace place = nearest(field.flow->at.graph, flange, false, 0.0);
    const auto take = [&](StressInfluence& influence, const ShearFlow& flow) {
      const CutFactors along = wall_shear(flow, place, 0.0);
      for (const std::size_t k : {cut_force::V_y, cut_force::T, cut_force::M_z}) {
        influence.shear[k] = along[static_cast<Eigen::Index>(k)];
      }
    };
    take(point.influence, *field.flow);
    take(point.prismatic, field.unchanging());
  } else if (!std::holds_alternative<Plate>(outer)) {
    for (StressInfluence* influence : {&point.influence, &point.prismatic}) {
      influence->shear[cut_force::V_y] = influence->shear[cut_force::T] =
          std::numeric_limits<double>::quiet_NaN();
    }
  }
  return {point};
}

SectionPoint point_on_flange(const StressField& field, const std::string& name, Length y,
                             double up) {
  const Profile& outer = field.section.outer;
  const WallGraph& graph = field.flow->at.graph;
  const auto inner_face = [&](WallPart web, double side) {
    const Wall& wall = graph.walls[nearest(graph, web, false, 0.0).wall];
    return wall.start.x() - side * 0.5 * wall.thickness;
  };
  const double between = std::clamp(y.value(), inner_face(WallPart::right_web, -1.0),
                                    inner_face(WallPart::left_web, 1.0));
  const WallPart flange = up > 0.0 ? WallPart::top_flange : WallPart::bottom_flange;
  const Extent extent = extent_of(outer);
  const Length z = up > 0.0 ? extent.z_high : extent.z_low;
  return wall_point(field, name, nearest(graph, flange, false, between), y.value(), z.value(), 0.0,
                    wall_at(field.section, z));
}

SectionPoint point_in_solid(const StressField& field, const std::string& name, double y, double z) {
  return std::holds_alternative<Plate>(field.section.outer) ? plate_point(field, name, y, z)
                                                            : polygon_point(field, name, y, z);
}

std::optional<std::string> unknown_shear_of(const Section& section) {
  if (!std::holds_alternative<Polygon>(section.outer)) return std::nullopt;
  return "the shear stress of V_y and T is not known in a polygon: give it as a plate, a box or a "
         "thin-walled path";
}

}  // namespace boxbeam
