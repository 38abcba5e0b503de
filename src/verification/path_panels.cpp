#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boxbeam/section/wall_cells.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"
#include "boxbeam/strength/transverse_stiffener.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Why flats twist, "" where they do not.
std::string twisting_of(const BearingStiffener& flats) {
  if (resists_torsional_buckling({{}, flats.width, flats.thickness}, flats.yield_strength))
    return "";
  return fmt::format("its plates beside the web twist, {:.3g} wide by their thickness (9.2.1(8))",
                     (flats.width / flats.thickness).value());
}

}  // namespace

BearingStiffener flats_beside(const Project& project, const PathWeb& web,
                              const Diaphragm& diaphragm, const Station& station) {
  const bool whole = !web.both_sides && !(diaphragm.opening > Length{});
  BearingStiffener of = stiffener_of(
      project, web.bears, (web.both_sides || whole ? 2.0 : 1.0) * web.beside, diaphragm, station);
  of.both_sides = web.both_sides;
  return of;
}

std::string flats_obstacle(const BearingStiffener& flats) {
  if (!(flats.width > Length{})) return "nothing of it stands beside the web within the flanges";
  return twisting_of(flats);
}

namespace {

/// Whether all plates held at both ends are around cells, which a diaphragm fills.
bool is_of_cells(const PathSection& path) {
  std::vector<bool> around(path.graph.walls.size(), false);
  for (const Cell& cell : wall_cells_of(path.graph).cells)
    for (const Cell::Side& side : cell.sides) around[side.wall] = true;
  return std::all_of(path.plates.begin(), path.plates.end(), [&](const PathPlate& plate) {
    return plate.outstand() ||
           std::all_of(plate.parts.begin(), plate.parts.end(),
                       [&](const PathPlate::Part& part) { return around[part.wall]; });
  });
}

/// Why a diaphragm that fills cells does not bound panels so long of the walls around them that may
/// buckle in shear: of each what reaches half across the smaller cell beside it.
std::string cells_obstacle(const Project& project, const PathSection& path,
                           const Diaphragm& diaphragm, const Station& station, Length length) {
  const std::vector<Cell> cells = wall_cells_of(path.graph).cells;
  for (const PathPlate& plate : path.plates) {
    if (plate.outstand()) continue;
    PatchedWeb web;
    web.depth = plate.clear();
    web.thickness = plate.thickness;
    web.yield_strength = plate.yield_strength;
    const double eta = shear_hardening_factor(plate.class_strength);
    if (!shear_buckling_need(web.depth, web.thickness, plate.class_strength, eta).check_needed())
      continue;
    std::optional<double> smallest;
    for (const Cell& cell : cells) {
      const bool beside = std::any_of(cell.sides.begin(), cell.sides.end(), [&](const auto& side) {
        return std::any_of(plate.parts.begin(), plate.parts.end(),
                           [&](const PathPlate::Part& part) { return part.wall == side.wall; });
      });
      if (beside) smallest = std::min(smallest.value_or(cell.area), cell.area);
    }
    const Length inside = si<Length>(smallest.value_or(0.0) / web.depth.value());
    const std::string why =
        across_obstacle(stiffener_of(project, web, inside, diaphragm, station), diaphragm, length);
    if (!why.empty()) return plate.name + ": " + why;
  }
  return "";
}

/// Why it is not known what of a diaphragm is the stiffener of a wall, "" where it is.
std::string why_no_stiffener(const Project& project, const PathSection& path,
                             const std::string& wall, const Diaphragm& diaphragm,
                             const Station& station) {
  std::string why = "no flanges square to it at both its ends";
  for (const bool along_z : {true, false}) {
    const PathWebs of = webs_of_path(path, along_z, true);
    const bool is_one = std::any_of(of.webs.begin(), of.webs.end(),
                                    [&](const PathWeb& web) { return web.plate->name == wall; });
    if (!of.obstacle.empty()) why = of.obstacle;
    if (!of.obstacle.empty() || !is_one) continue;
    if (of.webs.size() > 2) return fmt::format("{} walls share it", of.webs.size());
    if (of.webs.size() == 2) return "";
    return flats_obstacle(flats_beside(project, of.webs.front(), diaphragm, station));
  }
  return why;
}

/// Why a diaphragm does not bound panels so long, "" where it does: by what of it works beside each
/// of two webs or around cells, beside one web by what of it lies within the flanges. The station
/// is on the panel's side of it.
std::string bounds_obstacle(const Project& project, const Station& station, Length length) {
  const auto at = std::find_if(project.beam.diaphragms.begin(), project.beam.diaphragms.end(),
                               [&](const Diaphragm& of) { return of.s == station.s; });
  const auto path = judged_path_at(project, {}, station);
  if (at == project.beam.diaphragms.end() || !path) return "";
  if (is_of_cells(*path)) return cells_obstacle(project, *path, *at, station, length);
  for (const bool along_z : {true, false}) {
    const PathWebs of = webs_of_path(*path, along_z, true);
    if (!of.obstacle.empty()) return of.obstacle;
    if (of.webs.size() > 2) return fmt::format("{} walls share it", of.webs.size());
    if (of.webs.size() == 2) {
      for (const PathWeb& web : of.webs) {
        std::string why = across_obstacle(
            stiffener_of(project, web.bears, of.inside(), *at, station), *at, length);
        if (!why.empty()) return why;
      }
    }
    if (of.webs.size() != 1) continue;
    const PathWeb& web = of.webs.front();
    const BearingStiffener flats = flats_beside(project, web, *at, station);
    if (std::string why = flats_obstacle(flats); !why.empty()) return why;
    if (std::string why = rigidity_obstacle(flats, length); !why.empty()) return why;
  }
  return "";
}

}  // namespace

