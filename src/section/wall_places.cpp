#include "wall_places.hpp"
#include "boxbeam/core/angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxbeam::wall_places {

bool is_web(const Wall& wall) {
  return wall.part == WallPart::left_web || wall.part == WallPart::right_web;
}

bool has_webs(const Profile& profile) {
  return std::holds_alternative<Box>(profile) || std::holds_alternative<RectangularTube>(profile);
}

void set_shear(StressInfluence& influence, const CutFactors& factors) {
  for (std::size_t k = 0; k < influence.shear.size(); ++k) {
    influence.shear[k] = factors[static_cast<Eigen::Index>(k)];
  }
}

CutFactors wall_shear(const ShearFlow& flow, const WallPlace& place, double face) {
  const CutFactors q = flow_at(flow, place.wall, place.fraction);
  if (face == 0.0) face = q[cut_force::T] < 0.0 ? -1.0 : 1.0;
  return q / flow.at.graph.walls[place.wall].thickness + face * face_shear_of(flow, place.wall);
}

SectionPoint point_at(const StressField& field, const std::string& name, double y, double z,
                      Length plate) {
  SectionPoint point;
  point.name = name;
  point.y = si<Length>(y);
  point.z = si<Length>(z);
  point.plate = plate;
  point.influence = point.prismatic = normal_influence(field.sums, y, z);
  return point;
}

SectionPoint wall_point(const StressField& field, const std::string& name, const WallPlace& place,
                        double y, double z, double face, Length plate) {
  SectionPoint point = point_at(field, name, y, z, plate);
  set_shear(point.influence, wall_shear(*field.flow, place, face));
  if (field.prismatic)
    set_shear(point.prismatic, wall_shear(*field.prismatic, place, face));
  else
    point.prismatic.shear = point.influence.shear;
  point.torsion = wall_torsion_of(*field.flow, place.wall, face);
  if (is_web(field.flow->at.graph.walls[place.wall])) point.part = SectionPart::web;
  return point;
}

WallPlace nearest(const WallGraph& graph, WallPart part, bool inner, double along) {
  WallPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    if (wall.part != part || wall.inner != inner) continue;
    const Eigen::Index axis = is_web(wall) ? 1 : 0;
    const double low = wall.start[axis], high = wall.end[axis];
    const double at = std::clamp(along, low, high);
    // At the edge of a hole the material beside it is meant.
    const double distance = std::abs(along - at) + (wall.solid ? 0.0 : 1e-9 * (high - low));
    if (distance >= least) continue;
    least = distance;
    best = {i, (at - low) / (high - low)};
  }
  return best;
}

WallPlace on_round(const WallGraph& graph, bool inner, double angle) {
  const double positive = angle - full_turn * std::floor(angle / full_turn);
  for (std::size_t i = 0; i < graph.walls.size(); ++i) {
    const Wall& wall = graph.walls[i];
    const double fraction = (positive - wall.angle) / wall.sweep;
    if (wall.inner == inner && fraction >= 0.0 && fraction <= 1.0) return {i, fraction};
  }
  return {};
}

double outer_face_of(const Wall& wall) {
  const bool outwards = wall.part == WallPart::left_web || wall.part == WallPart::top_flange;
  return wall.start[is_web(wall) ? 0 : 1] + (outwards ? 0.5 : -0.5) * wall.thickness;
}

std::string signed_axis(double sign, char axis) {
  return fmt::format("{}{}", sign > 0.0 ? '+' : '-', axis);
}

}  // namespace boxbeam::wall_places
