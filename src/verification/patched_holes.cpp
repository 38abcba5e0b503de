#include "patched_holes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "boxbeam/section/plate_force.hpp"
#include "boxbeam/verification/hole_gates.hpp"
#include "section_gate.hpp"

namespace boxbeam {
namespace {

/// Up to this use of the strip between a force and a hole it is borne beside it all the same; of
/// a flange that the force stands on up to this use of the webs.
constexpr double hardly_pressed = 0.1, hardly_stood_on = 0.01;

const PatchedWeb* web_of(const PatchBasis& basis) {
  if (const auto* const reduced = std::get_if<ReducedWeb>(&basis.bears)) return &reduced->web;
  return std::get_if<PatchedWeb>(&basis.bears);
}

/// How far the force uses the strip of a web between its edge and a hole, the thinner one of both,
/// as a beam clamped on both sides of the hole under all of the force in its middle:
///
///     m = F d/8 / (e^2 t f_y/4),  v = F/2 / (e t f_y/sqrt(3)),  n m + (n v)^2 = 1
///
/// e deep, t thick; used by 1/n. The flange on it is left out, on the safe side. Source: plastic
/// hinges of a clamped beam; m + v^2 = 1 lies inside what a rectangle bears.
double strip_use(const Project& project, const BeamHole& at, const PatchedWeb& web, Force force) {
  const Section section = section_at(project.beam, {at.s, Side::both});
  const Length d = at.hole.diameter, half = 0.5 * clear_for_holes(section.outer, at.hole.walls);
  const bool upright = at.hole.walls == HoleWalls::webs;
  const Length middle = upright ? clear_top_of(section.outer) - half : Length{};
  const Length e = half - abs(at.hole.position - middle) - 0.5 * d;
  if (!(e > Length{})) return std::numeric_limits<double>::infinity();
  const Force plastic = e * web.thickness * web.yield_strength;
  const double m = (force * d / (2.0 * e * plastic)).value();
  const double v = 0.5 * std::sqrt(3.0) * (force / plastic).value();
  return 0.5 * (m + std::hypot(m, 2.0 * v));
}

/// How far a force is spread along the beam at the level of a hole: 45 degrees from its edge.
Length spread_at(const Project& project, const Patch& patch, const BeamHole& at) {
  const Section section = section_at(project.beam, {at.s, Side::both});
  const Extent extent = extent_of(section.outer);
  const HoleWalls web = patch.along_z ? HoleWalls::webs : HoleWalls::flanges;
  const Length size = patch.along_z ? extent.z_high - extent.z_low : extent.y_high - extent.y_low;
  const Length clear = clear_for_holes(section.outer, web);
  if (at.hole.walls != web) return patch.stiff_length + (size - clear);
  const Length middle = patch.along_z
                            ? 0.5 * (clear_top_of(section.outer) + clear_bottom_of(section.outer))
                            : Length{};
  // The nearer edge, by whichever flange it comes; of pairs in flanges either one.
  const Length from_edge = 0.5 * clear - abs(at.hole.position - middle);
  return patch.stiff_length + (size - clear) + 2.0 * from_edge;
}

/// By how much more small holes in a row make of a force that a web bears: what they leave of the
/// loaded length along the beam at the level of one of them,
///
///     l/(l - sum d),  of a flange c/(c - sum d) across it
///
/// 1 where no other one is in the row, without bound where they leave nothing. Source: equilibrium
/// of what is above them; EN 1993-1-5:2006, 3.2.3 for l.
double raised_by_row(const Project& project, const Patch& patch, const BeamHole& at) {
  const HoleWalls web = patch.along_z ? HoleWalls::webs : HoleWalls::flanges;
  const Length length = spread_at(project, patch, at);
  std::vector<Hole> row;
  std::vector<Length> taken;
  for (const BeamHole& other : project.holes) {
    if (other.hole.walls != at.hole.walls) continue;
    const Length d = 0.5 * (at.hole.diameter + other.hole.diameter);
    if (at.hole.walls != web) {
      if (abs(other.s - at.s) < d) row.push_back(other.hole);
      continue;
    }
    if (abs(other.hole.position - at.hole.position) >= d) continue;
    const Length half = 0.5 * length, radius = 0.5 * other.hole.diameter;
    const Length from = std::max(Length(other.s - radius), Length(patch.s - half)),
                 to = std::min(Length(other.s + radius), Length(patch.s + half));
    if (to > from) taken.push_back(to - from);
  }
  Length whole = length, lost;
  if (at.hole.walls != web) {
    whole = clear_for_holes(section_at(project.beam, {at.s, Side::both}).outer, at.hole.walls);
    lost = taken_by_holes(row, at.hole.walls);
  } else {
    for (const Length& of : taken) lost += of;
  }
  const bool alone = at.hole.walls == web ? taken.size() < 2 : row.size() < 2;
  if (alone) return 1.0;
  if (!(lost < whole)) return std::numeric_limits<double>::infinity();
  return whole / (whole - lost);
}

}  // namespace

Length PatchedHoles::reach_of(const Patch& patch, const BeamHole& at) {
  const HoleWalls web = patch.along_z ? HoleWalls::webs : HoleWalls::flanges;
  const auto [known, is_new] = depths_.try_emplace({&at, patch.along_z});
  Depth& of = known->second;
  if (is_new) {
    const Section section = section_at(project_->beam, {at.s, Side::both});
    const Extent extent = extent_of(section.outer);
    const Length size = patch.along_z ? extent.z_high - extent.z_low : extent.y_high - extent.y_low;
    of.clear = clear_for_holes(section.outer, web);
    of.beside = size - of.clear;
  }
  // Half of s_s + 2 t_f, the flanges taken as thick as both together at the worst.
  const Length loaded = 0.5 * patch.stiff_length + of.beside;
  return loaded + 0.5 * at.hole.diameter + (at.hole.walls == web ? 0.5 * of.clear : Length{});
}

void PatchedHoles::take_small(const Patch& patch, const BeamHole& at, double use) {
  const double raised = raised_by_row(*project_, patch, at);
  if (raised == 1.0 || !(raised * use > 1.0)) return;
  Pressed& worst = worst_[&at];
  if (raised * use > worst.use) worst = {patch.s, patch.name, raised * use, false, true};
}

void PatchedHoles::take(const Patch& patch, const PatchBasis& basis, double load_factor,
                        double use) {
  if (patch.diaphragm != nullptr || patch.is_none()) return;
  const HoleWalls web_walls = patch.along_z ? HoleWalls::webs : HoleWalls::flanges;
  const PatchedWeb* const web = web_of(basis);
  const StrengthDemand& strength = project_->strength;
  for (const BeamHole& at : project_->holes) {
    const bool by_its_pin = patch.may_come_beside_flanges() && at.s == patch.s;
    if (by_its_pin || abs(at.s - patch.s) >= reach_of(patch, at)) continue;
    if (!is_wide(*project_, at)) {
      take_small(patch, at, use);
      continue;
    }
    const bool in_web = at.hole.walls == web_walls && web != nullptr;
    const double scale = strength.required * strength.gamma_M0 * load_factor * basis.share;
    const double of = in_web ? strip_use(*project_, at, *web, scale * abs(basis.force)) : use;
    if (!(of > (in_web ? hardly_pressed : hardly_stood_on))) continue;
    Pressed& worst = worst_[&at];
    if (of > worst.use) worst = {patch.s, patch.name, of, in_web};
  }
}

std::vector<Gate> PatchedHoles::gates() const {
  std::vector<Gate> gates;
  for (const BeamHole& at : project_->holes) {
    const auto of = worst_.find(&at);
    if (of == worst_.end()) continue;
    const auto& [s, by, use, in_web, in_row] = of->second;
    const std::string what =
        in_row ? fmt::format(
                     "presses what it and the holes in its row leave, which uses webs by "
                     "{:.3g} by that part",
                     use)
        : in_web
            ? fmt::format("presses the strip of the web beside it by {:.3g} of its strength", use)
            : fmt::format("stands on it or beside it, which uses whole webs by {:.3g}", use);
    gates.push_back(section_gate_at(
        *project_, {at.s, Side::both},
        fmt::format("hole \"{}\" at s = {} m: \"{}\" at s = {} m {} (EN 1993-1-5, 2.3, 6): a "
                    "diaphragm there takes it",
                    at.hole.name, to_text(Station{at.s, Side::both}), by,
                    to_text(Station{s, Side::both}), what)));
  }
  return gates;
}

}  // namespace boxbeam
