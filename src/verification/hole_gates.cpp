#include "boxbeam/verification/hole_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/plate_force.hpp"
#include "boxbeam/verification/judged_section.hpp"

namespace boxbeam {
namespace {

/// From this part of a plate's width on the bending of the strips beside a hole is looked at, above
/// this part of the yield strength it stops a verdict.
constexpr double large_hole = 0.3, felt = 0.05;

std::string name_of(const BeamHole& at) {
  return fmt::format("hole \"{}\" at s = {} m", at.hole.name, to_text(Station{at.s, Side::both}));
}

Gate gate_at(const Project& project, const BeamHole& at, const std::string& finding) {
  const std::size_t segment = segment_at(project.beam, {at.s, Side::both});
  return {project.beam.segments[segment].name, "", name_of(at) + finding, true};
}

const Diaphragm* diaphragm_in(const Project& project, const BeamHole& at) {
  for (const Diaphragm& of : project.beam.diaphragms)
    if (abs(of.s - at.s) < 0.5 * (at.hole.diameter + of.thickness)) return &of;
  return nullptr;
}

/// How a hole leaves a plate to bend beside it.
struct StripBending {
  std::string place;
  double share = 0.0;  ///< of the plate's width that the hole takes
  Stress stress;
  double used = 0.0;  ///< of the yield strength
};

/// The bending stress of strips over the mean shear stress in them, each a rectangle of its own:
///
///     sigma/tau = 6 x 0.225 n d/c,  c what the n strips are wide together
double bending_per_shear(const BeamHole& at, const StressField& field) {
  const HoleWalls walls = at.hole.walls;
  const Length taken = taken_by_holes(field.holes, walls);
  const Length left = clear_for_holes(field.section.outer, walls) - taken;
  int strips = 1;
  for (const Hole& of : field.holes) {
    if (of.walls == walls)
      strips += walls == HoleWalls::flanges && of.position.value() != 0.0 ? 2 : 1;
  }
  return 6.0 * 0.225 * strips * at.hole.diameter / left;
}

/// Where the strips on a side of a station bend most.
std::optional<StripBending> strip_bending_at(const Project& project,
                                             const std::deque<SituationRun>& runs,
                                             const BeamHole& at, const Station& station) {
  const Section section = judged_section_at(project, station);
  const double share = at.hole.diameter / clear_for_holes(section.outer, at.hole.walls);
  if (share <= large_hole) return std::nullopt;
  const Taper taper = taper_at(project.beam, station);
  const StressField field = stress_field_of(section, holes_at(project, station.s), taper);
  const StressField whole = stress_field_of(section, {}, taper);
  const PlateMaterials materials = materials_of(project, segment_at(project.beam, station));
  const double per_shear = bending_per_shear(at, field);
  const std::vector<SituationHistory> histories = histories_at(runs, station);
  StripBending worst;
  for (const PlateStrip& strip : strips_beside(
           field, whole, at.hole, project.in_space ? PointSet::in_space : PointSet::in_plane)) {
    const SectionPoint& point = strip.point;
    const PlateOf plate = first_to_yield(plates_at(materials, section, point.y, point.z));
    const double yield = yield_strength_of(*plate.material, plate.thickness)->value();
    for (const SituationHistory& of : histories) {
      for (const CutForces& cut : of.history.samples()) {
        const double stress =
            of.situation->load_factor * per_shear * std::abs(stress_of(point.influence.shear, cut));
        const double used = project.strength.required * project.strength.gamma_M0 * stress / yield;
        if (used > worst.used) worst = {point.name, share, si<Stress>(stress), used};
      }
    }
  }
  return worst;
}

std::optional<StripBending> strip_bending_of(const Project& project,
                                             const std::deque<SituationRun>& runs,
                                             const BeamHole& at) {
  std::optional<StripBending> worst;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? at.s == Length{} : at.s == project.beam.length()) continue;
    auto here = strip_bending_at(project, runs, at, {at.s, side});
    if (here && (!worst || here->used > worst->used)) worst = std::move(here);
  }
  return worst;
}

}  // namespace

bool is_wide(const Project& project, const BeamHole& at) {
  const Section section = section_at(project.beam, {at.s, Side::both});
  return at.hole.diameter > widest_opening * clear_for_holes(section.outer, at.hole.walls);
}

std::vector<Gate> hole_gates_of(const Project& project, const std::deque<SituationRun>& runs) {
  std::vector<Gate> gates;
  for (const BeamHole& at : project.holes) {
    if (is_wide(project, at)) {
      const Length radius = 0.5 * at.hole.diameter;
      if (const Diaphragm* of = diaphragm_in(project, at))
        gates.push_back(gate_at(project, at,
                                fmt::format(": the diaphragm at s = {} m stands on it, which is "
                                            "taken to stand on whole plates",
                                            to_text(Station{of->s, Side::both}))));
      if (at.s < radius || at.s > project.beam.length() - radius)
        gates.push_back(gate_at(project, at,
                                " reaches over the end of the beam, which is taken to be "
                                "that of whole plates"));
    }
    if (at.concentration) continue;
    const auto bending = strip_bending_of(project, runs, at);
    if (!bending || !(bending->used > felt)) continue;
    gates.push_back(gate_at(
        project, at,
        fmt::format(" takes {:.3g} of its plate's width: under the plate's force what it leaves "
                    "bends by about {:.3g} MPa (F/n 0.225 d in each strip by itself, {}), which "
                    "is not judged by a detail alone; concentration = \"{}\" judges its edge",
                    bending->share, bending->stress.value() * 1e-6, bending->place,
                    at.hole.walls == HoleWalls::webs ? "in-plane bending" : "membrane tension")));
  }
  return gates;
}

}  // namespace boxbeam
