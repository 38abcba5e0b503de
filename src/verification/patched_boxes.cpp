#include <algorithm>
#include <limits>

#include "patch_search.hpp"

/// How the webs of a box bear what comes in.
namespace boxbeam {

bool bears_less(const PatchedWeb& one, const PatchedWeb& other) {
  return one.flange_thickness < other.flange_thickness ||
         one.flange_strength < other.flange_strength || one.flange_inside < other.flange_inside ||
         one.flange_outside < other.flange_outside;
}

PatchSearch::Shared PatchSearch::shared_by_webs(const Patch& patch, const FourWalls& walls) {
  Shared of{webs_along(patch.along_z), {}};
  if (patch.is_none()) return of;
  if (patch.is_torque()) {
    of.shares = {1.0, -1.0};
    return of;
  }
  const Length high = walls.of(of.webs[0]).middle, low = walls.of(of.webs[1]).middle;
  const double by_first = ((patch.stands_at() - low) / (high - low)).value();
  of.shares = {by_first, 1.0 - by_first};
  return of;
}

std::vector<Borne> PatchSearch::ways_at(const Patch& patch, const PatchBasis& start,
                                        const Station& station, const JudgedSection& judged,
                                        const CutForceDiagram& diagram) {
  const FourWalls& walls = judged.box->box();
  const auto [webs, shares] = shared_by_webs(patch, walls);
  Borne of;
  PatchBasis& basis = of.basis = start;
  std::vector<Borne> ways;
  // Of the ways without a diaphragm the one that is used most.
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&] {
    const double factor = factor_of(basis);
    if (!ways.empty() && !(factor < least)) return;
    least = factor;
    ways.assign(1, of);
  };
  for (const std::size_t k : {0U, 1U}) {
    basis.share = std::abs(shares[k]);
    of.plate = webs[k];
    if (patch.diaphragm != nullptr) {
      const BoxWall& across =
          walls.of(is_flange(webs[k]) ? BoxPlate::left_web : BoxPlate::top_flange);
      const BearingStiffener stiffener =
          stiffener_of(*project_, web_of(judged, webs[k], flanges_of(patch).front(), patch),
                       across.clear(), *patch.diaphragm, station);
      bear_by_stiffener(patch, stiffener, thinner_flange(walls, patch), to_text(webs[k]), diagram,
                        of, ways);
      continue;
    }
    const PatchedWeb by_flange = web_of(judged, webs[k], flanges_of(patch).front(), patch);
    for (const PatchedWeb& web : in_every_way(by_flange, patch)) {
      const auto plate = reduced_plate_of(judged, webs[k]);
      if (plate != nullptr && basis.share > 0.0)
        bear_by_reduced_stresses(plate, web, patch.force.value() < 0.0, basis);
      else
        bear_by_effective_widths(web, basis);
      look();
    }
    if (!patch.hangs.value_or(false)) continue;
    PatchedWeb hung = web_of(judged, webs[k], flanges_of(patch).back(), patch);
    if (!bears_less(hung, by_flange)) continue;
    hung.pulled = true;
    for (const PatchedWeb& web : in_every_way(hung, patch)) {
      bear_by_effective_widths(web, basis);
      look();
    }
  }
  return ways;
}

std::shared_ptr<const ReducedPlate> PatchSearch::reduced_plate_of(const JudgedSection& judged,
                                                                  BoxPlate plate) {
  std::shared_ptr<const ReducedPlate> alike;
  for (const auto& of : judged.reduced) {
    if (of->sheared.plate == plate) return of;
    if (is_flange(of->sheared.plate) == is_flange(plate)) alike = of;
  }
  return alike;
}

void PatchSearch::bear_by_effective_widths(const PatchedWeb& web, PatchBasis& basis) const {
  basis.resistance = patch_resistance_of(web, project_->strength.gamma_M1).resistance;
  basis.bears = web;
}

