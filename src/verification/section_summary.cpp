#include "boxbeam/verification/section_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/verification/path_checks.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

int class_of(const BoxWall& wall, const PlateStress& stress) {
  if (!(stress.compression > Stress{})) return 1;
  const double pressed = stress.psi >= 0.0 ? 1.0 : 1.0 / (1.0 - stress.psi);
  return boxbeam::class_of(
      wall.clear() / wall.thickness,
      internal_part_limits(pressed, stress.psi, epsilon_of(wall.class_strength)));
}

/// Compression at the ends of a plate's clear width.
std::array<double, 2> compressions_of(const PathPlate& plate, const AreaSums& gross,
                                      const CutForces& forces) {
  const auto at = [&](double along) {
    const Eigen::Vector2d place = plate.at(along);
    return -stress_at(normal_influence(gross, place.x(), place.y()), forces).normal.value();
  };
  return {at(plate.low), at(plate.high)};
}

/// `none`: a compression that is but round-off.
int class_of(const PathPlate& plate, const std::array<double, 2>& compressions, double none) {
  const auto [low, high] = compressions;
  const double most = std::max(low, high);
  if (!(most > none)) return 1;
  const double psi = std::min(low, high) / most, epsilon = epsilon_of(plate.class_strength);
  const double pressed = psi >= 0.0 ? 1.0 : 1.0 / (1.0 - psi);
  const double slender = plate.clear() / plate.thickness;
  if (!plate.outstand())
    return boxbeam::class_of(slender, internal_part_limits(pressed, psi, epsilon));
  const bool at_support = psi < 1.0 && (high > low) == plate.held_at_high();
  return boxbeam::class_of(
      slender, at_support ? outstand_part_limits(pressed, std::max(-1.0, psi),
                                                 LargestCompression::at_support, epsilon)
                          : outstand_part_limits(pressed, std::max(-3.0, psi),
                                                 LargestCompression::at_tip, epsilon));
}

[[noreturn]] void refuse_forces(const char* what, const std::string& why) {
  throw InputError(fmt::format("forces are not judged on this {}: {}", what, why),
                   "leave out --forces");
}

SectionUnderForces box_under_forces(const Section& section, FourWalls walls,
                                    const CutForces& forces) {
  if (const std::string why = stiffener_obstacle(walls); !why.empty()) refuse_forces("box", why);
  bool stiffened = false;
  for (BoxWall& wall : walls.walls) {
    // Those of a plate that would do without them count as area alone.
    if (!may_buckle(wall)) wall.stiffeners.clear();
    stiffened = stiffened || !wall.stiffeners.empty();
  }
  const EffectiveBox box(walls);
  const CornerUse corner = box.worst_corner(forces);
  SectionUnderForces of;
  of.forces = forces;
  of.area = si<Area>(box.alone(ActingAlone::compression).sums.area);
  of.shift_y = box.shift_y();
  of.shift_z = box.shift_z();
  of.use = corner;
  of.place = fmt::format("{} at {}", to_text(corner.corner.flange), to_text(corner.corner.web));
  const PlasticBox plastic(box);
  for (const ShearedPlate& sheared : sheared_plates_of(section, walls, {}, false, 1.0)) {
    const BoxWall& wall = walls.of(sheared.plate);
    const PlateStress stress = PlateEnds(walls, sheared.plate, walls.gross).under(forces);
    of.section_class = std::max(of.section_class, class_of(wall, stress));
    const Force V = sheared.force_of(forces);
    PlateUnderForces& plate = of.plates.emplace_back();
    plate.sheared = sheared;
    plate.web = !is_flange(sheared.plate);
    plate.shear_use = V / sheared.resists.resistance;
    plate.reduced = reduced_stress_of(sheared.panel,
                                      {stress.compression, stress.tension, stress.psi,
                                       Stress(V / (wall.clear() * wall.thickness))},
                                      1.0);
    of.interaction_use =
        std::max(of.interaction_use, interaction_of(sheared, plastic, corner, forces, 1.0).use);
    if (stiffened) continue;
    const std::size_t last = of.plates.size() - 1;
    if (!of.reduced || plate.reduced.use > of.plates[*of.reduced].reduced.use) of.reduced = last;
  }
  return of;
}

