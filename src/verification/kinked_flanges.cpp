#include "kinked_flanges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "patch_search.hpp"

namespace boxbeam {
namespace {

/// Where a plate's outer face lies: z of a flange's, y of a web's.
Length face_of(const Extent& of, BoxPlate plate) {
  switch (plate) {
    case BoxPlate::top_flange: return of.z_high;
    case BoxPlate::bottom_flange: return of.z_low;
    case BoxPlate::left_web: return of.y_high;
    case BoxPlate::right_web: return of.y_low;
  }
  return {};
}

double slope_of_face(const Segment& of, BoxPlate plate) {
  return ((face_of(extent_of(of.to.outer), plate) - face_of(extent_of(of.from.outer), plate)) /
          of.length)
      .value();
}

FlangeKink kink_of(const Section& section, const FourWalls& walls, BoxPlate plate) {
  const BoxWall& wall = walls.of(plate);
  const Extent extent = extent_of(section.outer);
  const bool flange = is_flange(plate);
  FlangeKink kink;
  kink.name = std::string("the kink of the ") + to_text(plate);
  kink.along_z = flange;
  kink.clear = wall.clear();
  kink.thickness = wall.thickness;
  kink.yield_strength = wall.yield_strength;
  const Length width = flange ? extent.y_high - extent.y_low : wall.clear();
  kink.area = width * wall.thickness;
  const double across = 0.5 * (wall.low + wall.high).value(), out = wall.middle.value();
  kink.middle = normal_influence(sums_of(outline_of(section, {})), flange ? across : out,
                                 flange ? out : across);
  return kink;
}

}  // namespace

Force FlangeKink::force_under(const CutForces& cut) const {
  const double stress = middle.normal[cut_force::N] * cut.N.value() +
                        middle.normal[cut_force::M_y] * cut.M_y.value() +
                        middle.normal[cut_force::M_z] * cut.M_z.value();
  return si<Force>(turn * stress * area.value());
}

std::vector<FlangeKink> flange_kinks_of(const Project& project) {
  const TaperedBeam& beam = project.beam;
  std::vector<FlangeKink> kinks;
  for (std::size_t k = 0; k + 1 < beam.segments.size(); ++k) {
    const Segment &one = beam.segments[k], &next = beam.segments[k + 1];
    const auto walls = four_walls_of(one.to.outer, materials_of(project, k));
    if (!walls || !four_walls_of(next.from.outer, materials_of(project, k + 1))) continue;
    const Extent before = extent_of(one.to.outer), behind = extent_of(next.from.outer);
    for (const BoxPlate plate : box_plates) {
      const Length step = face_of(behind, plate) - face_of(before, plate);
      const double turn = slope_of_face(next, plate) - slope_of_face(one, plate);
      // Less than a thickness apart they are one plate; farther, `flange_steps_of` has them.
      constexpr double straight = 1e-6;
      if (abs(step) > walls->of(plate).thickness || std::abs(turn) < straight) continue;
      FlangeKink& kink = kinks.emplace_back(kink_of(one.to, *walls, plate));
      kink.s = one.end();
      kink.turn = turn;
    }
  }
  return kinks;
}

std::vector<FlangeStep> flange_steps_of(const Project& project) {
  const TaperedBeam& beam = project.beam;
  std::vector<FlangeStep> steps;
  for (std::size_t k = 0; k + 1 < beam.segments.size(); ++k) {
    const Section &before = beam.segments[k].to, &behind = beam.segments[k + 1].from;
    const auto ends = four_walls_of(before.outer, materials_of(project, k)),
               begins = four_walls_of(behind.outer, materials_of(project, k + 1));
    if (!ends || !begins) continue;
    for (const BoxPlate plate : box_plates) {
      if (!is_flange(plate) && !project.in_space) continue;
      const Length by =
          face_of(extent_of(behind.outer), plate) - face_of(extent_of(before.outer), plate);
      const Length thin = std::min(ends->of(plate).thickness, begins->of(plate).thickness);
      if (abs(by) <= thin) continue;
      for (FlangeKink of : {kink_of(before, *ends, plate), kink_of(behind, *begins, plate)}) {
        of.s = beam.segments[k].end();
        of.turn = 1.0;
        of.name = to_text(plate);
        steps.push_back({std::move(of), abs(by)});
      }
    }
  }
  return steps;
}

std::vector<Patch> PatchSearch::kinks_under(const CutForceDiagram& diagram) const {
  std::vector<Patch> patches;
  for (const FlangeKink& of : kinks_) {
    if (!of.along_z && !project_->in_space) continue;
    Patch patch;
    patch.name = of.name;
    patch.s = of.s;
    patch.along_z = of.along_z;
    patch.force = of.force_under(diagram.at({of.s, Side::before}));
    patch.kink = &of;
    if (!patch.is_none()) patches.push_back(std::move(patch));
  }
  return patches;
}

Stress stress_across_kink(const FlangeKink& kink, Force force) {
  constexpr double nu = 0.3;
  const double m = (1.0 + nu) * std::abs(force.value()) / (4.0 * std::numbers::pi);
  const double t = kink.thickness.value();
  return si<Stress>(6.0 * m / (t * t));
}

}  // namespace boxbeam