void PatchSearch::bear_by_reduced_stresses(const std::shared_ptr<const ReducedPlate>& plate,
                                           PatchedWeb web, bool onto_high,
                                           PatchBasis& basis) const {
  web.depth = plate->panel.depth;
  const Force acting = basis.share * basis.force;
  const double gamma_M1 = project_->strength.gamma_M1;
  PanelStress stress = plate->under(basis.cut);
  const auto [low, high] = plate->edges_under(basis.cut);
  const Stress loaded = onto_high ? high : low;
  const bool through = web.entry == ForceEntry::both_flanges;
  stress.across = {acting / (web.thickness * loaded_length_of(web)),
                   patch_resistance_of(web, gamma_M1).F_cr / acting,
                   {loaded, through ? (onto_high ? low : high) : loaded}};
  basis.resistance = acting / reduced_stress_of(plate->panel, stress, gamma_M1).use;
  basis.bears = ReducedWeb{web, plate, onto_high, stress};
}

PatchedWeb web_onto(const FourWalls& walls, BoxPlate wall, BoxPlate onto) {
  const BoxWall& of = walls.of(wall);
  const BoxWall& flange = walls.of(onto);
  PatchedWeb web;
  web.depth = of.clear();
  web.thickness = of.thickness;
  web.yield_strength = of.yield_strength;
  web.flange_thickness = flange.thickness;
  web.flange_inside = 0.5 * flange.clear();
  web.flange_strength = flange.yield_strength;
  return web;
}

PatchedWeb PatchSearch::web_of(const JudgedSection& judged, BoxPlate plate, BoxPlate by,
                               const Patch& patch) {
  PatchedWeb web = web_onto(judged.box->box(), plate, by);
  web.length = judged.panels[static_cast<std::size_t>(plate)];
  return web_under(web, patch);
}

PatchedWeb PatchSearch::web_under(PatchedWeb web, const Patch& patch) {
  web.stiff_length = patch.stiff_length;
  web.entry = patch.opposed ? ForceEntry::both_flanges : ForceEntry::one_flange;
  return web;
}

std::vector<PatchedWeb> PatchSearch::in_every_way(PatchedWeb web, const Patch& patch) const {
  // What would stand beyond a free end stands nowhere.
  const Length half = 0.5 * web.stiff_length, end = project_->beam.length();
  Length from = patch.s - half, to = patch.s + half;
  if (diaphragm_at(Length{}) == nullptr) from = std::max(Length{}, from);
  if (diaphragm_at(end) == nullptr) to = std::min(end, to);
  web.stiff_length = std::max(Length{}, Length(to - from));
  std::vector<PatchedWeb> ways;
  ways.reserve(2);
  ways.push_back(web);
  if (const auto to_end = distance_to_end(patch)) {
    // From 2/3 h_w on k_F is that of a force far from the end; a long bearing at the end has its
    // one hinge all the same.
    if (*to_end < 2.0 / 3.0 * web.depth) {
      web.entry = ForceEntry::near_end;
      web.length.reset();
      web.to_end = *to_end;
      ways.push_back(web);
    }
  }
  return ways;
}

std::optional<Length> PatchSearch::distance_to_end(const Patch& patch) const {
  const TaperedBeam& beam = project_->beam;
  const auto kept_off = [&](Length from, Length to) {
    return std::any_of(beam.diaphragms.begin(), beam.diaphragms.end(), [&](const Diaphragm& of) {
      return of.s >= from && of.s <= to && holds(of, patch.along_z);
    });
  };
  std::optional<Length> nearest;
  const auto look = [&](Length distance) {
    const Length c = std::max(Length{}, Length(distance - 0.5 * patch.stiff_length));
    if (!nearest || c < *nearest) nearest = c;
  };
  if (!kept_off(Length{}, patch.s)) look(patch.s);
  if (!kept_off(patch.s, beam.length())) look(beam.length() - patch.s);
  return nearest;
}

}  // namespace boxbeam
