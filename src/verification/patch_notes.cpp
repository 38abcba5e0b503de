#include "patch_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "patched_path.hpp"

namespace boxbeam {
namespace {

const PatchedWeb* web_in(const Borne& way) {
  if (const auto* const web = std::get_if<PatchedWeb>(&way.basis.bears)) return web;
  const auto* const reduced = std::get_if<ReducedWeb>(&way.basis.bears);
  return reduced == nullptr ? nullptr : &reduced->web;
}

/// Where a force stands on the flange of a box.
struct OnFlange {
  Length beside;         ///< the faces of both webs, the nearer one; below zero above one
  Length apart;          ///< the middles of the webs
  bool between = false;  ///< them
};

OnFlange on_flange(const Patch& patch, const FourWalls& walls) {
  using enum BoxPlate;
  const BoxWall& high = walls.of(patch.along_z ? left_web : top_flange);
  const BoxWall& low = walls.of(patch.along_z ? right_web : bottom_flange);
  const Length place = (patch.along_z ? 1.0 : -1.0) * patch.stands_couple / patch.stands;
  const auto beside = [&](const BoxWall& wall) {
    return abs(place - wall.middle) - 0.5 * wall.thickness;
  };
  return {std::min(beside(high), beside(low)), high.middle - low.middle,
          place < high.middle && place > low.middle};
}

}  // namespace

PatchNotes::PatchNotes(const Project& project, std::vector<FlangeStep> steps,
                       const PressedWebs* counted)
    : project_(&project),
      counted_(counted),
      steps_(std::move(steps)),
      at_steps_(steps_.size()) {}

void PatchNotes::take_instant(const CutForceDiagram& diagram, const Situation& situation,
                              bool all) {
  if (all && has_cycles(*project_, situation)) ++instants_;
  const double load_factor = situation.load_factor;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    for (const Side side : {Side::before, Side::behind}) {
      const CutForces cut = diagram.at({steps_[k].s, side});
      for (const PlateForce* const of : {&steps_[k].along, &steps_[k].across})
        at_steps_[k] = std::max(at_steps_[k], project_->strength.required * load_factor *
                                                  std::abs(stress_of(*of, cut)));
    }
  }
}

void PatchNotes::take(const Patch& patch, const std::vector<Borne>& ways,
                      const Situation& situation, bool all) {
  if (patch.kink != nullptr && patch.kink->knee) {
    for (const Borne& way : ways) take_corner(patch, way, situation.load_factor);
  }
  if (patch.diaphragm != nullptr) {
    for (const Borne& way : ways) take_diaphragm(patch, way, situation.load_factor);
    return;
  }
  const bool again = project_->fatigue.asked && has_cycles(*project_, situation);
  for (const Borne& way : ways) {
    if (web_in(way) != nullptr) take_flange(patch, way, situation.load_factor, again);
  }
  if (patch.together) return;
  if (has_cycles(*project_, situation)) take_cycles(patch, ways, all);
}

void PatchNotes::keep(const std::string& name, const BentFlange& of) {
  if (!(of.use > hardly_bent) && !of.again) return;
  BentFlange& most = bent_[name];
  if (of.with_own > most.with_own) most = of;
}

namespace {

/// Keeps the largest of a name, and where that is.
void keep_most(std::map<std::string, std::pair<double, Length>>& of, const std::string& name,
               double use, Length s) {
  auto& [most, at] = of[name];
  if (use > most) std::tie(most, at) = std::pair(use, s);
}

}  // namespace

void PatchNotes::take_corner(const Patch& patch, const Borne& way, double load_factor) {
  if (way.part != Borne::Part::plate) return;
  Length depth, thickness;
  Stress strength;
  if (const PatchedWeb* const web = web_in(way)) {
    depth = web->depth;
    thickness = web->thickness;
    strength = web->yield_strength;
  } else if (const auto* const by = std::get_if<BearingStiffener>(&way.basis.bears)) {
    depth = by->web_depth;
    thickness = by->web_thickness;
    strength = by->yield_strength;
  } else {
    return;
  }
  const StrengthDemand& demand = project_->strength;
  const Force bears = depth * thickness * strength / (std::numbers::sqrt3 * demand.gamma_M0);
  keep_most(corners_, patch.name,
            demand.required * load_factor * (way.basis.share * way.basis.force / bears).value(),
            patch.s);
}

