#include "boxbeam/verification/section_under_forces.hpp"

#include <algorithm>

#include "boxbeam/core/error.hpp"
#include "boxbeam/strength/section_class.hpp"
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

}  // namespace

SectionUnderForces section_under(const Section& section, const Material& steel,
                                 const CutForces& forces) {
  std::optional<FourWalls> walls;
  if (!section.inner) walls = four_walls_of(section.outer, steel);
  if (!walls) {
    throw InputError(
        "forces are judged on boxes and rectangular tubes whose plates are as thin as their steel "
        "has a strength for",
        "leave out --forces, or write for example \"box 600x1224 flange 12 web 8\"");
  }
  if (const std::string why = stiffener_obstacle(*walls); !why.empty())
    throw InputError("forces are not judged on this box: " + why, "leave out --forces");
  bool stiffened = false;
  for (BoxWall& wall : walls->walls) {
    // Those of a plate that would do without them count as area alone.
    if (!may_buckle(wall)) wall.stiffeners.clear();
    stiffened = stiffened || !wall.stiffeners.empty();
  }
  SectionUnderForces of{forces, 1, EffectiveBox(*walls), {}, {}, 0.0, nullptr};
  of.corner = of.box.worst_corner(forces);
  const PlasticBox plastic(of.box);
  for (const ShearedPlate& sheared : sheared_plates_of(section, *walls, {}, false, 1.0)) {
    const BoxWall& wall = walls->of(sheared.plate);
    const PlateStress stress = PlateEnds(*walls, sheared.plate, walls->gross).under(forces);
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
        std::max(of.interaction_use, interaction_of(sheared, plastic, of.corner, forces, 1.0).use);
  }
  if (stiffened) return of;
  of.reduced = &*std::max_element(
      of.plates.begin(), of.plates.end(),
      [](const auto& a, const auto& b) { return a.reduced.use < b.reduced.use; });
  return of;
}

}  // namespace boxbeam
