#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "patch_search.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {

namespace {

/// The same of two webs of a path, with a plate from the one to the other; beside a single web of a
/// stout path flats that do not twist. Beside a slender one they are judged by
/// `bearing_obstacle_of`.
bool is_firm_in_path(const Project& project, const Diaphragm& of, bool along_z,
                     const Station& station) {
  const auto path = judged_path_at(project, {}, station);
  if (!path) return true;
  const PathWebs all = webs_of_path(*path, along_z, true);
  const std::vector<PathWeb>& webs = all.webs;
  if (webs.size() == 1 && all.obstacle.empty() && !is_slender_path_at(project, station))
    return flats_obstacle(flats_beside(project, webs.front(), of, station)).empty();
  if (webs.size() != 2) return true;
  return std::all_of(webs.begin(), webs.end(), [&](const PathWeb& web) {
    return across_obstacle(stiffener_of(project, web.bears, all.inside(), of, station), of,
                           2.0 * web.bears.depth)
        .empty();
  });
}

/// Where the middles of both webs along a force lie across it; both at 0 of a path with one.
std::array<Length, 2> middles_of_webs(const PatchBasis& basis, bool along_z, bool onto_high) {
  if (basis.box) {
    const FourWalls& walls = basis.box->box();
    const std::array webs = webs_along(along_z);
    return {walls.of(webs[0]).middle, walls.of(webs[1]).middle};
  }
  if (!basis.path) return {};
  const std::vector<PathWeb> webs = webs_of_path(basis.path->path(), along_z, onto_high).webs;
  if (webs.size() != 2) return {};
  return {webs.front().place, webs.back().place};
}

}  // namespace

bool is_firm(const Project& project, const Diaphragm& of, bool along_z) {
  const std::array webs = webs_along(along_z);
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? of.s == Length{} : of.s == project.beam.length()) continue;
    const Station station{of.s, side};
    const auto walls = judged_walls_at(project, station);
    if (!walls) {
      if (!is_firm_in_path(project, of, along_z, station)) return false;
      continue;
    }
    const bool firm = std::all_of(webs.begin(), webs.end(), [&](BoxPlate web) {
      const auto stiffener = bounding_stiffener_at(project, station, *walls, web);
      return stiffener && across_obstacle(*stiffener, of, 2.0 * walls->of(web).clear()).empty();
    });
    if (!firm) return false;
  }
  return true;
}

void PatchSearch::add_bare_diaphragms(std::vector<Patch>& patches) {
  const std::size_t loaded = patches.size();
  for (const Diaphragm& of : project_->beam.diaphragms) {
    if (is_at_end(of.s) || pulling_.beside(of.s).empty()) continue;
    for (const bool along_z : {true, false}) {
      const auto taken = [&](const Patch& patch) {
        return patch.diaphragm == &of && patch.along_z == along_z;
      };
      const auto last = patches.begin() + static_cast<std::ptrdiff_t>(loaded);
      if (std::any_of(patches.begin(), last, taken)) continue;
      Patch& bare = patches.emplace_back();
      bare.name = "the shear of its panels";
      bare.s = of.s;
      bare.along_z = along_z;
      bare.diaphragm = &of;
    }
  }
}

void PatchSearch::bear_by_stiffener(const Patch& patch, const BearingStiffener& stiffener,
                                    Length flange, const std::string& plate,
                                    const CutForceDiagram& diagram, Borne borne,
                                    std::vector<Borne>& ways) {
  PatchBasis& basis = borne.basis;
  basis.resistance = bearing_resistance_of(stiffener, project_->strength.gamma_M1);
  basis.bears = stiffener;
  if (basis.share * basis.force > Force{}) {
    if (!patch.through) ways.push_back(borne);
    bear_by_welds(patch, stiffener, flange, borne, ways);
  }
  if (patch.through) return;
  // At the ends of the beam it is no stiffener between panels.
  if (is_at_end(patch.diaphragm->s)) return;
  for (const PullingPanels::Panel& of : pulling_.beside(patch.diaphragm->s)) {
    if (of.wall.name != plate) continue;
    const Force shear = of.wall.force_of(diagram.at(of.at));
    if (!(shear > Force{})) continue;
    basis.pulls = PullingPanel{of.at, of.wall.panel, shear};
    ways.push_back(borne);
  }
}

Length PatchSearch::weld_under_several(const Patch& patch, const BearingStiffener& by, double share,
                                       Length flange, const std::array<Length, 2>& webs) const {
  // Per length as much as where most of those between the webs lie above each other.
  const Length pressed = patch.stiff_length + 2.0 * flange;
  const auto between = [&](Length at) {
    return std::min(webs[0] - at, at - webs[1]) > flange + by.web_thickness;
  };
  Force most;
  for (const Patch::Standing& of : patch.standing) {
    Force here;
    for (const Patch::Standing& other : patch.standing) {
      const Length away = other.places[1] - of.places[1];
      if (between(other.places[1]) && away >= Length{} && away < pressed) here += abs(other.force);
    }
    most = std::max(most, here);
  }
  if (!(most > Force{})) return by.width;
  const Length throat = std::max(patch.diaphragm->throat, least_throat());
  return std::min(by.width, Length(share * abs(patch.force) / most * pressed + 2.0 * throat));
}

Length PatchSearch::weld_under(const Patch& patch, const BearingStiffener& by, double share,
                               Length flange, const std::array<Length, 2>& webs) const {
  // Of what the case does not say how it comes in the verdict line says what an edge would do.
  if (!project_->in_space || patch.is_none() || patch.is_torque() || patch.is_line ||
      !(patch.stiff_length > Length{}))
    return by.width;
  if (patch.together && !patch.led_onto) return weld_under_several(patch, by, share, flange, webs);
  // The nearer web, by both shares.
  const Length apart = 2.0 * by.width + patch.diaphragm->opening;
  if (!(std::min(share, 1.0 - share) * apart > flange + by.web_thickness)) return by.width;
  const Length throat = std::max(patch.diaphragm->throat, least_throat());
  return std::min(by.width, share * (patch.stiff_length + 2.0 * flange) + 2.0 * throat);
}