void PatchNotes::take_diaphragm(const Patch& patch, const Borne& way, double load_factor) {
  const auto* const stiffener = std::get_if<BearingStiffener>(&way.basis.bears);
  if (stiffener == nullptr || !way.basis.box || patch.stands == Force{} || !project_->in_space)
    return;
  const FourWalls& walls = way.basis.box->box();
  const BoxPlate flange = patch.along_z ? BoxPlate::top_flange : BoxPlate::left_web;
  if (!(on_flange(patch, walls).beside > walls.of(flange).thickness)) return;
  // What goes to this web shears it: beside an access hole, taken as deep as it is wide.
  ShearPanel panel;
  panel.depth = stiffener->web_depth;
  panel.thickness = stiffener->thickness;
  panel.yield_strength = stiffener->yield_strength;
  panel.length = walls.of(flange).clear();
  const double left =
      std::max(0.0, 1.0 - (patch.diaphragm->opening / stiffener->web_depth).value());
  const Force bears = left * shear_resistance_of(panel, project_->strength.gamma_M1).resistance;
  const double use = project_->strength.required * load_factor *
                     (way.basis.share * way.basis.force / bears).value();
  keep_most(sheared_, patch.name, use, patch.s);
  // A pad is taken to be as wide as it is long.
  const Length pressed = patch.stiff_length + 2.0 * walls.of(flange).thickness;
  const Force edge = pressed * stiffener->thickness * stiffener->yield_strength;
  keep_most(edges_, patch.name,
            project_->strength.required * load_factor * (abs(patch.stands) / edge).value(),
            patch.s);
}

void PatchNotes::take_flange(const Patch& patch, const Borne& way, double load_factor, bool again) {
  const PatchedWeb& web = *web_in(way);
  BentFlange of{patch.s, {}, patch.bent};
  of.kinked = patch.bent > 0.0;
  if (project_->in_space && way.basis.box && patch.stands != Force{} && !patch.is_torque) {
    const OnFlange at = on_flange(patch, way.basis.box->box());
    of.beside = at.beside - web.flange_thickness;
    // Farther apart along the beam than the flange is wide each bends a width of its own.
    const bool one_place = !patch.together || patch.stiff_length <= at.apart;
    if (of.beside > Length{} && one_place) {
      const double F = std::abs(patch.stands.value()), t_f = web.flange_thickness.value();
      double m = (at.between ? bent_between : bent_outside) * F;
      // Along the beam a strip: clamped at both webs, or held by one.
      if (patch.is_line)
        m = F / patch.stiff_length.value() *
            (at.between ? bent_strip * at.apart.value() : at.beside.value());
      of.use += 6.0 * m / (t_f * t_f) / web.flange_strength.value();
    }
  }
  // A kink by itself has been looked at where it is.
  if (!(of.use > 0.0) || (patch.together && of.use == patch.bent)) return;
  of.again = again && of.use * web.flange_strength > hardly_changes;
  load_factor *= project_->strength.required;
  of.use *= load_factor;
  const double own = load_factor * project_->strength.gamma_M0 *
                     (way.basis.path ? way.basis.place.use : way.basis.corner.use);
  of.with_own = std::sqrt(of.use * of.use + own * own + of.use * own);
  keep(patch.name, of);
}

void PatchNotes::take_cycles(const Patch& patch, const std::vector<Borne>& ways, bool all) {
  if (!project_->fatigue.asked) return;
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
  of.unsaid = of.unsaid || !patch.given;
  if (all) ++of.seen;
  of.least = std::min(of.least, stress);
  of.most = std::max(of.most, stress);
  of.from = std::min(of.from, s);
  of.to = std::max(of.to, s);
}

std::string PatchNotes::words_of(const BentFlange& of) {
  const char* const again = of.again ? ", nor counted in fatigue" : "";
  if (of.kinked)
    return fmt::format(
        "how it is bent across where it turns off, by about {:.2g} of its strength, is not "
        "checked{}: [[beam.diaphragms]] take it",
        of.use, again);
  return fmt::format(
      "how a force {:.3g} mm beside the webs bends it across, by about {:.2g} of its strength, is "
      "not checked{}: [[beam.diaphragms]] take it, or into = \"webs\" says that it does not stand "
      "there",
      1e3 * of.beside.value(), of.use, again);
}

