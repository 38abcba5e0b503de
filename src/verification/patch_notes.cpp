#include "patch_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "patched_path.hpp"

namespace boxbeam {
namespace {

const PatchedWeb* web_in(const Borne& way) {
  if (const auto* const web = std::get_if<PatchedWeb>(&way.basis.bears)) return web;
  const auto* const reduced = std::get_if<ReducedWeb>(&way.basis.bears);
  return reduced == nullptr ? nullptr : &reduced->web;
}

/// The flanges of a section with two webs, across what comes in.
struct Flanges {
  Length high, low, half_high, half_low;  ///< the webs: middles and half their thicknesses
  Length thickness;                       ///< of the weaker one
  Stress strength;

  Length apart() const { return high - low; }
  bool between(Length place) const { return place < high && place > low; }
  /// The faces of both webs, the nearer one; below zero above one.
  Length beside(Length place) const {
    return std::min(Length(abs(place - high) - half_high), Length(abs(place - low) - half_low));
  }

  void take(Length t, Stress f) {
    if (thickness > Length{} && t * t * f >= thickness * thickness * strength) return;
    thickness = t;
    strength = f;
  }
};

/// Nothing of sections without two webs.
std::optional<Flanges> flanges_across(const Patch& patch, const Borne& way) {
  Flanges of;
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
      of.take(walls.of(plate).thickness, walls.of(plate).yield_strength);
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
      of.take(web.bears.flange_thickness, web.bears.flange_strength);
  }
  return of;
}

/// The one of a force's places that is farther from the webs.
Length farthest_place(const Patch::Standing& of, const Flanges& flanges) {
  const auto& [one, other] = of.places;
  return flanges.beside(one) > flanges.beside(other) ? one : other;
}

/// How wide it stands on a diaphragm: a pad is as wide as it is long, of a load along the beam it
/// is not known.
Length pressed_across(const Patch& patch, const Flanges& flanges) {
  return (patch.is_line ? Length{} : patch.stiff_length) + 2.0 * flanges.thickness;
}

/// What of a patch stands between the webs of a section, or beside them.
Force between_webs(const Patch& patch, const Flanges& flanges) {
  Force between;
  for (const Patch::Standing& of : patch.standing)
    if (flanges.beside(farthest_place(of, flanges)) > flanges.thickness) between += abs(of.force);
  return between;
}

}  // namespace

PatchNotes::PatchNotes(const Project& project, std::vector<FlangeStep> steps,
                       const PressedWebs* counted)
    : project_(&project), counted_(counted), steps_(std::move(steps)), at_steps_(steps_.size()) {}

