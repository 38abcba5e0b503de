#include "boxbeam/verification/stress_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/section/normal_stress.hpp"

namespace boxbeam {
namespace {

/// Grid points inside a segment on which maxima along the beam are bracketed.
constexpr int grid = 24;

struct Category {
  int value;
  std::string assumed;
};

/// The lowest category of the stretches a station lies in, or that of the whole beam.
Category category_at(const FatigueInput& fatigue, Length s) {
  Category lowest{fatigue.category, ""};
  bool found = false;
  for (const DetailStretch& stretch : fatigue.details) {
    if (s < stretch.from || s > stretch.to) continue;
    if (found && stretch.category >= lowest.value) continue;
    lowest = {stretch.category,
              stretch.assumed.empty() ? "" : stretch.name + ": " + stretch.assumed};
    found = true;
  }
  return lowest;
}

/// Whether section or loads jump at a place.
bool jumps_at(const TaperedBeam& beam, const LoadHistory& loads, Length s) {
  if (s.value() == 0.0 || s == beam.length()) return true;
  for (std::size_t i = 0; i + 1 < beam.segments.size(); ++i) {
    if (beam.segments[i].end() == s && !(beam.segments[i].to == beam.segments[i + 1].from))
      return true;
  }
  for (const PointLoad& load : loads.loads_at(loads.begin()).points) {
    if (load.s == s) return true;
  }
  return false;
}

/// Largest and smallest value over the instants.
struct Span {
  double low = 1e300, high = -1e300;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double range() const { return high - low; }
  double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

/// What may peak inside a segment: stress range and largest stress of both outer fibres (gross
/// section), the largest bending moment and the largest shear force, over the instants.
using Peaks = std::array<double, 6>;

Peaks peaks_at(const TaperedBeam& beam, const LoadHistory& loads, Length s) {
  const Section section = section_at(beam, {s});
  const AreaSums sums = sums_of(outline_of(section, {}));
  const Extent extent = extent_of(section.outer);
  const StressInfluence high = normal_influence(sums, 0.0, extent.z_high.value());
  const StressInfluence low = normal_influence(sums, 0.0, extent.z_low.value());
  Span top, bottom, M, V;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    const CutForces cut = loads.diagram(i).at({s});
    top.add(stress_at(high, cut).normal.value());
    bottom.add(stress_at(low, cut).normal.value());
    M.add(cut.M_y.value());
    V.add(cut.V_z.value());
  }
  return {top.range(), bottom.range(), top.largest(), bottom.largest(), M.largest(), V.largest()};
}

/// Brackets every inner maximum of each quantity on a grid in each piece and finds it by Brent.
void add_inner_maxima(const TaperedBeam& beam, const LoadHistory& loads,
                      std::vector<Length>& stations) {
  for (const CutForcePiece& piece : loads.diagram(0).pieces) {
    const auto at = [&](double j) { return piece.start + piece.length * (j / grid); };
    std::array<Peaks, grid + 1> values;
    for (std::size_t j = 0; j < values.size(); ++j) {
      // The very ends belong to the neighbours as well: look just inside.
      values[j] = peaks_at(beam, loads, at(std::clamp(static_cast<double>(j), 1e-6, grid - 1e-6)));
    }
    for (std::size_t q = 0; q < values[0].size(); ++q) {
      for (std::size_t j = 1; j < grid; ++j) {
        const double before = values[j][q] - values[j - 1][q];
        const double behind = values[j][q] - values[j + 1][q];
        // A difference within round-off is a level stretch, no maximum.
        const bool maximum =
            before >= 0.0 && behind > 0.0 && std::max(before, behind) > 1e-9 * values[j][q];
        if (!maximum) continue;
        const auto quantity = [&](double s) { return peaks_at(beam, loads, si<Length>(s))[q]; };
        const auto middle = static_cast<double>(j);
        stations.push_back(si<Length>(
            find_maximum(quantity, at(middle - 1.0).value(), at(middle + 1.0).value()).at));
      }
    }
  }
}

}  // namespace

std::vector<StressPoint> stress_points_at(const Project& project, const Station& station) {
  const TaperedBeam& beam = project.beam;
  const Taper taper = taper_at(beam, station);
  const StressField field =
      stress_field_of(section_at(beam, station), holes_at(beam, station.s), taper);
  const Section& section = field.section;
  const SectionProperties gross = properties_of(section);
  const SectionProperties net = properties_of(section, field.holes);
  const Category category = category_at(project.fatigue, station.s);

  std::vector<StressPoint> points;
  const auto add = [&](const SectionPoint& place, bool fatigue) -> StressPoint& {
    StressPoint point;
    point.station = station;
    point.name = place.name;
    point.y = place.y;
    point.z = place.z;
    point.section = section;
    point.gross = gross;
    point.net = net;
    point.influence = place.influence;
    point.prismatic = place.prismatic;
    point.plate = place.plate;
    point.yield_strength = yield_strength_of(project.material, point.plate).value();
    point.fatigue = fatigue;
    point.category = category.value;
    point.category_assumed = category.assumed;
    return points.emplace_back(std::move(point));
  };
  const auto add_level = [&](const std::string& name, Length z, bool fatigue) {
    for (const SectionPoint& place : points_at_level(field, name, z, PointSet::in_plane)) {
      add(place, fatigue);
    }
  };

  for (const SectionPoint& place : points_of(field, PointSet::in_plane)) {
    // Direct-stress fatigue is looked at where the bending stress is largest.
    const bool inside = place.name.starts_with("web end") || place.name.starts_with("neutral axis");
    add(place, !inside);
  }
  for (std::size_t i = 0; i < beam.holes.size(); ++i) {
    if (beam.holes[i].s != station.s) continue;
    const Hole& hole = beam.holes[i].hole;
    const HoleCase hole_case = project.hole_cases[i];
    const double a = hole.diameter / plate_width_of(section, field.holes, hole, hole_case);
    const double factor = hole_case == HoleCase::published_exponential
                              ? published_concentration(a)
                              : membrane_concentration(a) / (1.0 - a);
    const std::vector<HoleEdge> edges = hole_edges_of(section, field.holes, taper, hole, hole_case);
    SectionPoint edge{"hole " + hole.name + " edge", {}, edges.front().z, {}, {}, {}, {}};
    edge.plate = wall_at(section, edge.z);
    edge.influence = edge.prismatic = edges.front().influence;
    StressPoint& point = add(edge, true);
    point.concentration = EdgeConcentration{hole.name, hole_case, a, factor, 0.0};
    point.edges = edges;
    if (hole.walls == HoleWalls::webs) {
      // Where a hole has taken the neutral fibre, the shear is largest just beside the hole.
      add_level("beside hole " + hole.name + " +z", hole.position + 0.5 * hole.diameter, false);
      add_level("beside hole " + hole.name + " -z", hole.position - 0.5 * hole.diameter, false);
    }
  }
  for (const NamedPoint& named : project.points) {
    if (named.s == station.s) add_level(named.name, named.z, true);
  }
  return points;
}

StressPoint at_worst_edge(const StressPoint& point, const std::vector<SituationHistory>& histories,
                          Criterion criterion) {
  StressPoint moved = point;
  moved.edges.clear();
  double worst = -1.0;
  for (const HoleEdge& edge : point.edges) {
    double value = 0.0;
    for (const SituationHistory& at : histories) {
      Span span;
      for (const CutForces& cut : at.history.samples()) {
        span.add(stress_at(edge.influence, cut).normal.value());
      }
      value = std::max(value, criterion == Criterion::fatigue
                                  ? span.range()
                                  : at.situation->load_factor * span.largest());
    }
    if (value <= worst) continue;
    worst = value;
    moved.z = edge.z;
    moved.influence = edge.influence;
    moved.concentration->angle = edge.angle;
  }
  return moved;
}

std::vector<Station> stations_to_verify(const Project& project,
                                        const std::deque<SituationRun>& runs) {
  const TaperedBeam& beam = project.beam;
  std::vector<Length> places = places_of(beam);
  for (const NamedPoint& point : project.points) places.push_back(point.s);
  // The category changes at the ends of a detail's stretch; inside it is constant.
  for (const DetailStretch& stretch : project.fatigue.details) {
    places.push_back(stretch.from);
    places.push_back(stretch.to);
  }
  std::vector<Length> inner;
  for (const SituationRun& run : runs) add_inner_maxima(beam, run.loads, inner);
  // Maxima of different quantities close together are one station, the one of the stress range
  // first: near its maximum a quantity is level, so that what the others lose is of second order.
  std::vector<Length> chosen;
  for (const Length& s : inner) {
    const auto nearer_than = [&](double part) {
      return
          [&beam, &s, part](const Length& other) { return abs(other - s) < part * beam.length(); };
    };
    if (std::any_of(places.begin(), places.end(), nearer_than(1e-4)) ||
        std::any_of(chosen.begin(), chosen.end(), nearer_than(0.01))) {
      continue;
    }
    chosen.push_back(s);
  }
  places.insert(places.end(), chosen.begin(), chosen.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::vector<Station> stations;
  for (const Length& s : places) {
    const bool jump = std::any_of(runs.begin(), runs.end(), [&](const SituationRun& run) {
      return jumps_at(beam, run.loads, s);
    });
    if (!jump) {
      stations.push_back({s, Side::both});
      continue;
    }
    if (s.value() > 0.0) stations.push_back({s, Side::before});
    if (s < beam.length()) stations.push_back({s, Side::behind});
  }
  return stations;
}

}  // namespace boxbeam
