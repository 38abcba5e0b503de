#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "patch_search.hpp"
#include "plate_panels.hpp"

namespace boxbeam {

bool is_firm(const Project& project, const Diaphragm& of, bool along_z) {
  using enum BoxPlate;
  const std::array webs =
      along_z ? std::array{left_web, right_web} : std::array{top_flange, bottom_flange};
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? of.s == Length{} : of.s == project.beam.length()) continue;
    const Station station{of.s, side};
    const auto walls = judged_walls_at(project, station);
    if (!walls) continue;
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
                                    const std::string& plate, const CutForceDiagram& diagram,
                                    Borne borne, std::vector<Borne>& ways) {
  PatchBasis& basis = borne.basis;
  basis.resistance = bearing_resistance_of(stiffener, project_->strength.gamma_M1);
  basis.bears = stiffener;
  if (basis.share * basis.force > Force{}) {
    ways.push_back(borne);
    bear_by_welds(patch, stiffener, borne, ways);
  }
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

void PatchSearch::bear_by_welds(const Patch& patch, const BearingStiffener& stiffener, Borne borne,
                                std::vector<Borne>& ways) const {
  const Diaphragm& of = *patch.diaphragm;
  const PlateOf joined = weakest_to_weld(plates_around(*project_, of.s, of.thickness));
  const auto tensile = tensile_strength_of(*joined.material, joined.thickness);
  if (!tensile) return;
  const bool said = of.throat > Length{};
  borne.part = said ? Borne::Part::weld : Borne::Part::unsaid_weld;
  for (const bool to_flange : {false, true}) {
    const StiffenerWeld weld{to_flange,
                             stiffener.both_sides ? 4 : 2,
                             said ? of.throat : least_throat(),
                             to_flange ? stiffener.width : stiffener.web_depth,
                             {*tensile, joined.material->beta_w, project_->strength.gamma_M2}};
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
    std::array<std::optional<PressedWeb>, 2> worst;
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
        for (const bool to_flange : {false, true}) {
          const StiffenerWeld weld{
              to_flange, by.both_sides ? 4 : 2, of.throat, to_flange ? by.width : by.web_depth, {}};
          const Area throats = static_cast<double>(weld.welds) * weld.throat *
                               std::max(si<Length>(1e-6), Length(weld.length - 2.0 * weld.throat));
          const Stress stress = shares[k] * patch.force / throats;
          if (worst[k] && abs(stress) <= abs(worst[k]->stress)) continue;
          worst[k] = PressedWeb{webs[k], stress, near, near, {}, &of, weld};
        }
      }
    }
    for (const std::optional<PressedWeb>& weld : worst)
      if (weld) stressed.push_back(*weld);
  }
  return stressed;
}

BearingStiffener stiffener_of(const Project& project, const PatchedWeb& web, Length inside,
                              const Diaphragm& diaphragm, const Station& station) {
  BearingStiffener of;
  of.web_depth = web.depth;
  of.web_thickness = web.thickness;
  of.web_before = station.s;
  of.web_behind = project.beam.length() - station.s;
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