void PatchNotes::take_instant(const CutForceDiagram& diagram, const Situation& situation,
                              bool all) {
  if (all && has_cycles(*project_, situation)) ++instants_;
  const double load_factor = situation.load_factor;
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    for (const Side side : {Side::before, Side::behind}) {
      const CutForces cut = diagram.at({steps_[k].s, side});
      const double across = stress_of(steps_[k].across, cut);
      for (const PlateForce& along : steps_[k].along)
        at_steps_[k] = std::max(at_steps_[k], project_->strength.required * load_factor *
                                                  std::hypot(stress_of(along, cut), across));
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
    // No check of fatigue knows torques, those led on from beside it neither.
    const bool alone = !patch.together || patch.led_there || (patch.led_onto && patch.is_torque());
    if (alone && has_cycles(*project_, situation)) take_cycles(patch, ways, all);
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
void keep_most(auto& of, const std::string& name, const auto& value, Length s) {
  auto& [most, at] = of[name];
  if (value > most) std::tie(most, at) = std::pair(value, s);
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
  // All that turns off, of which this is half.
  const Force bears = 0.5 * depth * thickness * strength / (std::numbers::sqrt3 * demand.gamma_M0);
  keep_most(corners_, patch.name,
            demand.required * load_factor * (way.basis.share * way.basis.force / bears).value(),
            patch.s);
}

void PatchNotes::take_into(const Patch& patch, const Borne& way, IntoDiaphragm::Part part,
                           double use, double load_factor) {
  if (!project_->in_space || !way.basis.box) return;
  const std::vector<LoadIntroduction>& all = project_->beam.introductions;
  const bool flows = std::any_of(all.begin(), all.end(), [](const LoadIntroduction& of) {
    return of.torque_by == TorqueBy::flow;
  });
  // What flows in is nothing that a diaphragm keeps in shape.
  const Moment turns = load_factor * abs(patch.is_torque() ? patch.torque : patch.couple);
  IntoDiaphragm of{patch.diaphragm->s, part, patch.name, load_factor * use,
                   flows ? Moment{} : turns};
  IntoDiaphragm& most = into_[{patch.diaphragm, part, patch.name}];
  if (of.use > most.use || (of.use == most.use && of.turns < most.turns)) most = std::move(of);
}

void PatchNotes::take_welds(const Patch& patch, const Borne& way, const StiffenerWeld& weld,
                            double load_factor) {
  using enum IntoDiaphragm::Part;
  const Force acting = way.basis.share * way.basis.force;
  const double use = (acting / way.basis.resistance).value();
  take_into(patch, way, weld.to_flange ? flange_weld : web_weld, use, load_factor);
  if (!weld.to_flange || !way.basis.box) return;
  // The force goes on along the web, by no more than the worse one of both.
  StiffenerWeld along = weld;
  along.to_flange = false;
  along.length = way.basis.box->box().of(way.plate).clear();
  const double used = weld.beside > 0.0
                          ? use
                          : std::min(use, (acting / stiffener_weld_resistance_of(along)).value());
  take_into(patch, way, web_weld, used, load_factor);
}

std::vector<IntoDiaphragm> PatchNotes::into_diaphragms() const {
  std::vector<IntoDiaphragm> all;
  for (const auto& [key, of] : into_) all.push_back(of);
  return all;
}

void PatchNotes::take_plate_between(const Patch& patch, const Borne& way, double load_factor) {
  const auto* const weld = std::get_if<StiffenerWeld>(&way.basis.bears);
  if (weld == nullptr || weld->to_flange || !way.basis.box) return;
  const PlateOf plate =
      first_to_yield(plates_around(*project_, patch.s, patch.diaphragm->thickness));
  const auto strength = yield_strength_of(*plate.material, plate.thickness);
  if (!strength) return;
  ShearPanel panel;
  panel.depth = weld->length;
  panel.thickness = patch.diaphragm->thickness;
  panel.yield_strength = *strength;
  panel.length =
      way.basis.box->box().of(patch.along_z ? BoxPlate::top_flange : BoxPlate::left_web).clear();
  const Length left = std::max(Length{}, Length(panel.depth - patch.diaphragm->opening));
  const Force bears =
      (left / panel.depth) * shear_resistance_of(panel, project_->strength.gamma_M1).resistance;
  const double use = (way.basis.share * way.basis.force / bears).value();
  take_into(patch, way, IntoDiaphragm::Part::plate, use, load_factor);
  keep_most(sheared_, patch.name, project_->strength.required * load_factor * use, patch.s);
}

void PatchNotes::take_diaphragm(const Patch& patch, const Borne& way, double load_factor) {
  // What turns off from a flange goes by the plate from all of its width to the webs.
  if (patch.kink != nullptr || patch.through) take_plate_between(patch, way, load_factor);
  if (!project_->in_space) return;
  if (const auto* const weld = std::get_if<StiffenerWeld>(&way.basis.bears)) {
    if (way.part == Borne::Part::weld) take_welds(patch, way, *weld, load_factor);
    const auto flanges = flanges_across(patch, way);
    if (!flanges || !weld->to_flange || way.part != Borne::Part::weld) return;
    const Force between = between_webs(patch, *flanges);
    const Length pressed = pressed_across(patch, *flanges);
    const Force edge = way.basis.resistance * (pressed / (weld->length - 2.0 * weld->throat));
    keep_most(edges_, patch.name,
              project_->strength.required * load_factor * (between / edge).value(), patch.s);
    return;
  }
  const auto* const stiffener = std::get_if<BearingStiffener>(&way.basis.bears);
  if (stiffener == nullptr) return;
  const auto flanges = flanges_across(patch, way);
  if (!flanges) return;
  // What stands between the webs goes to them by its plate, and so does half of a torque.
  const Force between = between_webs(patch, *flanges);
  Force sheared;
  for (const Patch::Standing& of : patch.standing) {
    const Length place = farthest_place(of, *flanges);
    if (!(flanges->beside(place) > flanges->thickness)) continue;
    // What stands beyond a web is a torque besides, of which half goes by the plate.
    const Length at = std::clamp(place, flanges->low, flanges->high);
    const double by_high = (at - flanges->low) / flanges->apart();
    sheared += (std::max(by_high, 1.0 - by_high) + 0.5 * abs(place - at) / flanges->apart()) *
               abs(of.force);
  }
  sheared += 0.5 * abs(patch.turns) / flanges->apart();
  if (patch.is_torque()) sheared = 0.5 * abs(patch.force);
  if (!(sheared > Force{})) return;
  // Beside an access hole, taken as deep as it is wide.
  ShearPanel panel;
  panel.depth = stiffener->web_depth;
  panel.thickness = stiffener->thickness;
  panel.yield_strength = stiffener->yield_strength;
  panel.length = flanges->apart() - flanges->half_high - flanges->half_low;
  const Length opening = patch.diaphragm->opening;
  const Length left = std::max(Length{}, Length(panel.depth - opening));
  const double scale = project_->strength.required * load_factor;
  const Force bears =
      (left / panel.depth) * shear_resistance_of(panel, project_->strength.gamma_M1).resistance;
  keep_most(sheared_, patch.name, scale * (sheared / bears).value(), patch.s);
  take_into(patch, way, IntoDiaphragm::Part::plate, (sheared / bears).value(), load_factor);
  const Length pressed = pressed_across(patch, *flanges);
  const Force edge = pressed * stiffener->thickness * stiffener->yield_strength;
  keep_most(edges_, patch.name, scale * (between / edge).value(), patch.s);
  // Half of what is left bridges the hole, with plastic hinges at its ends and in the middle.
  const Length strip = 0.5 * left;
  const Moment plastic = 0.25 * strip * strip * stiffener->thickness * stiffener->yield_strength;
  if (opening > Length{})
    keep_most(bridged_, patch.name, scale * (between * opening / 8.0 / plastic).value(), patch.s);
}

void PatchNotes::take_flange(const Patch& patch, const Borne& way, double load_factor, bool again) {
  BentFlange of{patch.s, {}, patch.bent};
  of.kinked = patch.bent > 0.0;
  of.along_z = patch.along_z;
  const auto flanges = project_->in_space && !patch.standing.empty() ? flanges_across(patch, way)
                                                                     : std::optional<Flanges>{};
  // Farther apart along the beam than the flange is wide each bends a width of its own.
  if (flanges && (!patch.together || patch.stiff_length <= flanges->apart())) {
    const double t_f = flanges->thickness.value();
    double m = 0.0;
    for (const Patch::Standing& at : patch.standing) {
      const Length place = farthest_place(at, *flanges);
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
  keep(patch.name, of);
}

void PatchNotes::PressedWeb::take(double stress, std::size_t instant) {
  if (at_ != instant) {
    *this = whole();
    at_ = instant;
    now_ = stress;
    ++seen;
  } else if (std::abs(stress) > std::abs(now_)) {
    now_ = stress;
  }
}

PatchNotes::PressedWeb PatchNotes::PressedWeb::whole() const {
  PressedWeb of = *this;
  if (seen == 0) return of;
  of.least = std::min(of.least, now_);
  of.most = std::max(of.most, now_);
  return of;
}

void PatchNotes::take_cycles(const Patch& patch, const std::vector<Borne>& ways, bool all) {
  if (!project_->fatigue.asked) return;
  // A torque stands for either of its two senses once.
  if (patch.is_torque() && !(patch.force > Force{})) return;
  double in_web = 0.0, in_weld = 0.0;
  for (const Borne& way : ways) {
    const double force = (way.basis.share * way.basis.force).value();
    const bool counted =
        counted_ != nullptr && way.basis.box && PressedWebs::counts(patch) && !patch.led_there;
    const auto* const weld = std::get_if<StiffenerWeld>(&way.basis.bears);
    if (weld != nullptr && !(counted && way.part == Borne::Part::weld)) {
      // Where nothing is said of them as thick together as the diaphragm.
      const Length throat = way.part == Borne::Part::unsaid_weld
                                ? Length(0.5 * patch.diaphragm->thickness)
                                : weld->throat;
      in_weld = std::max(
          in_weld, force / (static_cast<double>(weld->welds) * throat * weld->length).value());
    }
    const PatchedWeb* const web = web_in(way);
    if (web == nullptr) continue;
    if (counted) continue;
    in_web = std::max(in_web, force / (web->thickness * loaded_length_of(*web)).value());
  }
  // From above or from below: what pushes and what pulls.
  const double of_what = patch.is_torque() ? patch.torque.value() : patch.force.value();
  const double sense = of_what > 0.0 ? 1.0 : -1.0, s = patch.s.value();
  const auto add = [&](double stress, PressedWeb& of) {
    of.unsaid = of.unsaid || !patch.given;
    if (all)
      of.take(stress, instants_);
    else if (stress > 0.0)
      of.most = std::max(of.most, stress);
    else
      of.least = std::min(of.least, stress);
    of.from = std::min(of.from, s);
    of.to = std::max(of.to, s);
  };
  if (patch.diaphragm == nullptr) add(sense * in_web, pressed_[{patch.name, patch.along_z}]);
  // A wheel leads its force to a diaphragm that it passes and is gone.
  if (in_weld > 0.0) add(sense * in_weld, welded_[{patch.name, patch.along_z}]);
}

PatchNotes::Anew PatchNotes::anew_of(const PressedByName& all) const {
  Anew found;
  for (const auto& [key, known] : all) {
    const PressedWeb of = known.whole();
    // What moves on is gone from a place.
    const bool moves = of.to - of.from > 1e-6 * project_->beam.length().value();
    const bool comes_and_goes = moves || of.seen < instants_;
    const double range = std::max(of.most, comes_and_goes ? 0.0 : of.least) -
                         std::min(of.least, comes_and_goes ? 0.0 : of.most);
    if (!(range > hardly_changes.value())) continue;
    found.most = std::max(found.most, range);
    found.unsaid = found.unsaid || of.unsaid;
    if (found.names.empty() || found.names.back() != key.first) found.names.push_back(key.first);
  }
  return found;
}

void PatchNotes::take_couple(const std::string& name, Length s, Moment couple) {
  keep_most(couples_, name, couple, s);
}

void PatchNotes::take_led_on(const std::string& name, Length s, Moment moment) {
  keep_most(led_on_, name, moment, s);
}

void PatchNotes::take_bare_support(Length s, bool along_z) {
  (along_z ? bare_ : bare_along_y_).insert(to_text(Station{s, Side::both}));
}

std::string PatchNotes::words_of(const BentFlange& of) {
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

std::vector<Gate> PatchNotes::gates() const {
  std::vector<Gate> found;
  const auto add = [&](Length s, std::string why) {
    const std::size_t segment = segment_at(project_->beam, {s, Side::both});
    found.push_back({project_->beam.segments[segment].name, "", std::move(why), true});
  };
  const auto add_used = [&](const UseByName& uses, const auto& why) {
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
        "diaphragm at s = {} m: what \"{}\" puts between its webs uses its plate in shear by "
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
    // Of a web a half of it is enough, as in bending.
    const Area area = of.web ? Area(0.5 * of.area) : of.area;
    if (!(at_steps_[k] > hardly_bent * (area * of.yield_strength).value()) ||
        at_steps_[k] <= of.led.value())
      continue;
    std::size_t& at = most.try_emplace({of.s, of.name}, k).first->second;
    if (at_steps_[k] > at_steps_[at]) at = k;
  }
  for (const auto& [key, k] : most) {
    const FlangeStep& of = steps_[k];
    add(of.s,
        fmt::format(
            "{} at s = {} m: it ends where {}; how its force, {:.4g} kN, is led on is not "
            "judged: a taper between both leads it{}",
            of.name, to_text(Station{of.s, Side::both}),
            of.by ? fmt::format("the next one lies {:.3g} mm away", 1e3 * of.by->value())
                  : "none goes on",
            1e-3 * at_steps_[k],
            of.web ? of.led > Force{} ? ", or a thicker diaphragm" : ", or a diaphragm" : ""));
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
  const auto worst = [](const UseByName& of) -> std::optional<UseByName::value_type> {
    const auto most = std::max_element(of.begin(), of.end(), [](const auto& a, const auto& b) {
      return a.second.first < b.second.first;
    });
    return most == of.end() ? std::nullopt : std::optional<UseByName::value_type>(*most);
  };
  const auto edge = worst(edges_);
  if (edge && edge->second.first > 1.0)
    found.push_back(
        {Criterion::patch_loading,
         fmt::format("edge of the diaphragm at s = {} m",
                     to_text(Station{edge->second.second, Side::both})),
         fmt::format("\"{}\" presses it by {:.3g} of its strength, or of its weld's, over 2 t_f "
                     "and as much as "
                     "[[beam.load_introductions]] say its pad is long: a longer one, or a thicker "
                     "diaphragm",
                     edge->first, edge->second.first)});
  if (const Anew of = anew_of(pressed_); !of.names.empty())
    found.push_back(
        {Criterion::patch_loading, fmt::format("webs under {}", fmt::join(of.names, ", ")),
         fmt::format("pressed anew by up to {:.3g} MPa at every cycle, not counted in fatigue (EN "
                     "1993-1-9, table 8.10){}",
                     1e-6 * of.most,
                     of.unsaid ? ": [[beam.load_introductions]] say how it comes in" : "")});
  if (const Anew of = anew_of(welded_); !of.names.empty())
    found.push_back({Criterion::weld,
                     fmt::format("welds of diaphragms under {}", fmt::join(of.names, ", ")),
                     fmt::format("stressed anew by up to {:.3g} MPa at every cycle, not counted in "
                                 "fatigue (EN 1993-1-9, table 8.5, row 3)",
                                 1e-6 * of.most)});
  const auto bridge = worst(bridged_);
  if (bridge && bridge->second.first > 1.0)
    found.push_back(
        {Criterion::patch_loading,
         fmt::format("diaphragm at s = {} m", to_text(Station{bridge->second.second, Side::both})),
         fmt::format("how its strip beside the access hole bridges it under \"{}\", by "
                     "about {:.2g} of its strength, is not checked",
                     bridge->first, bridge->second.first)});
  const auto say = [&](const MomentByName& moments, const char* what, const char* how) {
    if (moments.empty()) return;
    const auto most = std::max_element(
        moments.begin(), moments.end(),
        [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
    found.push_back({Criterion::patch_loading,
                     fmt::format("{} {} at s = {} m", what, most->first,
                                 to_text(Station{most->second.second, Side::both})),
                     fmt::format("its moment, {:.4g} kN m,{} is not judged as forces",
                                 1e-3 * most->second.first.value(), how)});
  };
  say(couples_, "webs under", "");
  say(led_on_, "plates at",
      " comes by plates of another body, which may not lie in line with the beam's, and");
  for (const bool webs : {true, false}) {
    const std::set<std::string>& bare = webs ? bare_ : bare_along_y_;
    if (bare.empty()) continue;
    found.push_back(
        {Criterion::shear_buckling,
         fmt::format("{} at s = {} m", webs ? "webs" : "plates along y", fmt::join(bare, ", ")),
         "no diaphragm where they are held, which their resistance in shear takes for "
         "granted (EN 1993-1-5, 5.1(2))"});
  }
  return found;
}

}  // namespace boxbeam
