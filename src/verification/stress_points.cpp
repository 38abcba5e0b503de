#include "boxbeam/verification/stress_points.hpp"

#include <algorithm>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/normal_stress.hpp"

namespace boxbeam {
namespace {

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

/// The points of one station as they are gathered.
class StressPoints {
 public:
  StressPoints(const Project& project, const std::vector<BendingZone>& zones,
               const Station& station)
      : project_(&project),
        station_(station),
        taper_(taper_at(project.beam, station)),
        set_(in_space(project) ? PointSet::in_space : PointSet::in_plane),
        field_(stress_field_of(section_at(project.beam, station), holes_at(project.beam, station.s),
                               taper_)),
        gross_(properties_of(field_.section)),
        net_(properties_of(field_.section, field_.holes)),
        lags_(shear_lags_at(zones, field_.section, station.s)) {
    if (lags_.count()) net_ = effective_properties_of(field_.section, field_.holes, lags_);
    if (set_ == PointSet::in_space) stop_where(unknown_shear_of(field_.section));
  }

  void add_section() {
    const FatigueInput& fatigue = project_->fatigue;
    const ResistingDetail fibres = detail_at(fatigue, station_.s, DetailPlace::fibres);
    const ResistingDetail seams = detail_at(fatigue, station_.s, DetailPlace::seams);
    const bool walls = std::holds_alternative<ThinWalled>(field_.section.outer);
    const bool space = set_ == PointSet::in_space;
    for (const SectionPoint& place : points_of(field_, set_)) {
      const bool seam = place.name.starts_with("web end");
      // In space nothing is neutral.
      const bool neutral = !space && !walls && place.name.starts_with("neutral axis");
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
    if (!space) return;
    const auto field = std::make_shared<const StressField>(field_);
    for (const WallStretch& stretch : wall_stretches_of(field_)) {
      StressPoint& point = add(point_on_stretch(field_, stretch, 0.0));
      resist(point, fibres);
      point.shear_detail = &fatigue.shear;
      point.stretch = StressStretch{field, stretch};
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
      const EdgeConcentration concentration{hole.name, hole_case, a, factor, 0.0};
      if (set_ == PointSet::in_space) {
        stop_where(unknown_hole_stress_of(field_.section, hole_case));
        std::vector<HoleInWall> walls =
            holes_in_walls_of(field_.section, field_.holes, taper_, hole);
        if (!taper_.empty()) {
          std::vector<HoleInWall> prismatic =
              holes_in_walls_of(field_.section, field_.holes, {}, hole);
          for (std::size_t i = 0; i < walls.size(); ++i) append(walls[i].edges, prismatic[i].edges);
        }
        for (HoleInWall& wall : walls) {
          add_edge("hole " + hole.name + " edge " + wall.side, std::move(wall.edges), detail,
                   concentration);
        }
      } else {
        std::vector<HoleEdge> edges =
            hole_edges_of(field_.section, field_.holes, taper_, hole, hole_case);
        // How much of the shear the inclined flanges carry near a hole, often at a kink of the
        // taper and under a force, is not certain: the worse of both shears counts.
        if (!taper_.empty())
          append(edges, hole_edges_of(field_.section, field_.holes, {}, hole, hole_case));
        add_edge("hole " + hole.name + " edge", std::move(edges), detail, concentration);
      }
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
    for (const SectionPoint& place : points_at_level(field_, name, z, set_)) {
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

  static void append(std::vector<HoleEdge>& edges, const std::vector<HoleEdge>& others) {
    edges.insert(edges.end(), others.begin(), others.end());
  }

  void add_edge(const std::string& name, std::vector<HoleEdge> edges, const ResistingDetail& detail,
                const EdgeConcentration& concentration) {
    // Shear lag leaves less to bend, and raises every stress of bending alike.
    const SectionProperties whole = properties_of(field_.section, field_.holes);
    for (HoleEdge& edge : edges) {
      edge.influence.normal[cut_force::M_y] *= whole.I_y / net_.I_y;
      edge.influence.normal[cut_force::M_z] *= whole.I_z / net_.I_z;
    }
    SectionPoint edge{name, edges.front().y, edges.front().z, {}, {}, {}, {}};
    edge.plate = wall_at(field_.section, edge.z);
    edge.influence = edge.prismatic = edges.front().influence;
    StressPoint& point = add(edge);
    point.influence = edges.front().influence;  // of the gross section, as its source has it
    resist(point, detail);
    point.concentration = concentration;
    point.edges = std::move(edges);
  }

  /// Stops where a stress is not known.
  void stop_where(const std::optional<std::string>& unknown) const {
    if (!unknown) return;
    const Segment& segment = project_->beam.segments[segment_at(project_->beam, station_)];
    throw AnalysisError({*unknown, "segment " + segment.name, {}, {}, {}});
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
    point.prismatic = place.prismatic;
    point.torsion = place.torsion;
    point.lag = lags_.flanges;
    point.web_lag = lags_.webs;
    point.influence = influence_in(point, place);
    point.plate = place.plate;
    point.yield_strength = yield_strength_of(project_->material, point.plate).value();
    return points.emplace_back(std::move(point));
  }

  const Project* project_;
  Station station_;
  Taper taper_;
  PointSet set_;
  StressField field_;
  SectionProperties gross_, net_;
  ShearLags lags_;
};

}  // namespace

StressInfluence influence_in(const StressPoint& point, const SectionPoint& place) {
  StressInfluence influence = place.influence;
  if (point.lag || point.web_lag) {
    influence.normal =
        normal_influence(sums_of(point.net), place.y.value(), place.z.value()).normal;
  }
  return influence;
}

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

}  // namespace boxbeam