std::optional<Length> path_panel_length_at(const Project& project, const Station& station) {
  auto length = panel_length_at(project.beam, station);
  const Supports of = supports_around(project.beam, station);
  if (!length || !of.before || !of.behind) return length;
  const bool bounded = bounds_obstacle(project, {*of.before, Side::behind}, *length).empty() &&
                       bounds_obstacle(project, {*of.behind, Side::before}, *length).empty();
  return bounded ? length : std::nullopt;
}

std::vector<NotJudged> not_judged_of_diaphragms(const Project& project) {
  // By what and why, at which diaphragms.
  std::map<std::string, std::vector<std::string>> places;
  for (const Diaphragm& of : project.beam.diaphragms) {
    const bool at_start = of.s == Length{}, at_end = of.s == project.beam.length();
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? at_start : at_end) continue;
      const Station station{of.s, side};
      const auto length = panel_length_at(project.beam, station);
      if (!length) continue;
      const auto say = [&](const std::string& what) {
        std::vector<std::string>& at = places[what];
        const std::string place = to_text(Station{of.s, Side::both});
        if (at.empty() || at.back() != place) at.push_back(place);
      };
      if (const auto walls = deciding_walls_at(project, station)) {
        for (const BoxPlate plate : box_plates) {
          if (!may_buckle_in_shear(walls->of(plate))) continue;
          const auto by = bounding_stiffener_at(project, station, *walls, plate);
          const std::string why = by ? rigidity_obstacle(*by, *length)
                                     : "its opening leaves nothing of it beside the web";
          if (!why.empty())
            say(fmt::format("the panels of the {} are longer, for {}", to_text(plate), why));
        }
        continue;
      }
      const auto path = judged_path_at(project, {}, station);
      if (!path) continue;
      const auto slender = slender_path_at(project, {}, station);
      if (!slender) continue;
      for (const ShearedWall& wall : slender->sheared) {
        if (!wall.may_buckle) continue;
        std::string why = bounds_obstacle(project, station, *length);
        const bool bounds = why.empty();
        if (bounds && !at_start && !at_end)
          why = why_no_stiffener(project, *path, wall.name, of, station);
        if (why.empty()) continue;
        say(bounds
                ? fmt::format("what {} pulls at them beyond its buckling in shear is not checked "
                              "(EN 1993-1-5, 9.3.3(3)): {}",
                              wall.name, why)
                : "the panels of the web are longer, for " + why);
      }
    }
  }
  std::vector<NotJudged> found;
  for (const auto& [what, at] : places) {
    found.push_back(
        {Criterion::shear_buckling,
         fmt::format("diaphragm{} at s = {} m", at.size() > 1 ? "s" : "", fmt::join(at, ", ")),
         what});
  }
  return found;
}

}  // namespace boxbeam
