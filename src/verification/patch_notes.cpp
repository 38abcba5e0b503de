#include "patch_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "section_gate.hpp"

namespace boxbeam {

PatchNotes::PatchNotes(const Project& project, std::vector<FlangeStep> steps, bool counted)
    : project_(&project),
      steps_(std::move(steps)),
      at_steps_(steps_.size()),
      flanges_(project),
      diaphragms_(project),
      pressed_(project, counted) {}

void PatchNotes::take_instant(const CutForceDiagram& diagram, const Situation& situation,
                              bool all) {
  if (all && has_cycles(*project_, situation)) pressed_.begin_instant();
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
    for (const Borne& way : ways) diaphragms_.take(patch, way, situation.load_factor);
    // No check of fatigue knows torques, those led on from beside it neither.
    const bool alone = !patch.together || patch.led_there || (patch.led_onto && patch.is_torque());
    if (alone && has_cycles(*project_, situation)) pressed_.take(patch, ways, all);
    return;
  }
  const bool again = project_->fatigue.asked && has_cycles(*project_, situation);
  for (const Borne& way : ways) {
    if (web_in(way) != nullptr) flanges_.take(patch, way, situation.load_factor, again);
  }
  if (patch.together) return;
  if (has_cycles(*project_, situation)) pressed_.take(patch, ways, all);
}

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
  corners_.take(patch.name,
                demand.required * load_factor * (way.basis.share * way.basis.force / bears).value(),
                patch.s);
}

void PatchNotes::take_couple(const std::string& name, Length s, Moment couple) {
  couples_.take(name, couple, s);
}

void PatchNotes::take_led_on(const std::string& name, Length s, Moment moment) {
  led_on_.take(name, moment, s);
}

void PatchNotes::take_bare_support(Length s, bool along_z) {
  (along_z ? bare_ : bare_along_y_).insert(to_text(Station{s, Side::both}));
}

std::vector<Gate> PatchNotes::gates() const {
  std::vector<Gate> found;
  const auto add = [&](Length s, std::string why) {
    found.push_back(section_gate_at(*project_, {s, Side::both}, std::move(why)));
  };
  const auto add_used = [&](const UseByName& uses, const auto& why) {
    for (const auto& [name, of] : uses) {
      const auto& [use, s] = of;
      if (use > 1.0) add(s, why(name, to_text(Station{s, Side::both}), use));
    }
  };
  flanges_.add_gates(add);
  add_used(diaphragms_.sheared(), [](const std::string& name, const std::string& s, double use) {
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
  std::vector<NotJudged> found;
  flanges_.add_to(found);
  diaphragms_.add_edges_to(found);
  pressed_.add_to(found);
  diaphragms_.add_bridges_to(found);
  const auto say = [&](const MostByName<Moment>& moments, const char* what, const char* how) {
    const auto* const most = moments.largest();
    if (most == nullptr) return;
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