/// Shear is judged of plates held at both ends.
void refuse_unjudged_shear(const ThinWalled& profile, const PathSection& section,
                           const SlenderPath& path, const CutForces& forces) {
  if (forces.T.value() != 0.0 && !(enclosed_area_of(profile).value() > 0.0))
    refuse_forces("path", "torsion of an open section is not judged");
  const auto bears = [&](Eigen::Index along) {
    return std::any_of(path.sheared.begin(), path.sheared.end(), [&](const ShearedWall& wall) {
      return std::any_of(section.plates.begin(), section.plates.end(), [&](const PathPlate& of) {
        constexpr double inclined = 0.5;
        return of.name == wall.name && std::abs(of.direction[along]) > inclined;
      });
    });
  };
  for (const Eigen::Index along : {0, 1}) {
    const Force shear = along == 0 ? forces.V_y : forces.V_z;
    if (shear.value() != 0.0 && !bears(along))
      refuse_forces(
          "path", std::string("no plate held at both ends bears ") + (along == 0 ? "V_y" : "V_z"));
  }
}

SectionUnderForces path_under_forces(const ThinWalled& profile, const PathSection& section,
                                     const CutForces& forces) {
  const SlenderPath path = slender_path_of(profile, section, {}, std::nullopt, 1.0, section.plates);
  if (const std::string why = section_obstacle(path.section); !why.empty())
    refuse_forces("path", why);
  for (const ShearedWall& outstand : path.outstands) {
    const double share = sheared_share(outstand, forces);
    if (share > hardly_sheared)
      refuse_forces("path", outstand.name + ": " + sheared_outstand_text(share));
  }
  refuse_unjudged_shear(profile, section, path, forces);
  const PathUse use = path.section.worst_place(forces);
  SectionUnderForces of;
  of.forces = forces;
  of.area = si<Area>(path.section.alone(ActingAlone::compression).sums.area);
  of.shift_y = path.section.centroid().shift_y;
  of.shift_z = path.section.centroid().shift_z;
  of.use = use;
  of.place = path.section.places()[use.place].name;
  of.interaction_use = use.use;
  std::vector<std::array<double, 2>> ends;
  double largest = 0.0;
  for (const PathPlate& plate : section.plates) {
    ends.push_back(compressions_of(plate, section.gross, forces));
    for (const double stress : ends.back()) largest = std::max(largest, std::abs(stress));
  }
  constexpr double rounding = 1e-9;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    of.section_class =
        std::max(of.section_class, class_of(section.plates[k], ends[k], rounding * largest));
  }
  for (const ShearedWall& wall : path.sheared) {
    const auto plate = std::find_if(section.plates.begin(), section.plates.end(),
                                    [&](const PathPlate& one) { return one.name == wall.name; });
    const bool web = std::abs(plate->direction.y()) > std::abs(plate->direction.x());
    of.plates.push_back({wall, web, shear_use_of(wall, forces)});
    of.interaction_use =
        std::max(of.interaction_use, interaction_of(path, wall, use, forces, 1.0).use);
  }
  return of;
}

}  // namespace

SectionUnderForces section_under(const Section& section, const Material& steel,
                                 const CutForces& forces) {
  if (!section.inner) {
    if (auto walls = four_walls_of(section.outer, steel))
      return box_under_forces(section, std::move(*walls), forces);
    if (const auto* const profile = std::get_if<ThinWalled>(&section.outer)) {
      if (const auto path = path_section_of(*profile, steel))
        return path_under_forces(*profile, *path, forces);
    }
  }
  throw InputError(
      "forces are judged on boxes, rectangular tubes and thin-walled paths whose plates are as "
      "thin "
      "as their steel has a strength for",
      "leave out --forces, or write for example \"box 600x1224 flange 12 web 8\"");
}

SectionSummary summary_of(const NamedSection& named, const Material& steel) {
  SectionSummary summary{named,
                         steel.name,
                         properties_of(named.section),
                         torsion_properties_of(named.section),
                         plate_slenderness_of(named.section.outer, steel),
                         {}};
  if (!named.section.inner) return summary;
  for (SlenderPlate plate : plate_slenderness_of(*named.section.inner, steel)) {
    plate.plate = "inner " + plate.plate;
    summary.plates.push_back(plate);
  }
  return summary;
}

}  // namespace boxbeam
