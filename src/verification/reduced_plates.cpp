#include "boxbeam/verification/reduced_plates.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Makes rectangles of the plates of a steep segment.
void make_rectangles(const Project& project, const Station& station,
                     std::vector<ReducedPlate>& plates) {
  const Segment& segment = project.beam.segments[segment_at(project.beam, station)];
  const EdgeSlopes slopes = edge_slopes_of(segment);
  const std::array<Length, 4> widest = widest_in_panel(project, station);
  const std::vector<FourWalls> ends = walls_of_segment(project, station);
  for (ReducedPlate& of : plates) {
    const BoxPlate plate = of.sheared.plate;
    of.panel.depth = std::max(of.panel.depth, widest[static_cast<std::size_t>(plate)]);
    of.along_edge = 1.0 + slopes.along_y * slopes.along_y + slopes.along_z * slopes.along_z;
    if (!of.panel.length || ends.size() != 2) continue;
    const double own =
        ((ends[1].of(plate).middle - ends[0].of(plate).middle) / segment.length).value();
    of.panel.length = std::hypot(1.0, own) * *of.panel.length;
  }
}

}  // namespace

std::array<Length, 4> widest_in_panel(const Project& project, const Station& station) {
  const TaperedBeam& beam = project.beam;
  std::size_t first = segment_at(beam, station), last = first;
  while (first > 0 && is_steep(beam.segments[first - 1])) --first;
  while (last + 1 < beam.segments.size() && is_steep(beam.segments[last + 1])) ++last;
  const Supports supports = supports_around(beam, station);
  const Length from = supports.before.value_or(beam.segments[first].start);
  const Length to = supports.behind.value_or(beam.segments[last].end());
  std::vector<Station> places{{from, Side::behind}, {to, Side::before}};
  for (const Segment& of : beam.segments) {
    if (!(of.start > from && of.start < to)) continue;
    places.push_back({of.start, Side::before});
    places.push_back({of.start, Side::behind});
  }
  std::array<Length, 4> widest{};
  for (const Station& at : places) {
    const auto walls =
        four_walls_of(section_at(beam, at).outer, materials_of(project, segment_at(beam, at)));
    if (!walls) continue;
    for (std::size_t k = 0; k < widest.size(); ++k)
      widest[k] = std::max(widest[k], walls->walls[k].clear());
  }
  return widest;
}

PanelStress ReducedPlate::under(const CutForces& cut) const {
  const PlateStress of = ends.under(cut);
  const Stress shear = sheared.force_of(cut) / (sheared.panel.depth * sheared.panel.thickness);
  PanelStress stress{along_edge * of.compression, along_edge * of.tension, of.psi, shear};
  if (!held_at_high) return stress;
  const bool at_tip = of.psi == 1.0 || of.more_at_high != *held_at_high;
  stress.outstand = at_tip ? LargestCompression::at_tip : LargestCompression::at_support;
  if (!at_tip) stress.psi = std::max(-1.0, stress.psi);
  return stress;
}

std::array<Stress, 2> ReducedPlate::edges_under(const CutForces& cut) const {
  std::array<Stress, 2> of = ends.compression_under(cut);
  for (Stress& stress : of) stress *= along_edge;
  return of;
}

double ReducedPlate::use(const CutForces& cut, double gamma_M1) const {
  return reduced_stress_of(panel, under(cut), gamma_M1).use;
}

std::vector<ReducedPlate> reduced_plates_at(const Project& project,
                                            const std::vector<BendingZone>& zones,
                                            const Station& station, const Section& section,
                                            const FourWalls& walls,
                                            const std::vector<ShearedPlate>& sheared) {
  const bool stiffened = std::any_of(walls.walls.begin(), walls.walls.end(),
                                     [](const BoxWall& of) { return !of.stiffeners.empty(); });
  if (stiffened) return {};
  const ShearLags lags = shear_lags_at(zones, section, station);
  const AreaSums sums =
      lags.count() ? sums_of(effective_properties_of(section, {}, lags)) : walls.gross;
  std::vector<ReducedPlate> plates;
  for (const ShearedPlate& of : sheared)
    plates.push_back({of, PlateEnds(walls, of.plate, sums), of.panel});
  if (is_steep(project.beam.segments[segment_at(project.beam, station)]))
    make_rectangles(project, station, plates);
  return plates;
}

std::vector<ReducedPlate> reduced_plates_of(const PathSection& path,
                                            const std::vector<ShearedWall>& held,
                                            const std::vector<ShearedWall>& outstands) {
  std::vector<ReducedPlate> plates;
  if (std::any_of(path.lag.begin(), path.lag.end(),
                  [](const std::array<double, 2>& of) { return of[0] < 1.0 || of[1] < 1.0; }))
    return plates;
  for (const PathPlate& plate : path.plates) {
    const auto named = [&](const ShearedWall& of) { return of.name == plate.name; };
    const std::vector<ShearedWall>& among = plate.outstand() ? outstands : held;
    const auto sheared = std::find_if(among.begin(), among.end(), named);
    if (sheared == among.end()) continue;
    const auto at = [&](double along) {
      const Eigen::Vector2d place = plate.at(along);
      return normal_influence(path.gross, place.x(), place.y());
    };
    ReducedPlate& of = plates.emplace_back(
        ReducedPlate{{*sheared, {}}, PlateEnds(at(plate.low), at(plate.high)), sheared->panel});
    if (plate.outstand()) of.held_at_high = plate.held_at_high();
  }
  return plates;
}

}  // namespace boxbeam
