#include "patch_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "patched_path.hpp"

namespace boxbeam {
namespace {

const PatchedWeb* web_in(const Borne& way) {
  if (const auto* const web = std::get_if<PatchedWeb>(&way.basis.bears)) return web;
  const auto* const reduced = std::get_if<ReducedWeb>(&way.basis.bears);
  return reduced == nullptr ? nullptr : &reduced->web;
}

}  // namespace

PatchNotes::PatchNotes(const Project& project, std::vector<FlangeStep> steps,
                       const PressedWebs* counted)
    : project_(&project), counted_(counted), steps_(std::move(steps)), at_steps_(steps_.size()) {}

void PatchNotes::take_steps(const CutForceDiagram& diagram, double load_factor) {
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    for (const Side side : {Side::before, Side::behind}) {
      const double force = steps_[k].ends.force_under(diagram.at({steps_[k].ends.s, side})).value();
      at_steps_[k] = std::max(at_steps_[k], load_factor * std::abs(force));
    }
  }
}

void PatchNotes::take(const Patch& patch, const std::vector<Borne>& ways,
                      const Situation& situation) {
  if (patch.together || patch.diaphragm != nullptr) return;
  for (const Borne& way : ways) {
    if (web_in(way) != nullptr) take_flange(patch, way, situation.load_factor);
  }
  if (has_cycles(*project_, situation)) take_cycles(patch, ways);
}

void PatchNotes::take_flange(const Patch& patch, const Borne& way, double load_factor) {
  const PatchedWeb& web = *web_in(way);
  BentFlange of{patch.s, {}, 0.0};
  if (patch.kink != nullptr) {
    of.use = stress_across_kink(*patch.kink, patch.force) / patch.kink->yield_strength;
  } else if (project_->in_space && way.basis.box) {
    const FourWalls& walls = way.basis.box->box();
    using enum BoxPlate;
    const auto beside = [&](BoxPlate plate) {
      const BoxWall& wall = walls.of(plate);
      return abs(place_of(patch) - wall.middle) - 0.5 * wall.thickness - web.flange_thickness;
    };
    of.beside = patch.along_z ? std::min(beside(left_web), beside(right_web))
                              : std::min(beside(top_flange), beside(bottom_flange));
    if (!(of.beside > Length{})) return;
    const auto [webs_high, webs_low] =
        patch.along_z ? std::pair{left_web, right_web} : std::pair{top_flange, bottom_flange};
    const bool between =
        place_of(patch) < walls.of(webs_high).middle && place_of(patch) > walls.of(webs_low).middle;
    const double t_f = web.flange_thickness.value();
    of.use = 6.0 * (between ? bent_between : bent_outside) * std::abs(patch.force.value()) /
             (t_f * t_f) / web.flange_strength.value();
  }
  of.use *= load_factor;
  const double own = load_factor * project_->strength.gamma_M0 * way.basis.corner.use;
  of.with_own = std::sqrt(of.use * of.use + own * own + of.use * own);
  if (!(of.use > hardly_bent)) return;
  BentFlange& most = bent_[patch.name];
  if (of.with_own > most.with_own) most = of;
}

void PatchNotes::take_cycles(const Patch& patch, const std::vector<Borne>& ways) {
  if (!project_->fatigue.asked || patch.may_come_beside_flanges()) return;
  double most = 0.0;
  for (const Borne& way : ways) {
    const PatchedWeb* const web = web_in(way);
    if (web == nullptr) continue;
    if (counted_ != nullptr && way.basis.box && PressedWebs::counts(patch)) continue;
    const double stress = (way.basis.share * way.basis.force).value() /
                          (web->thickness * loaded_length_of(*web)).value();
    most = std::max(most, stress);
  }
  // From above or from below: what pushes and what pulls.
  const double stress = patch.force.value() > 0.0 ? most : -most, s = patch.s.value();
  PressedWeb& of = pressed_[{patch.name, patch.along_z}];
  if (!of.known) of = {stress, stress, s, s, true};
  of.least = std::min(of.least, stress);
  of.most = std::max(of.most, stress);
  of.from = std::min(of.from, s);
  of.to = std::max(of.to, s);
}

std::string PatchNotes::words_of(const BentFlange& of) {
  return of.beside > Length{}
             ? fmt::format(
                   "how a force {:.3g} mm beside the webs bends it across, by about {:.2g} "
                   "of its strength, is not checked: [[beam.diaphragms]] take it, or "
                   "into = \"webs\" says that it does not stand there",
                   1e3 * of.beside.value(), of.use)
             : fmt::format(
                   "how it is bent across where it turns off, by about {:.2g} of its "
                   "strength, is not checked: [[beam.diaphragms]] take it",
                   of.use);
}

std::vector<Gate> PatchNotes::gates() const {
  std::vector<Gate> found;
  for (const auto& [name, of] : bent_) {
    if (!(of.with_own > 1.0)) continue;
    const std::size_t segment = segment_at(project_->beam, {of.s, Side::both});
    found.push_back({project_->beam.segments[segment].name, "",
                     fmt::format("flange under {} at s = {} m: {}", name,
                                 to_text(Station{of.s, Side::both}), words_of(of)),
                     true});
  }
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    // Of both that end there the one that bears more.
    const std::size_t other = k % 2 == 0 ? k + 1 : k - 1;
    if (at_steps_[other] > at_steps_[k] || (at_steps_[other] == at_steps_[k] && other < k))
      continue;
    const FlangeKink& of = steps_[k].ends;
    if (!(at_steps_[k] > hardly_bent * (of.area * of.yield_strength).value())) continue;
    const std::size_t segment = segment_at(project_->beam, {of.s, Side::both});
    found.push_back(
        {project_->beam.segments[segment].name, "",
         fmt::format("{} at s = {} m: it ends where the next one lies {:.3g} mm away; how its "
                     "force, {:.4g} kN, is led on is not judged: a taper between both leads it",
                     of.name, to_text(Station{of.s, Side::both}), 1e3 * steps_[k].by.value(),
                     1e-3 * at_steps_[k]),
         true});
  }
  return found;
}

std::vector<NotJudged> PatchNotes::not_judged() const {
  std::vector<NotJudged> found;
  for (const auto& [name, of] : bent_) {
    if (of.with_own > 1.0) continue;
    found.push_back(
        {Criterion::patch_loading,
         fmt::format("flange under {} at s = {} m", name, to_text(Station{of.s, Side::both})),
         words_of(of)});
  }
  for (const auto& [key, of] : pressed_) {
    // What moves on is gone from a place.
    const bool moves = of.to - of.from > 1e-6 * project_->beam.length().value();
    const double range =
        std::max(of.most, moves ? 0.0 : of.least) - std::min(of.least, moves ? 0.0 : of.most);
    if (!(range > hardly_changes.value())) continue;
    found.push_back(
        {Criterion::patch_loading, fmt::format("web under {}", key.first),
         fmt::format("sigma_z = F/(t (s_s + 2 t_f)), which comes and goes by {:.3g} MPa, and its "
                     "seams are not counted in fatigue (EN 1993-1-9, table 8.10)",
                     1e-6 * range)});
  }
  return found;
}

}  // namespace boxbeam
