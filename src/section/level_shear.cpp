#include "boxbeam/section/level_shear.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/section/outline.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/wall_graph.hpp"

namespace boxbeam {
namespace {

/// Levels that keep their part in a taper, ascending.
std::vector<double> fixed_levels_of(const Section& section, const std::vector<Hole>& holes) {
  const Extent extent = extent_of(section.outer);
  std::vector<double> levels{extent.z_low.value(), clear_bottom_of(section.outer).value(),
                             clear_top_of(section.outer).value(), extent.z_high.value()};
  for (const Hole& hole : holes) {
    if (hole.walls != HoleWalls::webs) continue;
    levels.push_back((hole.position - 0.5 * hole.diameter).value());
    levels.push_back((hole.position + 0.5 * hole.diameter).value());
  }
  std::sort(levels.begin(), levels.end());
  return levels;
}

double moved(double z, const std::vector<double>& from, const std::vector<double>& to) {
  std::size_t i = 0;
  while (i + 2 < from.size() && z > from[i + 1]) ++i;
  // Levels may fall together.
  const double step = from[i + 1] - from[i];
  const double part = step > 0.0 ? (z - from[i]) / step : 0.0;
  return to[i] + part * (to[i + 1] - to[i]);
}

Eigen::RowVector3d force_beyond(const Section& section, const std::vector<Hole>& holes, double z) {
  const Outline outline = outline_of(section, holes);
  const AreaSums part = sums_beyond(outline, z);
  return Eigen::RowVector3d(part.area, part.y, part.z) * normal_stress_plane(sums_of(outline));
}

/// The border turned so that y takes the place of z, and -z that of y.
Outline turned(Outline outline) {
  for (BorderPiece& piece : outline) {
    for (Eigen::Vector2d* place : {&piece.from, &piece.to, &piece.centre}) {
      *place = {-place->y(), place->x()};
    }
    piece.angle += 0.5 * std::numbers::pi;
  }
  return outline;
}

Eigen::RowVector3d force_left_of(const Section& section, const std::vector<Hole>& holes, double y) {
  const Outline outline = outline_of(section, holes);
  const AreaSums part = sums_beyond(turned(outline), y);
  return Eigen::RowVector3d(part.area, part.z, -part.y) * normal_stress_plane(sums_of(outline));
}

}  // namespace

CutFactors level_shear_of(const Section& section, const std::vector<Hole>& holes,
                          const Taper& taper, double z) {
  const double width = width_at(outline_of(section, holes), z);
  if (width <= 0.0) return CutFactors::Zero();
  const std::vector<double> levels = fixed_levels_of(section, holes);
  Eigen::RowVector3d slope = Eigen::RowVector3d::Zero();
  for (const NearbySection& near : taper) {
    const double level = moved(z, levels, fixed_levels_of(near.section, holes));
    slope += near.weight * force_beyond(near.section, holes, level);
  }
  return flow_out_of(force_beyond(section, holes, z), slope) / width;
}

LevelMoment moment_beyond_level(const Section& section, const std::vector<Hole>& holes, Length z) {
  const Length centroid = properties_of(section, holes).centroid_z;
  return {first_moment_beyond(section, holes, z, centroid), width_at(section, holes, z), false};
}

std::optional<LevelMoment> moment_on_webs(const Section& section, const std::vector<Hole>& holes,
                                          Length z) {
  const auto graph = wall_graph_of(section, holes);
  if (!graph) return std::nullopt;
  const double level = z.value();
  double left = 0.0, right = 0.0;  // thicknesses
  Eigen::Vector3d beyond = Eigen::Vector3d::Zero();
  for (const Wall& wall : graph->walls) {
    if (wall.inner) continue;
    if (wall.part == WallPart::left_web) left = wall.thickness;
    if (wall.part == WallPart::right_web) right = wall.thickness;
    if (wall.part != WallPart::left_web && wall.part != WallPart::right_web) {
      // A stiffener hangs where it is welded on.
      const Eigen::Vector2d hangs =
          wall.part == WallPart::stiffener ? graph->nodes[wall.from] : point_on(wall, 0.5);
      if (hangs.y() > level) beyond += material_up_to(wall, 1.0);
      continue;
    }
    const double low = wall.start.y(), high = wall.end.y();
    const double part = std::clamp((level - low) / (high - low), 0.0, 1.0);
    beyond += material_up_to(wall, 1.0) - material_up_to(wall, part);
  }
  if (left == 0.0 || left != right) return std::nullopt;
  const double centroid = properties_of(section, holes).centroid_z.value();
  return LevelMoment{si<SectionModulus>(beyond[2] - centroid * beyond[0]), si<Length>(left + right),
                     true};
}

std::optional<LevelMoment> level_moment_of(const Section& section, const std::vector<Hole>& holes,
                                           Length z, double per_V) {
  const double I = properties_of(section, holes).I_y.value();
  const auto gives = [&](const LevelMoment& of) {
    constexpr double round_off = 1e-9;
    const double stress = of.S.value() / (I * of.b.value());
    return of.b.value() > 0.0 && of.S.value() > 0.0 &&
           std::abs(stress - per_V) <= round_off * std::abs(stress);
  };
  const LevelMoment level = moment_beyond_level(section, holes, z);
  if (gives(level)) return level;
  const auto webs = moment_on_webs(section, holes, z);
  return webs && gives(*webs) ? webs : std::nullopt;
}

CutFactors level_shear_across_of(const Section& section, const std::vector<Hole>& holes,
                                 const Taper& taper, double y) {
  const double width = width_at(turned(outline_of(section, holes)), y);
  if (width <= 0.0) return CutFactors::Zero();
  const double reach = extent_of(section.outer).y_high.value();
  Eigen::RowVector3d slope = Eigen::RowVector3d::Zero();
  for (const NearbySection& near : taper) {
    const double place = y / reach * extent_of(near.section.outer).y_high.value();
    slope += near.weight * force_left_of(near.section, holes, place);
  }
  return flow_out_of(force_left_of(section, holes, y), slope) / width;
}

}  // namespace boxbeam
