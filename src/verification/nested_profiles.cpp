#include "nested_profiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/verification/stress_points.hpp"

namespace boxbeam {
namespace {

/// The use of an outer profile alone.
struct Alone {
  double use = 0.0;
  Station station;
  bool in_fatigue = false;

  void take(const Alone& other) {
    if (other.use > use) *this = other;
  }
};

/// Outer profiles alone at stations: the corners of what surrounds them, by their yield strengths.
class OuterAlone {
 public:
  explicit OuterAlone(const Project& project) : project_(&project) {}

  /// Over the yield strength, without factors.
  double use_at(const Station& station, const CutForces& cut) {
    double use = 0.0;
    for (const auto& [influence, strength] : corners_at(station))
      use = std::max(use, std::abs(stress_at(influence, cut).normal.value()) / strength);
    return use;
  }

 private:
  using Corners = std::vector<std::pair<StressInfluence, double>>;

  const Corners& corners_at(const Station& station) {
    const auto [known, is_new] = corners_.try_emplace({station.s.value(), station.side});
    if (!is_new) return known->second;
    const Section outer{section_at(project_->beam, station).outer, {}};
    const AreaSums sums = sums_of(outline_of(outer.outer));
    const Extent of = extent_of(outer.outer);
    const PlateMaterials materials = materials_of(*project_, segment_at(project_->beam, station));
    for (const Length& z : {of.z_low, of.z_high}) {
      const PlateOf plate = first_to_yield(plates_at(materials, outer, Length{}, z));
      const auto strength = yield_strength_of(*plate.material, plate.thickness);
      if (!strength) continue;
      for (const Length& y : {of.y_low, of.y_high})
        known->second.emplace_back(normal_influence(sums, y.value(), z.value()), strength->value());
    }
    return known->second;
  }

  const Project* project_;
  std::map<std::pair<double, Side>, Corners> corners_;
};

/// The worst place of a segment in strength.
Alone in_strength(const Project& project, const std::deque<SituationRun>& runs,
                  const Segment& segment) {
  Alone worst;
  OuterAlone outer(project);
  for (const SituationRun& run : runs) {
    const double scale =
        project.strength.required * project.strength.gamma_M0 * run.situation->load_factor;
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      const auto look = [&](const Station& at) {
        worst.take({scale * outer.use_at(at, diagram.at(at)), at, false});
      };
      look({segment.start, Side::behind});
      look({segment.end(), Side::before});
      for (const CutForcePiece& piece : diagram.pieces) {
        const Length s = piece.start;
        if (!(s > segment.start && s < segment.end())) continue;
        look({s, Side::before});
        look({s, Side::behind});
      }
    }
  }
  return worst;
}

/// The same in fatigue at some places.
Alone in_fatigue(const Project& project, const std::deque<SituationRun>& runs,
                 const std::vector<BendingZone>& zones, const std::vector<Station>& stations) {
  Alone worst;
  for (const Station& station : stations) {
    const Section section = section_at(project.beam, station);
    const AreaSums sums = sums_of(outline_of(section.outer));
    const std::vector<SituationHistory> histories = histories_at(runs, station);
    for (StressPoint& point : stress_points_at(project, zones, station)) {
      if (point.part != SectionPart::fibre || point.detail == nullptr || point.concentration)
        continue;
      point.influence.normal = normal_influence(sums, point.y.value(), point.z.value()).normal;
      if (const auto of = check_fatigue(project, histories, point, Criterion::fatigue))
        worst.take({of->check.utilisation(), station, true});
    }
  }
  return worst;
}

}  // namespace

void check_nested_profiles(const Project& project, const std::deque<SituationRun>& runs,
                           const std::vector<BendingZone>& zones, PatchChecks& found) {
  Alone worst;
  for (const Segment& segment : project.beam.segments) {
    if (!segment.from.inner) continue;
    const Alone here = in_strength(project, runs, segment);
    worst.take(here);
    if (!project.fatigue.asked) continue;
    std::vector<Station> stations{{segment.start, Side::behind}, {segment.end(), Side::before}};
    if (here.use > 0.0) stations.push_back(here.station);
    worst.take(in_fatigue(project, runs, zones, stations));
  }
  if (!(worst.use > 1.0)) return;
  found.not_judged.push_back(
      {worst.in_fatigue ? Criterion::fatigue : Criterion::yield, "what ties the inner profile",
       fmt::format("the outer alone is used by {:.3g}{} at s = {} m", worst.use,
                   worst.in_fatigue ? " in fatigue" : "", to_text(worst.station))});
}

}  // namespace boxbeam
