// Forces that come into walls of paths which bear them unlike webs: estimates of what leads them
// in.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/patch_loading.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "patched_path.hpp"

namespace boxbeam {
namespace {

/// The walls along a force on one side of a section.
struct LedSide {
  double reach = 0.0;   ///< along the force, all of them [m]
  double middle = 0.0;  ///< across it, where it is theirs [m]

  void take(double by, double at) {
    middle = (middle * reach + at * by) / (reach + by);
    reach += by;
  }
};

/// What of a section is along a force, and across it.
struct LedWalls {
  LedSide low, high;  ///< both all of it where it stands at one place
  double depth = 0.0, width = 0.0;
  std::vector<double> ends;                                 ///< of its walls, across the force [m]
  double flange = std::numeric_limits<double>::infinity();  ///< the thinnest plate across it [m]
};

LedWalls walls_along(const PathSection& path, bool along_z) {
  const Eigen::Index along = along_z ? 1 : 0;
  struct Wall {
    double reach, middle;
  };
  std::vector<Wall> held, free;
  LedWalls of;
  for (const PathPlate& plate : path.plates) {
    const Eigen::Vector2d a = path.graph.nodes[plate.nodes[0]],
                          b = path.graph.nodes[plate.nodes[1]];
    const double reach = std::abs((b - a)[along]);
    of.depth = std::max(of.depth, reach);
    of.width = std::max(of.width, std::abs((b - a)[1 - along]));
    constexpr double steep = 0.17364817766693033;  // sin(10 deg), as of webs
    if (!(reach > steep * (b - a).norm())) {
      of.flange = std::min(of.flange, plate.thickness.value());
      continue;
    }
    (plate.outstand() ? free : held).push_back({reach, 0.5 * (a + b)[1 - along]});
    of.ends.insert(of.ends.end(), {a[1 - along], b[1 - along]});
  }
  const std::vector<Wall>& walls = held.empty() ? free : held;
  if (walls.empty()) return of;
  const auto [first, last] = std::minmax_element(
      walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.middle < b.middle; });
  const double from = first->middle, to = last->middle;
  // What stands between the outer ones is left out; those within a tenth of the way are at one
  // place.
  const double near = 0.1 * std::max(to - from, 0.1 * of.depth);
  for (const Wall& wall : walls) {
    if (wall.middle <= from + near) of.low.take(wall.reach, wall.middle);
    if (wall.middle >= to - near) of.high.take(wall.reach, wall.middle);
  }
  return of;
}

/// The larger part of a force that one side takes: by its lever between both.
double larger_share(const Project& project, const Patch& patch, const LedWalls& of) {
  const double apart = of.high.middle - of.low.middle;
  if (!(apart > 0.1 * of.depth)) return 1.0;
  if (patch.is_torque()) return 1.0;
  if (!project.in_space) return 0.5;
  const double by_high = (patch.stands_at().value() - of.low.middle) / apart;
  return std::max(std::abs(by_high), std::abs(1.0 - by_high));
}

/// Of the forces of a patch that stand where no wall ends the most on a length across it.
double beside_walls(const Patch& patch, const LedWalls& of, double length) {
  const auto on_wall = [&](double at) {
    return std::any_of(of.ends.begin(), of.ends.end(),
                       [&](double end) { return std::abs(at - end) <= 2.0 * of.flange; });
  };
  double most = 0.0;
  for (const Patch::Standing& first : patch.standing) {
    double here = 0.0;
    for (const Patch::Standing& other : patch.standing) {
      const double at = other.places[1].value(), away = at - first.places[1].value();
      if (away >= 0.0 && away < length && !on_wall(at)) here += std::abs(other.force.value());
    }
    most = std::max(most, here);
  }
  return most;
}

}  // namespace

LedUse led_into_walls(const Project& project, const Patch& patch, const PathSection& path,
                      const Station& station) {
  if (patch.diaphragm == nullptr || patch.is_none()) return {};
  const Diaphragm& by = *patch.diaphragm;
  const std::vector<PlateOf> joined = plates_around(project, station.s, by.thickness);
  const PlateOf weak = first_to_yield(joined), welded = weakest_to_weld(joined);
  const auto yield = yield_strength_of(*weak.material, weak.thickness);
  const auto tensile = tensile_strength_of(*welded.material, welded.thickness);
  if (!yield || !tensile) return {std::numeric_limits<double>::infinity(), 0.0};
  const LedWalls of = walls_along(path, patch.along_z);
  const double depth = std::max(of.low.reach, of.high.reach);
  if (!(depth > 0.0)) return {};
  const double reach = std::min(of.low.reach, of.high.reach);
  const double force = std::abs(patch.force.value()), a = by.throat.value();
  const double f_w = tensile->value() / (welded.material->beta_w * project.strength.gamma_M2);
  const double share = larger_share(project, patch, of);
  // Fillets on both faces along the walls, tau = F/(2 a h).
  LedUse use;
  use.across = a > 0.0 ? share * force * std::numbers::sqrt3 / (2.0 * a * reach * f_w) : 0.0;
  ShearPanel panel;
  panel.depth = si<Length>(depth);
  panel.thickness = by.thickness;
  panel.yield_strength = *yield;
  panel.length = si<Length>(std::max(of.width, of.high.middle - of.low.middle));
  const double left = std::max(0.0, 1.0 - by.opening.value() / depth) * (reach / depth) *
                      shear_resistance_of(panel, project.strength.gamma_M1).resistance.value();
  use.across = std::max(use.across, share * force / left);
  if (!project.in_space || patch.is_torque() || !std::isfinite(of.flange)) return use;
  if (!(patch.stiff_length > Length{})) return use;
  // Under what stands where no wall does: its edge, and its fillets there, with sigma = tau.
  const double pressed = patch.stiff_length.value() + 2.0 * of.flange;
  const double under = beside_walls(patch, of, pressed);
  use.edge = under / (pressed * by.thickness.value() * yield->value());
  if (a > 0.0)
    use.across = std::max(use.across, under * std::numbers::sqrt2 / (2.0 * a * pressed * f_w));
  return use;
}

double pressed_by_weakest(const Project& project, const Patch& patch, const PathSection& path) {
  double least = std::numeric_limits<double>::infinity();
  for (const PathPlate& plate : path.plates) {
    PatchedWeb web;
    web.depth = plate.clear();
    web.thickness = web.flange_thickness = plate.thickness;
    web.yield_strength = web.flange_strength = plate.yield_strength;
    web.stiff_length = patch.stiff_length;
    if (!(web.depth > web.thickness)) continue;
    least = std::min(least, patch_resistance_of(web, project.strength.gamma_M1).resistance.value());
  }
  return std::abs(patch.force.value()) / least;
}

}  // namespace boxbeam
