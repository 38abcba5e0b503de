#include "patched_holes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/section/plate_force.hpp"
#include "boxbeam/verification/hole_gates.hpp"

namespace boxbeam {
namespace {

/// Up to this use of whole webs a force is borne beside a hole all the same: the flange over one of
/// 0.7 of the web just under it bears about a sixth of what the web does.
constexpr double hardly_pressed = 0.1;

/// How far from a force a hole matters, from centre to centre.
Length reach_of(const Project& project, const Patch& patch, const BeamHole& at) {
  const Section section = section_at(project.beam, {at.s, Side::both});
  const HoleWalls web = patch.along_z ? HoleWalls::webs : HoleWalls::flanges;
  const Extent extent = extent_of(section.outer);
  const Length size = patch.along_z ? extent.z_high - extent.z_low : extent.y_high - extent.y_low;
  const Length depth = clear_for_holes(section.outer, web);
  // Half of s_s + 2 t_f, the flanges taken as thick as both together at the worst.
  const Length loaded = 0.5 * patch.stiff_length + (size - depth);
  return loaded + 0.5 * at.hole.diameter + (at.hole.walls == web ? 0.5 * depth : Length{});
}

}  // namespace

void PatchedHoles::take(const Patch& patch, double use) {
  if (patch.diaphragm != nullptr || patch.is_none() || !(use > hardly_pressed)) return;
  for (const BeamHole& at : project_->holes) {
    const bool by_its_pin = patch.may_come_beside_flanges() && at.s == patch.s;
    if (by_its_pin || abs(at.s - patch.s) >= reach_of(*project_, patch, at) ||
        !is_wide(*project_, at))
      continue;
    Pressed& worst = worst_[&at];
    if (use > worst.use) worst = {patch.s, patch.name, use};
  }
}

std::vector<Gate> PatchedHoles::gates() const {
  std::vector<Gate> gates;
  for (const BeamHole& at : project_->holes) {
    const auto of = worst_.find(&at);
    if (of == worst_.end()) continue;
    const auto& [s, by, use] = of->second;
    gates.push_back(
        {project_->beam.segments[segment_at(project_->beam, {at.s, Side::both})].name, "",
         fmt::format(
             "hole \"{}\" at s = {} m: \"{}\" presses the webs by {:.3g} of what whole ones "
             "bear at s = {} m (EN 1993-1-5, 2.3, 6): a diaphragm there takes it",
             at.hole.name, to_text(Station{at.s, Side::both}), by, use,
             to_text(Station{s, Side::both})),
         true});
  }
  return gates;
}

}  // namespace boxbeam
