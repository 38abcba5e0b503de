#include "bent_flanges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "patched_path.hpp"

namespace boxbeam {

const PatchedWeb* web_in(const Borne& way) {
  if (const auto* const web = std::get_if<PatchedWeb>(&way.basis.bears)) return web;
  const auto* const reduced = std::get_if<ReducedWeb>(&way.basis.bears);
  return reduced == nullptr ? nullptr : &reduced->web;
}

std::optional<Flanges> flanges_across(const Patch& patch, const Borne& way) {
  Flanges of;
  const auto take = [&of](Length t, Stress f) {
    if (of.thickness > Length{} && t * t * f >= of.thickness * of.thickness * of.strength) return;
    of.thickness = t;
    of.strength = f;
  };
  if (way.basis.box) {
    using enum BoxPlate;
    const FourWalls& walls = way.basis.box->box();
    const BoxWall& high = walls.of(patch.along_z ? left_web : top_flange);
    const BoxWall& low = walls.of(patch.along_z ? right_web : bottom_flange);
    of.high = high.middle;
    of.low = low.middle;
    of.half_high = 0.5 * high.thickness;
    of.half_low = 0.5 * low.thickness;
    for (const BoxPlate plate : flanges_of(patch))
      take(walls.of(plate).thickness, walls.of(plate).yield_strength);
    return of;
  }
  if (!way.basis.path) return std::nullopt;
  // Last the flange by which it comes in: of walls that lean their places are there.
  const bool loaded = patch.force < Force{};
  for (const bool onto_high : {!loaded, loaded}) {
    const PathWebs webs = webs_of_path(way.basis.path->path(), patch.along_z, onto_high);
    if (webs.webs.size() != 2) return std::nullopt;
    const PathWeb &first = webs.webs.front(), &last = webs.webs.back();
    of.high = first.place;
    of.low = last.place;
    of.half_high = 0.5 * first.bears.thickness;
    of.half_low = 0.5 * last.bears.thickness;
    for (const PathWeb& web : webs.webs)
      take(web.bears.flange_thickness, web.bears.flange_strength);
  }
  return of;
}

void BentFlanges::take(const Patch& patch, const Borne& way, double load_factor, bool again) {
  Bent of{patch.s, {}, patch.bent};
  of.kinked = patch.bent > 0.0;
  of.along_z = patch.along_z;
  const auto flanges = project_->in_space && !patch.standing.empty() ? flanges_across(patch, way)
                                                                     : std::optional<Flanges>{};
  // Farther apart along the beam than the flange is wide each bends a width of its own.
  if (flanges && (!patch.together || patch.stiff_length <= flanges->apart())) {
    const double t_f = flanges->thickness.value();
    double m = 0.0;
    for (const Patch::Standing& at : patch.standing) {
      const Length place = flanges->farthest_place(at);
      const Length beside = flanges->beside(place) - flanges->thickness;
      if (!(beside > Length{})) continue;
      of.beside = std::max(of.beside, beside);
      const double F = std::abs(at.force.value());
      const bool between = flanges->between(place);
      // Along the beam a strip: clamped at both webs, or held by one.
      if (patch.is_line)
        m += F / patch.stiff_length.value() *
             (between ? bent_strip * flanges->apart().value() : flanges->beside(place).value());
      else
        m += (between ? bent_between : bent_outside) * F;
    }
    of.use += 6.0 * m / (t_f * t_f) / flanges->strength.value();
  }
  // A kink by itself has been looked at where it is.
  if (!(of.use > 0.0) || (patch.together && of.use == patch.bent)) return;
  const Stress strength = flanges ? flanges->strength : web_in(way)->flange_strength;
  of.again = again && of.use * strength > hardly_changes;
  load_factor *= project_->strength.required;
  of.use *= load_factor;
  const double own = load_factor * project_->strength.gamma_M0 *
                     (way.basis.path ? way.basis.place.use : way.basis.corner.use);
  of.with_own = std::sqrt(of.use * of.use + own * own + of.use * own);
  if (!(of.use > hardly_bent) && !of.again) return;
  Bent& most = bent_[patch.name];
  if (of.with_own > most.with_own) most = of;
}

std::string BentFlanges::words_of(const Bent& of) {
  const char* const again = of.again ? ", nor counted in fatigue" : "";
  if (of.kinked)
    return fmt::format(
        "how it is bent across where it turns off, by about {:.2g} of its strength, is not "
        "checked{}: [[beam.diaphragms]] take it",
        of.use, again);
  return fmt::format(
      "how a force {:.3g} mm beside the {} bends it across, by about {:.2g} of its strength, is "
      "not checked{}: [[beam.diaphragms]] take it{}",
      1e3 * of.beside.value(), of.along_z ? "webs" : "flanges", of.use, again,
      of.along_z ? ", or into = \"webs\" says that it does not stand there" : "");
}

void BentFlanges::add_to(std::vector<NotJudged>& found) const {
  const Bent* turned = nullptr;
  const std::pair<const std::string, Bent>* stood_on = nullptr;
  int others = 0;
  bool again = false;
  for (const auto& named : bent_) {
    const Bent& of = named.second;
    if (of.with_own > 1.0) continue;
    if (of.kinked) {
      again = again || of.again;
      if (turned == nullptr || of.use > turned->use) turned = &of;
    } else {
      if (stood_on != nullptr) ++others;
      if (stood_on == nullptr || of.use > stood_on->second.use) stood_on = &named;
    }
  }
  if (turned != nullptr)
    found.push_back(
        {Criterion::patch_loading, "flanges that turn off",
         fmt::format("bent across by about {:.2g} of their strength at s = {} m, not checked{} "
                     "([[beam.diaphragms]] take it)",
                     turned->use, to_text(Station{turned->s, Side::both}),
                     again ? ", nor in fatigue" : "")});
  if (stood_on != nullptr)
    found.push_back({Criterion::patch_loading,
                     fmt::format("flange under {}{} at s = {} m", stood_on->first,
                                 others > 0 ? fmt::format(" and {} more", others) : "",
                                 to_text(Station{stood_on->second.s, Side::both})),
                     words_of(stood_on->second)});
}

}  // namespace boxbeam
