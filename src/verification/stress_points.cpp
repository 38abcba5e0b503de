#include "boxbeam/verification/stress_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/section/normal_stress.hpp"

namespace boxbeam {
namespace {

/// Grid points inside a segment on which maxima along the beam are bracketed.
constexpr int grid = 24;

/// What resists at a place.
struct ResistingDetail {
  const BeamDetail* detail = nullptr;
  bool compression_reduced = false;
};

/// The weakest detail of the stretches that a place lies in, or that of the whole beam. Compression
/// counts 60 % only where none of them is welded as it is.
ResistingDetail detail_at(const FatigueInput& fatigue, Length s, DetailPlace on) {
  const BeamDetail* weakest = nullptr;
  bool reduced = true;
  const auto strength = [](const BeamDetail& of) {
    return strength_at(curve_of(of.detail), 2e6, Loading::spectrum) / of.stress_factor;
  };
  for (const BeamDetail& stretch : fatigue.details) {
    if (s < stretch.from || s > stretch.to) continue;
    if (stretch.on != DetailPlace::section && stretch.on != on) continue;
    reduced = reduced && stretch.detail.compression_reduced;
    if (weakest == nullptr || strength(stretch) < strength(*weakest)) weakest = &stretch;
  }
  if (weakest == nullptr) return {&fatigue.beam, fatigue.beam.detail.compression_reduced};
  return {weakest, reduced};
}

/// Area integrals of a section known by its properties.
AreaSums sums_of(const SectionProperties& of) {
  const double A = of.area.value();
  const double y = of.centroid_y.value();
  const double z = of.centroid_z.value();
  return {A,
          A * y,
          A * z,
          of.I_z.value() + A * y * y,
          of.I_y.value() + A * z * z,
          of.I_yz.value() + A * y * z};
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

/// What may peak inside a segment: stress range and largest stress of both outer fibres (without
/// holes), the largest bending moment and the largest shear force, over the instants.
using Peaks = std::array<double, 6>;

/// Where maxima are looked for.
struct Along {
  const TaperedBeam& beam;
  const std::vector<BendingZone>& zones;
  const LoadHistory& loads;
};

Peaks peaks_at(const Along& along, Length s) {
  const LoadHistory& loads = along.loads;
  const Section section = section_at(along.beam, {s});
  const auto lag = shear_lag_at(along.zones, section, s);
  const AreaSums sums = lag ? sums_of(properties_of(section, {}, lag->flange_part))
                            : sums_of(outline_of(section, {}));
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
void add_inner_maxima(const Along& along, std::vector<Length>& stations) {
  for (const CutForcePiece& piece : along.loads.diagram(0).pieces) {
    const auto at = [&](double j) { return piece.start + piece.length * (j / grid); };
    std::array<Peaks, grid + 1> values;
    for (std::size_t j = 0; j < values.size(); ++j) {
      // The very ends belong to the neighbours as well: look just inside.
      values[j] = peaks_at(along, at(std::clamp(static_cast<double>(j), 1e-6, grid - 1e-6)));
    }
    for (std::size_t q = 0; q < values[0].size(); ++q) {
      for (std::size_t j = 1; j < grid; ++j) {
        const double before = values[j][q] - values[j - 1][q];
        const double behind = values[j][q] - values[j + 1][q];
        // A difference within round-off is a level stretch, no maximum.
        const bool maximum =
            before >= 0.0 && behind > 0.0 && std::max(before, behind) > 1e-9 * values[j][q];
        if (!maximum) continue;
        const auto quantity = [&](double s) { return peaks_at(along, si<Length>(s))[q]; };
        const auto middle = static_cast<double>(j);
        stations.push_back(si<Length>(
            find_maximum(quantity, at(middle - 1.0).value(), at(middle + 1.0).value()).at));
      }
    }
  }
}

}  // namespace

namespace {

/// The points of one station as they are gathered.
class StressPoints {
 public:
  StressPoints(const Project& project, const std::vector<BendingZone>& zones,
               const Station& station)
      : project_(&project),
        station_(station),
        taper_(taper_at(project.beam, station)),
        field_(stress_field_of(section_at(project.beam, station), holes_at(project.beam, station.s),
                               taper_)),
        gross_(properties_of(field_.section)),
        net_(properties_of(field_.section, field_.holes)),
        lag_(shear_lag_at(zones, field_.section, station.s)) {
    if (lag_) net_ = properties_of(field_.section, field_.holes, lag_->flange_part);
  }

  void add_section() {
    const FatigueInput& fatigue = project_->fatigue;
    const ResistingDetail fibres = detail_at(fatigue, station_.s, DetailPlace::fibres);
    const ResistingDetail seams = detail_at(fatigue, station_.s, DetailPlace::seams);
    const bool walls = std::holds_alternative<ThinWalled>(field_.section.outer);
    for (const SectionPoint& place : points_of(field_, PointSet::in_plane)) {
      const bool seam = place.name.starts_with("web end");
      const bool neutral = !walls && place.name.starts_with("neutral axis");
      StressPoint& point = add(place);
      resist(point, neutral ? ResistingDetail{} : (seam ? seams : fibres));
      point.shear_detail = &fatigue.shear;
      if (!place.on_throat) continue;
      SectionPoint throat = place;
      throat.name = "seam" + place.name.substr(std::string("web end").size()) + " throat";
      throat.influence = *place.on_throat;
      StressPoint& on_throat = add(throat);
      on_throat.influence.normal = {};
      on_throat.shear_detail = &fatigue.throat;
      on_throat.on_throat = true;
      on_throat.yield = false;
    }
  }

  void add_hole(const Hole& hole, const HoleInput& input) {
    ResistingDetail detail = detail_at(project_->fatigue, station_.s, DetailPlace::fibres);
    if (input.detail) detail = {&*input.detail, input.detail->detail.compression_reduced};
    if (input.concentration) {
      const HoleCase hole_case = *input.concentration;
      const double a =
          hole.diameter / plate_width_of(field_.section, field_.holes, hole, hole_case);
      const double factor = hole_case == HoleCase::published_exponential
                                ? published_concentration(a)
                                : membrane_concentration(a) / (1.0 - a);
      std::vector<HoleEdge> edges =
          hole_edges_of(field_.section, field_.holes, taper_, hole, hole_case);
      if (!taper_.empty()) {
        // How much of the shear the inclined flanges carry near a hole, often at a kink of the
        // taper and under a force, is not certain: the worse of both shears counts.
        const std::vector<HoleEdge> prismatic =
            hole_edges_of(field_.section, field_.holes, {}, hole, hole_case);
        edges.insert(edges.end(), prismatic.begin(), prismatic.end());
      }
      // Shear lag leaves less to bend, and raises every stress of bending alike.
      const double less = properties_of(field_.section, field_.holes).I_y / net_.I_y;
      for (HoleEdge& edge : edges) edge.influence.normal[cut_force::M_y] *= less;
      SectionPoint edge{"hole " + hole.name + " edge", {}, edges.front().z, {}, {}, {}, {}};
      edge.plate = wall_at(field_.section, edge.z);
      edge.influence = edge.prismatic = edges.front().influence;
      StressPoint& point = add(edge);
      point.influence = edges.front().influence;  // of the gross section, as its source has it
      resist(point, detail);
      point.concentration = EdgeConcentration{hole.name, hole_case, a, factor, 0.0};
      point.edges = edges;
    }
    // Where a hole has taken the neutral fibre, the shear is largest just beside the hole; a
    // category for the net section is judged by the nominal stress there.
    const bool webs = hole.walls == HoleWalls::webs;
    for (const double sign : {1.0, -1.0}) {
      const Length z = webs ? hole.position + sign * 0.5 * hole.diameter
                            : (sign > 0.0 ? gross_.z_top : gross_.z_bottom);
      if (!webs && input.concentration) continue;
      const std::string name = "beside hole " + hole.name + (sign > 0.0 ? " +z" : " -z");
      add_level(name, z, input.concentration ? ResistingDetail{} : detail);
    }
  }

  void add_level(const std::string& name, Length z, const ResistingDetail& detail) {
    for (const SectionPoint& place : points_at_level(field_, name, z, PointSet::in_plane)) {
      StressPoint& point = add(place);
      resist(point, detail);
      point.shear_detail = &project_->fatigue.shear;
    }
  }

  std::vector<StressPoint> points;

 private:
  static void resist(StressPoint& point, const ResistingDetail& detail) {
    point.detail = detail.detail;
    point.compression_reduced = detail.compression_reduced;
  }

  StressPoint& add(const SectionPoint& place) {
    StressPoint point;
    point.station = station_;
    point.name = place.name;
    point.y = place.y;
    point.z = place.z;
    point.section = field_.section;
    point.gross = gross_;
    point.net = net_;
    point.influence = place.influence;
    point.prismatic = place.prismatic;
    if (lag_) {
      point.influence.normal =
          normal_influence(sums_of(net_), place.y.value(), place.z.value()).normal;
    }
    point.plate = place.plate;
    point.yield_strength = yield_strength_of(project_->material, point.plate).value();
    point.lag = lag_;
    return points.emplace_back(std::move(point));
  }

  const Project* project_;
  Station station_;
  Taper taper_;
  StressField field_;
  SectionProperties gross_, net_;
  std::optional<ShearLag> lag_;
};

}  // namespace

namespace {

/// The normal stress on a hole's edge over the instants of each situation that runs, by index.
std::vector<Span> spans_at(const Project& project, const std::vector<SituationHistory>& histories,
                           const HoleEdge& edge) {
  std::vector<Span> spans(project.situations.size());
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      spans[index_of(project, *at.situation)].add(stress_at(edge.influence, cut).normal.value());
    }
  }
  return spans;
}

double largest_stress_of(const Project& project, const std::vector<Span>& spans) {
  double largest = 0.0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.between.empty())
      largest = std::max(largest, situation.load_factor * spans[i].largest());
  }
  return largest;
}