void PatchSearch::bear_by_welds(const Patch& patch, const BearingStiffener& stiffener,
                                Length flange, Borne borne, std::vector<Borne>& ways) const {
  const Diaphragm& of = *patch.diaphragm;
  const PlateOf joined = weakest_to_weld(plates_around(*project_, of.s, of.thickness));
  const auto tensile = tensile_strength_of(*joined.material, joined.thickness);
  if (!tensile) return;
  const bool said = of.throat > Length{};
  borne.part = said ? Borne::Part::weld : Borne::Part::unsaid_weld;
  const Length under =
      weld_under(patch, stiffener, borne.basis.share, flange,
                 middles_of_webs(borne.basis, patch.along_z, patch.force < Force{}));
  for (const bool to_flange : {false, true}) {
    if (to_flange && patch.through) continue;  // each flange by its own
    StiffenerWeld weld{to_flange,
                       stiffener.both_sides ? 4 : 2,
                       said ? of.throat : least_throat(),
                       to_flange ? under : stiffener.web_depth,
                       {*tensile, joined.material->beta_w, project_->strength.gamma_M2}};
    if (patch.square_to_it > Force{}) {
      // By the other edge of the diaphragm's part into this one.
      StiffenerWeld other = weld;
      other.to_flange = !to_flange;
      other.length = std::max(Length(2.0 * weld.throat + si<Length>(1e-3)),
                              to_flange ? Length(2.0 * stiffener.width)
                                        : Length(0.5 * (stiffener.web_depth - of.opening)));
      const Force acting = borne.basis.share * borne.basis.force;
      weld.beside = (patch.square_to_it / stiffener_weld_resistance_of(other) *
                     (stiffener_weld_resistance_of(weld) / acting))
                        .value();
    }
    borne.basis.resistance = stiffener_weld_resistance_of(weld);
    borne.basis.bears = weld;
    ways.push_back(borne);
  }
}

std::vector<PressedWeb> PatchSearch::welds_stressed_by(const Patch& patch) {
  std::vector<PressedWeb> stressed;
  for (const Diaphragm& of : project_->beam.diaphragms) {
    const Length near = 0.5 * patch.stiff_length + of.thickness;
    const bool there = abs(of.s - patch.s) <= near;
    if (!(of.throat > Length{}) || !(there || patch.moves) || !holds(of, patch.along_z)) continue;
    std::array<std::array<std::optional<PressedWeb>, 2>, 2> worst;  // of webs, of their welds
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? of.s == Length{} : of.s == project_->beam.length()) continue;
      const Station station{of.s, side};
      const JudgedSection& judged = judged_at(station);
      if (!judged.box) continue;
      const FourWalls& walls = judged.box->box();
      const auto [webs, shares] = shared_by_webs(patch, walls);
      for (const std::size_t k : {0U, 1U}) {
        const BoxWall& across =
            walls.of(is_flange(webs[k]) ? BoxPlate::left_web : BoxPlate::top_flange);
        const BearingStiffener by =
            stiffener_of(*project_, web_of(judged, webs[k], flanges_of(patch).front(), patch),
                         across.clear(), of, station);
        Patch on = patch;
        on.diaphragm = &of;
        const Length flange = thinner_flange(walls, patch);
        for (const bool to_flange : {false, true}) {
          const StiffenerWeld weld{
              to_flange,
              by.both_sides ? 4 : 2,
              of.throat,
              to_flange ? weld_under(on, by, std::abs(shares[k]), flange,
                                     {walls.of(webs[0]).middle, walls.of(webs[1]).middle})
                        : by.web_depth,
              {}};
          const Area throats = static_cast<double>(weld.welds) * weld.throat *
                               std::max(si<Length>(1e-6), Length(weld.length - 2.0 * weld.throat));
          const Stress stress = shares[k] * patch.force / throats;
          std::optional<PressedWeb>& known = worst[k][to_flange ? 1 : 0];
          if (known && abs(stress) <= abs(known->stress)) continue;
          known = PressedWeb{webs[k], stress, near, near, {}, &of, weld};
        }
      }
    }
    for (const auto& of_web : worst)
      for (const std::optional<PressedWeb>& weld : of_web)
        if (weld) stressed.push_back(*weld);
  }
  return stressed;
}

BearingStiffener stiffener_of(const Project& project, const PatchedWeb& web, Length inside,
                              const Diaphragm& diaphragm, const Station& station) {
  BearingStiffener of;
  of.web_depth = web.depth;
  of.web_thickness = web.thickness;
  // What works with the next one works with that (9.1(2)).
  of.web_before = station.s;
  of.web_behind = project.beam.length() - station.s;
  for (const Diaphragm& other : project.beam.diaphragms) {
    const Length half = 0.5 * abs(other.s - diaphragm.s);
    Length& strip = other.s < diaphragm.s ? of.web_before : of.web_behind;
    if (half > Length{}) strip = std::min(strip, half);
  }
  of.thickness = diaphragm.thickness;
  of.width = 0.5 * (inside - diaphragm.opening);
  of.yield_strength = web.yield_strength;
  const Material& steel =
      materials_of(project, segment_at(project.beam, station)).of(PlateKind::inner);
  if (const auto own = yield_strength_of(steel, diaphragm.thickness))
    of.yield_strength = std::min(of.yield_strength, *own, std::less<>());
  return of;
}

}  // namespace boxbeam
