#include "flat_plates.hpp"

#include <cmath>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/effective_path.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;

void set_force(FlatPlate& plate, const AreaSums& gross, const Extent& extent, Area area) {
  plate.area = area;
  const StressInfluence of = normal_influence(gross, plate.middle().x(), plate.middle().y());
  for (std::size_t k = 0; k < cut_force::count; ++k) plate.force[k] = area.value() * of.normal[k];
  for (const std::size_t half : {0U, 1U}) {
    const Vector2d centre = 0.5 * (plate.middle() + plate.ends[half]);
    const StressInfluence at = normal_influence(gross, centre.x(), centre.y());
    for (std::size_t k = 0; k < cut_force::count; ++k)
      plate.halves[half][k] = 0.5 * area.value() * at.normal[k];
  }
  plate.high = plate.across_z() ? plate.middle().y() > 0.5 * (extent.z_low + extent.z_high).value()
                                : plate.middle().x() > 0.5 * (extent.y_low + extent.y_high).value();
}

std::vector<FlatPlate> plates_of_box(const Section& section, const FourWalls& walls,
                                     const FourWalls& from, const FourWalls& to, double length) {
  const AreaSums gross = sums_of(outline_of(section, {}));
  const Extent extent = extent_of(section.outer);
  std::vector<FlatPlate> plates;
  for (const BoxPlate of : box_plates) {
    const bool flange = is_flange(of);
    const auto ends = [&](const FourWalls& at) {
      const BoxWall& wall = at.of(of);
      const auto point = [&](Length along) {
        return flange ? Vector2d(along.value(), wall.middle.value())
                      : Vector2d(wall.middle.value(), along.value());
      };
      return std::array{point(wall.low), point(wall.high)};
    };
    const BoxWall& wall = walls.of(of);
    FlatPlate& plate = plates.emplace_back();
    plate.name = to_text(of);
    plate.called = "the " + plate.name;
    plate.ends = ends(walls);
    const auto before = ends(from), behind = ends(to);
    for (const std::size_t k : {0U, 1U}) {
      plate.slopes[k] = (behind[k] - before[k]) / length;
      plate.nodes[k] = 2 * static_cast<std::size_t>(of) + k;  // its own
    }
    plate.thickness = wall.thickness.value();
    plate.clear = wall.clear();
    plate.yield_strength = wall.yield_strength;
    Area area = (flange ? Length(extent.y_high - extent.y_low) : wall.clear()) * wall.thickness;
    // Flats along it turn off with it.
    plate.inside = wall.clear() * wall.thickness;
    for (const FlatStiffener& bar : wall.stiffeners) {
      area += bar.depth * bar.thickness;
      plate.inside += bar.depth * bar.thickness;
    }
    set_force(plate, gross, extent, area);
  }
  return plates;
}

std::vector<FlatPlate> plates_of_path(const Section& section, const PathSection& path,
                                      const ThinWalled& from, const ThinWalled& to, double length) {
  const AreaSums gross = sums_of(outline_of(section, {}));
  const Extent extent = extent_of(section.outer);
  const auto slope_of = [&](std::size_t node) {
    const SectionPlace &a = from.nodes[node], &b = to.nodes[node];
    return Vector2d((b.y - a.y).value() / length, (b.z - a.z).value() / length);
  };
  std::vector<FlatPlate> plates;
  for (const PathPlate& of : path.plates) {
    if (!of.straight) continue;
    FlatPlate& plate = plates.emplace_back();
    plate.name = plate.called = of.name;
    plate.ends = {of.at(of.low), of.at(of.high)};
    plate.nodes = of.nodes;
    for (const std::size_t k : {0U, 1U}) {
      // Beyond the nodes of the case a wall may reach to the far face of the one that it meets.
      const std::size_t node = of.nodes[k] < from.nodes.size() ? of.nodes[k] : of.nodes[1 - k];
      if (node < from.nodes.size())
        plate.slopes[k] = slope_of(node);
      else
        plate.slopes[k].setZero();
    }
    double area = 0.0;
    const auto add = [&](const Wall& wall) { area += length_of(wall) * wall.thickness; };
    for (const PathPlate::Part& part : of.parts) add(path.graph.walls[part.wall]);
    // What reaches beyond its ends over what it stands on.
    for (const Wall& wall : path.graph.walls) {
      const bool beyond =
          wall.to >= from.nodes.size() && (wall.from == of.nodes[0] || wall.from == of.nodes[1]);
      if (beyond && std::abs(plate.normal().dot(direction_on(wall, 0.5))) <= hardly_turned)
        add(wall);
    }
    plate.thickness = of.thickness.value();
    plate.clear = of.clear();
    plate.inside = plate.clear * of.thickness;
    plate.yield_strength = of.yield_strength;
    plate.outstand = of.outstand();
    set_force(plate, gross, extent, si<Area>(area));
  }
  return plates;
}

}  // namespace

std::vector<FlatPlate> flat_plates_at(const Project& project, std::size_t segment, bool end) {
  const Segment& of = project.beam.segments[segment];
  const Section& section = end ? of.to : of.from;
  const PlateMaterials materials = materials_of(project, segment);
  const double length = of.length.value();
  if (const auto* const path = std::get_if<ThinWalled>(&section.outer)) {
    const auto at = path_section_of(*path, materials);
    if (!at) return {};
    return plates_of_path(section, *at, std::get<ThinWalled>(of.from.outer),
                          std::get<ThinWalled>(of.to.outer), length);
  }
  const auto from = four_walls_of(of.from.outer, materials),
             to = four_walls_of(of.to.outer, materials);
  if (!from || !to) return {};
  return plates_of_box(section, end ? *to : *from, *from, *to, length);
}

}  // namespace boxbeam