/// How badly one cycle in each situation, and in each change between some, uses up a detail: the
/// reciprocal of the factor that the cycles of the life leave.
double fatigue_severity_of(const Project& project, const std::vector<Span>& spans,
                           const Detail& detail, bool reduced) {
  std::vector<Cycle> cycles;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Situation& situation = project.situations[i];
    if (situation.cycles == 0.0) continue;
    Span span = spans[i];
    for (const std::size_t other : situation.between) {
      span.add(spans[other].low);
      span.add(spans[other].high);
    }
    cycles.push_back(
        {si<Stress>(span.range()), si<Stress>(0.5 * (span.high + span.low)), situation.cycles});
  }
  if (reduced) cycles = compression_reduced(std::move(cycles));
  return 1.0 / largest_factor(cycles, curve_of(detail), project.fatigue.demand);
}

}  // namespace

std::vector<StressPoint> stress_points_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station) {
  StressPoints gathered(project, zones, station);
  gathered.add_section();
  for (std::size_t i = 0; i < project.beam.holes.size(); ++i) {
    const BeamHole& at = project.beam.holes[i];
    if (at.s == station.s) gathered.add_hole(at.hole, project.hole_inputs[i]);
  }
  for (const NamedPoint& named : project.points) {
    if (named.s != station.s) continue;
    gathered.add_level(named.name, named.z,
                       detail_at(project.fatigue, station.s, DetailPlace::fibres));
  }
  return std::move(gathered.points);
}

StressPoint at_worst_edge(const Project& project, const StressPoint& point,
                          const std::vector<SituationHistory>& histories, Criterion criterion) {
  StressPoint moved = point;
  moved.edges.clear();
  double worst = -1.0;
  for (const HoleEdge& edge : point.edges) {
    const std::vector<Span> spans = spans_at(project, histories, edge);
    const double value =
        criterion == Criterion::fatigue && point.detail != nullptr
            ? fatigue_severity_of(project, spans, point.detail->detail, point.compression_reduced)
            : largest_stress_of(project, spans);
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
  const std::vector<BendingZone> zones = bending_zones_of(project, runs);
  const TaperedBeam& beam = project.beam;
  std::vector<Length> places = places_of(beam);
  for (const NamedPoint& point : project.points) places.push_back(point.s);
  // The category changes at the ends of a detail's stretch; inside it is constant.
  for (const BeamDetail& stretch : project.fatigue.details) {
    places.push_back(stretch.from);
    places.push_back(stretch.to);
  }
  std::vector<Length> inner;
  for (const SituationRun& run : runs) add_inner_maxima({beam, zones, run.loads}, inner);
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