std::vector<Gate> PatchNotes::gates() const {
  std::vector<Gate> found;
  const auto add = [&](Length s, std::string why) {
    const std::size_t segment = segment_at(project_->beam, {s, Side::both});
    found.push_back({project_->beam.segments[segment].name, "", std::move(why), true});
  };
  const auto add_used = [&](const std::map<std::string, std::pair<double, Length>>& uses,
                            const auto& why) {
    for (const auto& [name, of] : uses) {
      const auto& [use, s] = of;
      if (use > 1.0) add(s, why(name, to_text(Station{s, Side::both}), use));
    }
  };
  for (const auto& [name, of] : bent_) {
    if (of.with_own > 1.0)
      add(of.s, fmt::format("flange under {} at s = {} m: {}", name,
                            to_text(Station{of.s, Side::both}), words_of(of)));
  }
  add_used(sheared_, [](const std::string& name, const std::string& s, double use) {
    return fmt::format(
        "diaphragm at s = {} m: \"{}\" stands between its webs and uses its plate in shear by "
        "{:.3g} (EN 1993-1-5, 5.2): a thicker one",
        s, name, use);
  });
  add_used(corners_, [](const std::string& name, const std::string& s, double use) {
    return fmt::format(
        "webs in the corner at s = {} m: what \"{}\" turns off shears them by {:.3g} of their "
        "strength: thicker ones",
        s, name, use);
  });
  // Of all of a name that end there, on either side, the one that bears most.
  std::map<std::pair<Length, std::string>, std::size_t> most;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const FlangeStep& of = steps_[k];
    if (!(at_steps_[k] > hardly_bent * (of.area * of.yield_strength).value())) continue;
    std::size_t& at = most.try_emplace({of.s, of.name}, k).first->second;
    if (at_steps_[k] > at_steps_[at]) at = k;
  }
  for (const auto& [key, k] : most) {
    const FlangeStep& of = steps_[k];
    add(of.s, fmt::format(
                  "{} at s = {} m: it ends where {}; how its force, {:.4g} kN, is led on is not "
                  "judged: a taper between both leads it{}",
                  of.name, to_text(Station{of.s, Side::both}),
                  of.by ? fmt::format("the next one lies {:.3g} mm away", 1e3 * of.by->value())
                        : "none goes on",
                  1e-3 * at_steps_[k], of.web ? ", or a diaphragm" : ""));
  }
  return found;
}

std::vector<NotJudged> PatchNotes::not_judged() const {
  // Of each kind one, by its worst: a verdict is to be read.
  std::vector<NotJudged> found;
  const BentFlange* turned = nullptr;
  const std::pair<const std::string, BentFlange>* stood_on = nullptr;
  int others = 0;
  bool again = false;
  for (const auto& named : bent_) {
    const BentFlange& of = named.second;
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
  const auto edge = std::max_element(
      edges_.begin(), edges_.end(),
      [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
  if (edge != edges_.end() && edge->second.first > 1.0)
    found.push_back(
        {Criterion::patch_loading,
         fmt::format("edge of the diaphragm at s = {} m",
                     to_text(Station{edge->second.second, Side::both})),
         fmt::format("as no more than a point \"{}\" presses it by {:.3g} of its strength: "
                     "[[beam.load_introductions]] say how long its pad is",
                     edge->first, edge->second.first)});
  double most = 0.0;
  bool unsaid = false;
  std::vector<std::string> names;
  for (const auto& [key, of] : pressed_) {
    // What moves on is gone from a place.
    const bool moves = of.to - of.from > 1e-6 * project_->beam.length().value();
    const bool comes_and_goes = moves || of.seen < instants_;
    const double range = std::max(of.most, comes_and_goes ? 0.0 : of.least) -
                         std::min(of.least, comes_and_goes ? 0.0 : of.most);
    if (!(range > hardly_changes.value())) continue;
    most = std::max(most, range);
    unsaid = unsaid || of.unsaid;
    if (names.empty() || names.back() != key.first) names.push_back(key.first);
  }
  if (!names.empty())
    found.push_back(
        {Criterion::patch_loading, fmt::format("webs under {}", fmt::join(names, ", ")),
         fmt::format("pressed anew by up to {:.3g} MPa at every cycle, not counted in fatigue (EN "
                     "1993-1-9, table 8.10){}",
                     1e-6 * most,
                     unsaid ? ": [[beam.load_introductions]] say how it comes in" : "")});
  return found;
}

}  // namespace boxbeam
