#include "loaded_diaphragms.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bent_flanges.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/shear_buckling.hpp"

namespace boxbeam {
namespace {

/// How wide it stands on a diaphragm: a pad is as wide as it is long, of a load along the beam it
/// is not known.
Length pressed_across(const Patch& patch, const Flanges& flanges) {
  return (patch.is_line ? Length{} : patch.stiff_length) + 2.0 * flanges.thickness;
}

/// What of a patch stands between the webs of a section, or beside them.
Force between_webs(const Patch& patch, const Flanges& flanges) {
  Force between;
  for (const Patch::Standing& of : patch.standing)
    if (flanges.beside(flanges.farthest_place(of)) > flanges.thickness) between += abs(of.force);
  return between;
}

/// What of a panel's depth an access hole leaves, taken as deep as it is wide.
Length left_of(const ShearPanel& panel, const Diaphragm& diaphragm) {
  return std::max(Length{}, Length(panel.depth - diaphragm.opening));
}

/// What a plate bears in shear beside its access hole.
Force bears_in_shear(const ShearPanel& panel, const Diaphragm& diaphragm, double gamma_M1) {
  return (left_of(panel, diaphragm) / panel.depth) *
         shear_resistance_of(panel, gamma_M1).resistance;
}

}  // namespace

void LoadedDiaphragms::take_into(const Patch& patch, const Borne& way, IntoDiaphragm::Part part,
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

void LoadedDiaphragms::take_welds(const Patch& patch, const Borne& way, const StiffenerWeld& weld,
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

std::vector<IntoDiaphragm> LoadedDiaphragms::into() const {
  std::vector<IntoDiaphragm> all;
  for (const auto& [key, of] : into_) all.push_back(of);
  return all;
}

void LoadedDiaphragms::take_plate_between(const Patch& patch, const Borne& way,
                                          double load_factor) {
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
  const Force bears = bears_in_shear(panel, *patch.diaphragm, project_->strength.gamma_M1);
  const double use = (way.basis.share * way.basis.force / bears).value();
  take_into(patch, way, IntoDiaphragm::Part::plate, use, load_factor);
  sheared_.take(patch.name, project_->strength.required * load_factor * use, patch.s);
}

void LoadedDiaphragms::take(const Patch& patch, const Borne& way, double load_factor) {
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
    edges_.take(patch.name, project_->strength.required * load_factor * (between / edge).value(),
                patch.s);
    return;
  }
  if (const auto* const stiffener = std::get_if<BearingStiffener>(&way.basis.bears))
    take_plate_under(patch, way, *stiffener, load_factor);
}

void LoadedDiaphragms::take_plate_under(const Patch& patch, const Borne& way,
                                        const BearingStiffener& stiffener, double load_factor) {
  const auto flanges = flanges_across(patch, way);
  if (!flanges) return;
  // What stands between the webs goes to them by its plate, and so does half of a torque.
  const Force between = between_webs(patch, *flanges);
  Force sheared;
  for (const Patch::Standing& of : patch.standing) {
    const Length place = flanges->farthest_place(of);
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
  ShearPanel panel;
  panel.depth = stiffener.web_depth;
  panel.thickness = stiffener.thickness;
  panel.yield_strength = stiffener.yield_strength;
  panel.length = flanges->apart() - flanges->half_high - flanges->half_low;
  const Length opening = patch.diaphragm->opening;
  const double scale = project_->strength.required * load_factor;
  const Force bears = bears_in_shear(panel, *patch.diaphragm, project_->strength.gamma_M1);
  sheared_.take(patch.name, scale * (sheared / bears).value(), patch.s);
  take_into(patch, way, IntoDiaphragm::Part::plate, (sheared / bears).value(), load_factor);
  const Length pressed = pressed_across(patch, *flanges);
  const Force edge = pressed * stiffener.thickness * stiffener.yield_strength;
  edges_.take(patch.name, scale * (between / edge).value(), patch.s);
  // Half of what is left bridges the hole, with plastic hinges at its ends and in the middle.
  const Length strip = 0.5 * left_of(panel, *patch.diaphragm);
  const Moment plastic = 0.25 * strip * strip * stiffener.thickness * stiffener.yield_strength;
  if (opening > Length{})
    bridged_.take(patch.name, scale * (between * opening / 8.0 / plastic).value(), patch.s);
}

void LoadedDiaphragms::add_edges_to(std::vector<NotJudged>& found) const {
  const auto* const edge = edges_.largest();
  if (edge != nullptr && edge->second.first > 1.0)
    found.push_back(
        {Criterion::patch_loading,
         fmt::format("edge of the diaphragm at s = {} m",
                     to_text(Station{edge->second.second, Side::both})),
         fmt::format("\"{}\" presses it by {:.3g} of its strength, or of its weld's, over 2 t_f "
                     "and as much as "
                     "[[beam.load_introductions]] say its pad is long: a longer one, or a thicker "
                     "diaphragm",
                     edge->first, edge->second.first)});
}

void LoadedDiaphragms::add_bridges_to(std::vector<NotJudged>& found) const {
  const auto* const bridge = bridged_.largest();
  if (bridge != nullptr && bridge->second.first > 1.0)
    found.push_back(
        {Criterion::patch_loading,
         fmt::format("diaphragm at s = {} m", to_text(Station{bridge->second.second, Side::both})),
         fmt::format("how its strip beside the access hole bridges it under \"{}\", by "
                     "about {:.2g} of its strength, is not checked",
                     bridge->first, bridge->second.first)});
}

}  // namespace boxbeam
