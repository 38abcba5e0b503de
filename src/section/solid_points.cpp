#include "solid_points.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "boxbeam/section/level_shear.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "wall_places.hpp"

namespace boxbeam {

using namespace wall_places;

bool in_hole(const StressField& field, Length z) {
  return width_at(field.section, field.holes, z).value() <= 0.0 &&
         abs(z) < 0.5 * height_of(field.section.outer);
}

SectionPoint level_point(const StressField& field, const std::string& name, double y, double z) {
  SectionPoint point = point_at(field, name, y, z, wall_at(field.section, si<Length>(z)));
  set_shear(point.influence, level_shear_of(field.section, field.holes, field.taper, z));
  set_shear(point.prismatic, level_shear_of(field.section, field.holes, {}, z));
  return point;
}

SectionPoint plate_point(const StressField& field, const std::string& name, double y, double z) {
  const auto& plate = std::get<Plate>(field.section.outer);
  SectionPoint point = level_point(field, name, y, z);
  const double half_width = 0.5 * plate.width.value(), half_height = 0.5 * plate.height.value();
  const bool top_or_bottom = std::abs(z) == half_height;
  const bool corner = top_or_bottom && std::abs(y) == half_width;
  for (StressInfluence* influence : {&point.influence, &point.prismatic}) {
    const Taper taper = influence == &point.influence ? field.taper : Taper{};
    influence->shear[cut_force::T] = 0.0;
    if (top_or_bottom && !corner) {
      set_shear(*influence, level_shear_across_of(field.section, field.holes, taper, y));
      influence->shear[cut_force::T] =
          (z > 0.0 ? -1.0 : 1.0) * torsion_shear_of_rectangle(plate.width, plate.height);
    } else if (!corner) {
      influence->shear[cut_force::T] =
          (y < 0.0 ? -1.0 : 1.0) * torsion_shear_of_rectangle(plate.height, plate.width);
    }
  }
  return point;
}

SectionPoint polygon_point(const StressField& field, const std::string& name, double y, double z) {
  SectionPoint point = level_point(field, name, y, z);
  for (StressInfluence* influence : {&point.influence, &point.prismatic}) {
    influence->shear[cut_force::V_y] = influence->shear[cut_force::T] =
        std::numeric_limits<double>::quiet_NaN();
  }
  return point;
}

void add_polygon_points(const StressField& field, std::vector<SectionPoint>& points) {
  const auto add = [&](const std::string& name, double y, double z) {
    points.push_back(polygon_point(field, name, y, z));
  };
  const auto& polygon = std::get<Polygon>(field.section.outer);
  int number = 0;
  for (const SectionPlace& place : polygon.outer) {
    add(fmt::format("corner {}", ++number), place.y.value(), place.z.value());
  }
  const double z = field.sums.z / field.sums.area;
  if (in_hole(field, si<Length>(z))) return;
  add("neutral axis", field.sums.y / field.sums.area, z);
  points.back().neutral = true;
}

void add_plate_points(const StressField& field, PointSet set, std::vector<SectionPoint>& points) {
  const Extent extent = extent_of(field.section.outer);
  const double y = extent.y_high.value(), z = extent.z_high.value();
  const Length middle = si<Length>(field.sums.z / field.sums.area);
  points.push_back(plate_point(field, "fibre +z", 0.0, z));
  points.push_back(plate_point(field, "fibre -z", 0.0, -z));
  const bool solid = !in_hole(field, middle);
  if (set == PointSet::in_plane) {
    if (!solid) return;
    points.push_back(plate_point(field, "neutral axis", y, middle.value()));
    points.back().neutral = true;
    return;
  }
  for (const double side : {1.0, -1.0}) {
    const std::string y_name = signed_axis(side, 'y');
    if (solid) {
      points.push_back(plate_point(field, "neutral axis " + y_name, side * y, middle.value()));
      points.back().neutral = true;
    }
    for (const double up : {1.0, -1.0}) {
      points.push_back(plate_point(field, fmt::format("corner {} {}", y_name, signed_axis(up, 'z')),
                                   side * y, up * z));
    }
  }
}

}  // namespace boxbeam
