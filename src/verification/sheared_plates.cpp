#include "boxbeam/verification/sheared_plates.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "boxbeam/section/section_points.hpp"
#include "boxbeam/section/wall_stretches.hpp"
#include "boxbeam/strength/section_class.hpp"

namespace boxbeam {
namespace {

std::optional<BoxPlate> plate_of(WallPart part) {
  switch (part) {
    case WallPart::top_flange: return BoxPlate::top_flange;
    case WallPart::bottom_flange: return BoxPlate::bottom_flange;
    case WallPart::left_web: return BoxPlate::left_web;
    case WallPart::right_web: return BoxPlate::right_web;
    default: return std::nullopt;
  }
}

/// The stiffeners of a wall as far as they help it in shear: I_sl with 15 eps t of plate on both
/// sides, at most half of the subpanels. Source: EN 1993-1-5:2006, 5.3(3), figure 5.3.
ShearStiffeners shear_stiffeners_of(const BoxWall& wall) {
  ShearStiffeners of;
  const std::vector<FlatStiffener>& bars = wall.stiffeners;
  of.count = static_cast<int>(bars.size());
  const double t = wall.thickness.value();
  const Length most = 15.0 * epsilon_of(wall.class_strength) * wall.thickness;
  Length from = wall.low;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const FlatStiffener& bar = bars[k];
    const Length half = 0.5 * bar.thickness;
    const Length before = bar.place - half - from;
    const bool last = k + 1 == bars.size();
    const Length next = last ? wall.high : bars[k + 1].place - 0.5 * bars[k + 1].thickness;
    const Length behind = next - bar.place - half;
    of.widest_subpanel = std::max({of.widest_subpanel, before, behind}, std::less<>());
    const double plate =
        (std::min(0.5 * before, most) + bar.thickness + std::min(0.5 * behind, most)).value() * t;
    const double d = bar.depth.value(), A = d * bar.thickness.value(), apart = 0.5 * (t + d);
    of.inertia += si<SecondMoment>((A * d * d + plate * t * t) / 12.0 +
                                   plate * A / (plate + A) * apart * apart);
    from = bar.place + half;
  }
  return of;
}

/// A plate without what it carries of the shear flow.
ShearedPlate sheared_plate(double gamma_M1, const BoxWall& wall, BoxPlate plate, bool in_plane,
                           bool alike) {
  ShearedPlate of;
  of.plate = plate;
  of.as_flange = of.by_subpanels = is_flange(plate) || !in_plane;
  of.web_in_space = !is_flange(plate) && !in_plane;
  of.name = alike && !is_flange(plate) ? "web" : to_text(plate);
  of.panel = {wall.clear(), wall.thickness, wall.yield_strength,
              {},           false,          shear_stiffeners_of(wall)};
  of.resists = shear_resistance_of(of.panel, gamma_M1);
  return of;
}

/// The mean of a parabola by its ends and its middle: Simpson's rule is exact.
double mean_of(const std::array<double, 3>& stress) {
  return (stress[0] + 4.0 * stress[1] + stress[2]) / 6.0;
}

/// The part of the shear flow on a stretch of a plate.
ShearedPlate::Piece piece_of(const StressField& field, const WallStretch& stretch) {
  ShearedPlate::Piece piece;
  const Wall& wall = field.flow->at.graph.walls[stretch.wall];
  piece.width = (stretch.to - stretch.from) * length_of(wall);
  for (std::size_t i = 0; i < piece.per_cut_force.size(); ++i) {
    const SectionPoint point = point_on_stretch(field, stretch, 0.5 * static_cast<double>(i));
    piece.per_cut_force[i] = point.influence.shear;
    // The wall's own torsion turns round over its thickness.
    if (point.torsion) piece.per_cut_force[i][cut_force::T] -= point.torsion->face;
  }
  return piece;
}

}  // namespace

