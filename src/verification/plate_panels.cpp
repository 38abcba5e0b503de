#include "plate_panels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/transverse_stiffener.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "patch_search.hpp"

namespace boxbeam {
namespace {

std::optional<FourWalls> walls_at(const Project& project, const Station& station) {
  return four_walls_of(section_at(project.beam, station).outer,
                       materials_of(project, segment_at(project.beam, station)));
}

/// The indices of the diaphragms between which a station lies, the second one behind the first by
/// one, or by two where it is one itself, without a side. The ends of the beam have one side.
std::optional<std::pair<std::size_t, std::size_t>> neighbours_of(const TaperedBeam& beam,
                                                                 Station station) {
  const std::vector<Diaphragm>& diaphragms = beam.diaphragms;
  if (station.s.value() == 0.0) station.side = Side::behind;
  if (station.s == beam.length()) station.side = Side::before;
  // Cuts within round-off of each other are one, which may stand beside the diaphragm.
  const Length near = 1e-9 * beam.length();
  const auto at_or_behind =
      std::lower_bound(diaphragms.begin(), diaphragms.end(), station.s - near,
                       [](const Diaphragm& of, const Length& s) { return of.s < s; });
  const bool here = at_or_behind != diaphragms.end() && at_or_behind->s <= station.s + near;
  const auto next = here && station.side != Side::before ? at_or_behind + 1 : at_or_behind;
  const auto from = here && station.side == Side::behind ? next : at_or_behind;
  if (next == diaphragms.end() || from == diaphragms.begin()) return std::nullopt;
  return std::pair{static_cast<std::size_t>(from - diaphragms.begin()) - 1,
                   static_cast<std::size_t>(next - diaphragms.begin())};
}

const Diaphragm* diaphragm_near(const TaperedBeam& beam, Length s) {
  const Length near = 1e-9 * beam.length();
  for (const Diaphragm& of : beam.diaphragms)
    if (abs(of.s - s) <= near) return &of;
  return nullptr;
}

bool is_rigid(const Project& project, BoxPlate web, const Diaphragm& a, const Diaphragm& b) {
  Length deepest, thickness, narrowest = project.beam.length();
  Stress yield_strength;
  for (const Station& station : {Station{a.s, Side::behind}, Station{b.s, Side::before}}) {
    const std::optional<FourWalls> walls = walls_at(project, station);
    if (!walls) return false;
    const BoxWall& of = walls->of(web);
    deepest = std::max(deepest, of.clear());
    thickness = std::max(thickness, of.thickness);
    yield_strength = std::max(yield_strength, of.class_strength, std::less<>());
    narrowest = std::min(narrowest, walls->of(BoxPlate::top_flange).clear());
  }
  const EndPost post{b.s - a.s, std::min(a.thickness, b.thickness),
                     0.5 * (narrowest - std::max(a.opening, b.opening))};
  return is_rigid_end_post(post, deepest, thickness, yield_strength);
}

}  // namespace

Supports supports_around(const TaperedBeam& beam, Station station) {
  if (station.s.value() == 0.0) station.side = Side::behind;
  if (station.s == beam.length()) station.side = Side::before;
  const Length near = 1e-9 * beam.length();
  Supports supports;
  for (const Diaphragm& of : beam.diaphragms) {
    const bool here = of.s >= station.s - near && of.s <= station.s + near;
    const bool before = here ? station.side == Side::behind : of.s < station.s;
    if (here && station.side == Side::both) continue;
    if (before)
      supports.before = of.s;
    else if (!supports.behind)
      supports.behind = of.s;
  }
  return supports;
}

namespace {

/// With what of it works.
BearingStiffener working(BearingStiffener of, const Diaphragm& diaphragm) {
  of.width =
      working_width_of(of.width, of.thickness, of.yield_strength, !(diaphragm.opening > Length{}));
  return of;
}

/// The least length of the panels that the diaphragm at a station bounds of a box's plate.
std::optional<Length> bounded_from(const Project& project, const Station& station, BoxPlate plate) {
  const auto walls = walls_at(project, station);
  const auto of = walls ? bounding_stiffener_at(project, station, *walls, plate) : std::nullopt;
  return of ? least_panel_length_of(*of) : std::nullopt;
}

}  // namespace

std::optional<BearingStiffener> bounding_stiffener_at(const Project& project,
                                                      const Station& station,
                                                      const FourWalls& walls, BoxPlate plate) {
  const Diaphragm* const at = diaphragm_near(project.beam, station.s);
  if (at == nullptr) return std::nullopt;
  const BoxWall& wall = walls.of(plate);
  PatchedWeb web;
  web.depth = wall.clear();
  web.thickness = wall.thickness;
  web.yield_strength = wall.yield_strength;
  const Length inside =
      walls.of(is_flange(plate) ? BoxPlate::left_web : BoxPlate::top_flange).clear();
  const BearingStiffener of = stiffener_of(project, web, inside, *at, station);
  if (!(of.width > Length{})) return std::nullopt;
  return working(of, *at);
}

std::string across_obstacle(const BearingStiffener& of, const Diaphragm& diaphragm, Length length) {
  if (!(of.width > Length{})) return "its opening leaves nothing of it beside the web";
  return rigidity_obstacle(working(of, diaphragm), length);
}

std::optional<Length> panel_length_at(const Project& project, const Station& station,
                                      BoxPlate plate) {
  auto length = panel_length_at(project.beam, station);
  const Supports of = supports_around(project.beam, station);
  if (!length || !of.before || !of.behind) return length;
  for (const Station& end :
       {Station{*of.before, Side::behind}, Station{*of.behind, Side::before}}) {
    const auto least = bounded_from(project, end, plate);
    if (!least) return std::nullopt;
    length = std::max(*length, *least);
  }
  return length;
}

namespace {

/// Whether the diaphragm at a station holds a plate that is compressed, so that its stiffeners are
/// columns between one and the next: a whole one is stiff in its plane, one with an opening as the
/// strip beside the plate.
bool holds_compressed(const Project& project, const Station& station, const FourWalls& walls,
                      BoxPlate plate) {
  if (!bounded_from(project, station, plate)) return false;
  const Diaphragm* const at = diaphragm_near(project.beam, station.s);
  const auto strip = bounding_stiffener_at(project, station, walls, plate);
  if (at == nullptr || !strip) return false;
  if (!(at->opening > Length{})) return true;
  const BoxWall& wall = walls.of(plate);
  Area area = wall.clear() * wall.thickness;
  for (const FlatStiffener& flat : wall.stiffeners) area += flat.depth * flat.thickness;
  const Length before =
      supports_around(project.beam, {station.s, Side::before}).before.value_or(Length{});
  const Length behind = supports_around(project.beam, {station.s, Side::behind})
                            .behind.value_or(project.beam.length());
  const HeldPlate held{area * wall.yield_strength, wall.clear(), station.s - before,
                       behind - station.s};
  return stiffener_inertia(*strip) >= holding_stiffener_inertia(held, strip->width,
                                                                strip->yield_strength,
                                                                project.strength.gamma_M1);
}

}  // namespace

Length supported_length_at(const Project& project, const Station& station) {
  const TaperedBeam& beam = project.beam;
  Supports of = supports_around(beam, station);
  // What does not hold a box's stiffened plates, which are columns between supports, is passed
  // over.
  const auto holds = [&](const Station& end) {
    const auto walls = walls_at(project, end);
    return !walls || std::all_of(box_plates.begin(), box_plates.end(), [&](BoxPlate plate) {
      return walls->of(plate).stiffeners.empty() || holds_compressed(project, end, *walls, plate);
    });
  };
  while (of.before && *of.before > Length{} && !holds({*of.before, Side::behind}))
    of.before = supports_around(beam, {*of.before, Side::before}).before;
  while (of.behind && *of.behind < beam.length() && !holds({*of.behind, Side::before}))
    of.behind = supports_around(beam, {*of.behind, Side::behind}).behind;
  return of.behind.value_or(beam.length()) - of.before.value_or(Length{});
}

void divide_into_panels(const Project& project, const Station& station,
                        std::vector<ShearedPlate>& plates) {
  const std::vector<Diaphragm>& diaphragms = project.beam.diaphragms;
  const auto between = neighbours_of(project.beam, station);
  if (!between) return;
  const std::size_t count = diaphragms.size();
  const bool inside = between->first > 0 && between->second + 1 < count;
  for (ShearedPlate& plate : plates) {
    plate.panel.length = panel_length_at(project, station, plate.plate);
    plate.panel.rigid_end_post =
        inside && !is_flange(plate.plate) &&
        is_rigid(project, plate.plate, diaphragms[0], diaphragms[1]) &&
        is_rigid(project, plate.plate, diaphragms[count - 2], diaphragms[count - 1]);
    plate.resists = shear_resistance_of(plate.panel, project.strength.gamma_M1);
  }
}

std::optional<Length> panel_length_at(const TaperedBeam& beam, const Station& station) {
  const auto between = neighbours_of(beam, station);
  if (!between) return std::nullopt;
  return beam.diaphragms[between->second].s - beam.diaphragms[between->first].s;
}

bool may_buckle_in_shear(const BoxWall& wall) {
  return shear_buckling_need(wall.clear(), wall.thickness, wall.yield_strength,
                             shear_hardening_factor(wall.yield_strength))
      .check_needed();
}

LagShares lag_shares_at(const std::vector<BendingZone>& zones, const Section& section,
                        const Station& station) {
  return {ultimate_share_at(zones, section, station, BendingAxis::y),
          ultimate_share_at(zones, section, station, BendingAxis::z)};
}

}  // namespace boxbeam
