#include "boxbeam/verification/section_under_forces.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/section_class.hpp"

namespace boxbeam {
namespace {

/// Gross stress of a plate: compression at its worse end and tension at the other [Pa].
struct PlateStress {
  double compression = 0.0, tension = 0.0, psi = 1.0;
};

PlateStress stress_of(const FourWalls& box, BoxPlate plate, const CutForces& forces) {
  const BoxWall& wall = box.of(plate);
  const bool flange = plate == BoxPlate::top_flange || plate == BoxPlate::bottom_flange;
  const auto pressed_at = [&](const Length& end) {
    const Length& y = flange ? end : wall.middle;
    const Length& z = flange ? wall.middle : end;
    return -stress_at(normal_influence(box.gross, y.value(), z.value()), forces).normal.value();
  };
  const auto [least, most] = std::minmax({pressed_at(wall.low), pressed_at(wall.high)});
  PlateStress of;
  of.compression = std::max(0.0, most);
  of.tension = std::max(0.0, -least);
  if (most > 0.0) of.psi = std::max(-3.0, least / most);
  return of;
}

int class_of(const BoxWall& wall, const PlateStress& stress) {
  if (!(stress.compression > 0.0)) return 1;
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
        "forces are judged on boxes without stiffeners and rectangular tubes whose plates are as "
        "thin as their steel has a strength for",
        "leave out --forces, or write for example \"box 600x1224 flange 12 web 8\"");
  }
  SectionUnderForces of{forces, 1, EffectiveBox(*walls), {}, {}, 0.0, nullptr};
  of.corner = of.box.worst_corner(forces);
  for (const ShearedPlate& sheared : sheared_plates_of(section, *walls, {}, false, 1.0)) {
    const BoxWall& wall = walls->of(sheared.plate);
    const PlateStress stress = stress_of(*walls, sheared.plate, forces);
    of.section_class = std::max(of.section_class, class_of(wall, stress));
    const Force V = sheared.force_of(forces);
    PlateUnderForces& plate = of.plates.emplace_back();
    plate.sheared = sheared;
    plate.web = sheared.plate == BoxPlate::left_web || sheared.plate == BoxPlate::right_web;
    plate.shear_use = V / sheared.resists.resistance;
    plate.reduced =
        reduced_stress_of(sheared.panel, si<Stress>(stress.compression), si<Stress>(stress.tension),
                          stress.psi, V / (wall.clear() * wall.thickness), 1.0);
    of.interaction_use =
        std::max(of.interaction_use, 1.0 / interaction_factor(of.corner.use, plate.shear_use));
  }
  of.reduced = &*std::max_element(
      of.plates.begin(), of.plates.end(),
      [](const auto& a, const auto& b) { return a.reduced.use < b.reduced.use; });
  return of;
}

}  // namespace boxbeam