Force ShearedWall::force_of(const CutForces& cut) const {
  double sum = 0.0, most = 0.0, sum_along = 0.0;
  // Means of the pieces by what counts by subpanels.
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Piece& piece : pieces) {
    std::array<double, 3> stress{}, along{};
    for (std::size_t i = 0; i < stress.size(); ++i) {
      for (std::size_t k = 0; k < cut_force::count; ++k) {
        const double acting = value_of(cut, static_cast<cut_force::Index>(k));
        // What is not known counts only where it acts.
        if (acting == 0.0) continue;
        const double part = piece.per_cut_force[i][k] * acting;
        stress[i] += part;
        if (web_in_space && k != cut_force::V_y && k != cut_force::M_z) along[i] += part;
      }
      most = std::max(most, std::abs(stress[i]));
    }
    const double mean = mean_of(stress), mean_along = mean_of(along);
    sum += piece.width * mean;
    sum_along += piece.width * mean_along;
    lowest = std::min(lowest, mean - mean_along);
    highest = std::max(highest, mean - mean_along);
  }
  double mean = std::abs(sum);
  if (as_flange) mean = std::max(mean, 0.5 * most);
  if (by_subpanels && pieces.size() > 1)
    mean = std::max({mean, std::abs(sum_along + lowest), std::abs(sum_along + highest)});
  return si<Stress>(mean) * (panel.depth * panel.thickness);
}

std::vector<ShearedPlate> sheared_plates_of(const Section& section, const FourWalls& walls,
                                            const Taper& taper, bool in_plane, double gamma_M1) {
  const StressField field = stress_field_of(section, {}, taper);
  const BoxWall& left = walls.of(BoxPlate::left_web);
  const BoxWall& right = walls.of(BoxPlate::right_web);
  const bool alike = in_plane && is_mirrored(field) &&
                     left.yield_strength == right.yield_strength &&
                     left.class_strength == right.class_strength;
  std::vector<ShearedPlate> plates;
  for (const WallStretch& stretch : wall_stretches_of(field)) {
    if (stretch.solid || stretch.round || !field.flow) continue;
    const auto plate = plate_of(field.flow->at.graph.walls[stretch.wall].part);
    if (!plate || (alike && *plate == BoxPlate::right_web)) continue;
    auto at = std::find_if(plates.begin(), plates.end(),
                           [&](const ShearedPlate& of) { return of.plate == *plate; });
    if (at == plates.end())
      at = plates.insert(at, sheared_plate(gamma_M1, walls.of(*plate), *plate, in_plane, alike));
    at->pieces.push_back(piece_of(field, stretch));
  }
  for (ShearedPlate& plate : plates) {
    double width = 0.0;
    for (const ShearedPlate::Piece& piece : plate.pieces) width += piece.width;
    for (ShearedPlate::Piece& piece : plate.pieces) piece.width /= width;
  }
  return plates;
}

std::vector<ShearedWall> sheared_walls_of(const ThinWalled& profile, const PathSection& path,
                                          const Taper& taper, bool outstands) {
  const auto flow = shear_flow_of(Section{profile, {}}, {}, taper);
  std::vector<ShearedWall> walls;
  for (const PathPlate& plate : path.plates) {
    if (plate.outstand() != outstands || !plate.straight) continue;
    ShearedWall& of = walls.emplace_back();
    of.name = plate.name;
    of.as_flange = true;
    of.panel.depth = plate.clear();
    of.panel.thickness = plate.thickness;
    of.panel.yield_strength = plate.yield_strength;
    for (const PathPlate::Part& part : plate.parts) {
      const auto [low, high] = std::minmax(part.from, part.to);
      const double from = std::max(low, plate.low), to = std::min(high, plate.high);
      if (!(to > from)) continue;
      ShearedWall::Piece& piece = of.pieces.emplace_back();
      piece.width = (to - from) / plate.clear().value();
      const Wall& wall = path.graph.walls[part.wall];
      // Places along the plate as fractions of the wall's material.
      const Eigen::Vector2d along = (wall.end - wall.start).normalized();
      const double sense = along.dot(plate.direction) > 0.0 ? 1.0 : -1.0;
      for (std::size_t i = 0; i < piece.per_cut_force.size(); ++i) {
        const Eigen::Vector2d at = plate.at(from + 0.5 * static_cast<double>(i) * (to - from));
        const double fraction =
            std::clamp((at - wall.start).dot(along) / length_of(wall), 0.0, 1.0);
        const CutFactors q = flow_at(*flow, part.wall, fraction);
        for (std::size_t k = 0; k < cut_force::count; ++k)
          piece.per_cut_force[i][k] =
              sense * q[static_cast<Eigen::Index>(k)] / plate.thickness.value();
      }
    }
  }
  return walls;
}

}  // namespace boxbeam
