#include "boxbeam/verification/stress_points.hpp"

#include <algorithm>
#include <deque>
#include <span>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/path_webs.hpp"
#include "boxbeam/section/plate_force.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "details_at.hpp"

namespace boxbeam {
namespace {

DetailPlace place_of(SectionPart part) {
  switch (part) {
    case SectionPart::fibre: return DetailPlace::fibres;
    case SectionPart::web: return DetailPlace::webs;
    case SectionPart::web_end: return DetailPlace::seams;
  }
  return DetailPlace::section;
}

/// Details of one station, each looked up once per plate.
class DetailsAtStation {
 public:
  DetailsAtStation(const FatigueInput& fatigue, const Station& station)
      : fatigue_(&fatigue), station_(station) {}

  const std::vector<ResistingDetail>& at(const PlaceOfDetails& place, Length plate) {
    for (const Found& found : found_) {
      if (found.place == place && found.plate == plate) return found.details;
    }
    found_.push_back({place, plate, details_at(*fatigue_, station_, place, plate)});
    return found_.back().details;
  }

 private:
  struct Found {
    PlaceOfDetails place;
    Length plate;
    std::vector<ResistingDetail> details;
  };
  const FatigueInput* fatigue_;
  Station station_;
  std::deque<Found> found_;  // references to its members stay
};

/// The points of one station as they are gathered.
class StressPoints {
 public:
  StressPoints(const Project& project, const std::vector<BendingZone>& zones,
               const Station& station, StressFields& fields)
      : project_(&project),
        station_(station),
        details_(project.fatigue, station),
        materials_(materials_of(project, segment_at(project.beam, station))),
        taper_(taper_at(project.beam, station)),
        set_(project.in_space ? PointSet::in_space : PointSet::in_plane),
        fields_(&fields),
        shared_field_(fields.of(judged_section_at(project, station),
                                holes_in_section(project, station), taper_)),
        field_(*shared_field_),
        gross_(properties_of(field_.section)),
        net_(properties_of(field_.section, field_.holes)),
        lags_(shear_lags_at(zones, section_inside(project.beam, station), station)) {
    // Points are large, and growing would copy them.
    constexpr std::size_t usual = 32;
    points.reserve(usual);
    find_webs();
    if (lags_.count()) net_ = effective_properties_of(field_.section, field_.holes, lags_);
    if (set_ == PointSet::in_space) stop_where(unknown_shear_of(field_.section));
  }

  void add_section() {
    const FatigueInput& fatigue = project_->fatigue;
    const bool walls = std::holds_alternative<ThinWalled>(field_.section.outer);
    const bool space = set_ == PointSet::in_space;
    for (const SectionPoint& place : points_of(field_, set_)) {
      // In space nothing is neutral.
      const bool neutral = !space && !walls && place.neutral;
      StressPoint& point = add(place);
      if (!neutral) resist(point);
      point.shear_detail = if_asked(fatigue.shear);
      if (place.throat) add_throat(place);
    }
    add_stretches();
    for (const AttachmentWeld& weld : fatigue.attachments) {
      if (weld.flat && lies_in(weld.detail, station_.s)) add_flat(weld);
    }
  }

  /// On the plate, outside of it, in the section on either side of where it ends.
  void add_flat(const AttachmentWeld& weld) {
    const auto& [name, plate, from, to] = *weld.flat;
    const BeamDetail& along = weld.detail;
    const bool ends = along.from == along.to;
    // Where it runs up to a border, it is there on one side.
    const bool at_tip = station_.side == Side::both && station_.s == project_->beam.length();
    if (!ends && !at_tip && !goes_on(along, station_)) return;
    if (!std::holds_alternative<Box>(field_.section.outer)) return;
    const Length at =
        ends ? from : from + (station_.s - along.from) / (along.to - along.from) * (to - from);
    const bool left = plate == BoxPlate::left_web;
    std::vector<SectionPoint> places;
    if (!left && plate != BoxPlate::right_web) {
      const double up = plate == BoxPlate::top_flange ? 1.0 : -1.0;
      places = {point_on_flange(field_, name, at, up)};
    } else if (at > clear_bottom_of(field_.section.outer) &&
               at < clear_top_of(field_.section.outer)) {
      places = points_at_level(field_, name, at, PointSet::in_space);
      if (places.size() == 2) places.erase(left ? places.begin() + 1 : places.begin());
    }
    for (SectionPoint& place : places) {
      place.name = name;
      StressPoint& point = add(place);
      const DetailPlace on =
          place.part == SectionPart::web ? DetailPlace::webs : DetailPlace::fibres;
      take(details_at(project_->fatigue, station_, {on, false}, point.plate, &along), point);
      point.shear_detail = if_asked(project_->fatigue.shear);
    }
  }

  void add_throats() {
    for (const SectionPoint& place : points_of(field_, set_)) {
      const bool inner = place.throat && place.throat->name.starts_with("inner");
      if (place.throat && !inner) add_throat(place);
    }
  }

  void add_throat(SectionPoint place) {
    place.name = place.throat->name;
    place.influence = place.throat->influence;
    StressPoint& on_throat = add(place);
    // No stress along the weld counts in it.
    on_throat.influence.normal = {};
    on_throat.shear_detail = if_asked(project_->fatigue.throat);
    on_throat.on_throat = true;
    on_throat.joined = weakest_to_weld(plates_here(place.y, place.z));
    on_throat.yield = false;
  }

  void add_stretches() {
    // Beside a hole in a solid its edge and the points beside it are looked at.
    if (!field_.flow && !field_.holes.empty()) return;
    const bool mirrored = set_ == PointSet::in_plane && is_mirrored(field_);
    for (const WallStretch& stretch : wall_stretches_of(field_)) {
      bool only_end = false;
      if (mirrored && !stretch.round) {
        if (stretch.solid && !stretch.left_side) continue;
        if (!stretch.solid) {
          const Wall& wall = field_.flow->at.graph.walls[stretch.wall];
          const bool right = wall.part == WallPart::right_web ||
                             (wall.part == WallPart::corner && wall.centre.x() < 0.0);
          if (right) continue;
          only_end = wall.part == WallPart::top_flange || wall.part == WallPart::bottom_flange;
        }
      }
      StressPoint& point = add(point_on_stretch(field_, stretch, 0.0));
      if (webs_.empty()) {
        resist(point);
      } else {
        const SectionPoint inside = point_on_stretch(field_, stretch, 0.5);
        resist(point, inside.y, inside.z);
      }
      point.shear_detail = if_asked(project_->fatigue.shear);
      point.stretch = StressStretch{shared_field_, stretch, only_end};
      // Its ends, where it touches other plates, are points of their own.
      if (project_->part_materials.empty()) continue;
      const SectionPoint middle = point_on_stretch(field_, stretch, 0.5);
      set_yield(point, first_to_yield(plates_here(middle.y, middle.z)));
    }
  }

  void add_hole(const CutHole& at) {
    const Hole& hole = at.hole;
    const bool webs = hole.walls == HoleWalls::webs;
    if (at.concentration) {
      const HoleCase hole_case = *at.concentration;
      const double a =
          hole.diameter / plate_width_of(field_.section, field_.holes, hole, hole_case);
      const double factor = hole_case == HoleCase::published_exponential
                                ? published_concentration(a)
                                : membrane_concentration(a) / (1.0 - a);
      const EdgeConcentration concentration{hole.name, a, factor, edge_basis_of(hole, hole_case)};
      // The webs of a box that is no mirror image of itself are stressed unlike in the plane too.
      const bool unlike = !is_mirrored(field_) && hole_case != HoleCase::published_exponential &&
                          !unknown_hole_stress_of(field_.section, hole_case);
      if (set_ == PointSet::in_space || unlike) {
        stop_where(unknown_hole_stress_of(field_.section, hole_case));
        std::vector<HoleInWall> walls =
            holes_in_walls_of(field_.section, field_.holes, taper_, hole);
        if (!taper_.empty()) {
          std::vector<HoleInWall> prismatic =
              holes_in_walls_of(field_.section, field_.holes, {}, hole);
          for (std::size_t i = 0; i < walls.size(); ++i) append(walls[i].edges, prismatic[i].edges);
        }
        for (HoleInWall& wall : walls) {
          add_edge("hole " + hole.name + " edge " + wall.side, std::move(wall.edges), webs,
                   wall.plate, at, concentration);
        }
      } else {
        std::vector<HoleEdge> edges =
            hole_edges_of(field_.section, field_.holes, taper_, hole, hole_case);
        // How much of the shear the inclined flanges carry near a hole, often at a kink of the
        // taper and under a force, is not certain: the worse of both shears counts.
        if (!taper_.empty())
          append(edges, hole_edges_of(field_.section, field_.holes, {}, hole, hole_case));
        const Length plate = wall_at(field_.section, edges.front().z);
        // Flanges of different thickness resist each on its own.
        const auto other = std::stable_partition(
            edges.begin(), edges.end(),
            [&](const HoleEdge& edge) { return wall_at(field_.section, edge.z) == plate; });
        std::vector<HoleEdge> below(other, edges.end());
        edges.erase(other, edges.end());
        const std::string name = "hole " + hole.name + " edge";
        add_edge(name + (below.empty() ? "" : " +z"), std::move(edges), webs, plate, at,
                 concentration);
        if (!below.empty()) {
          const Length lower = wall_at(field_.section, below.front().z);
          add_edge(name + " -z", std::move(below), webs, lower, at, concentration);
        }
      }
    }
    // Where a hole has taken the neutral fibre, the shear is largest just beside the hole; a
    // category for the net section is judged by the nominal stress there.
    for (const double sign : {1.0, -1.0}) {
      const Length z = webs ? hole.position + sign * 0.5 * hole.diameter
                            : (sign > 0.0 ? gross_.z_top : gross_.z_bottom);
      if (!webs && at.concentration) continue;
      const std::string name = "beside hole " + hole.name + (sign > 0.0 ? " +z" : " -z");
      for (StressPoint& point : add_level(name, z)) {
        if (!at.concentration) resist_hole(point, at);
      }
    }
    add_strips(at);
    add_posts(at);
  }

  /// What goes along the beam from hole to hole in a row, at each of its plates.
  void add_posts(const CutHole& at) {
    double raised = 1.0;
    for (const HolePost& post : posts_beside(*project_, *at.of))
      raised = std::max(raised, post.shear_raised());
    if (raised == 1.0) return;
    const auto whole = fields_->of(field_.section, {}, taper_);
    for (SectionPoint& place : posts_at(*whole, at.hole, set_)) {
      for (StressInfluence* of : {&place.influence, &place.prismatic}) {
        for (double& each : of->shear) each *= raised;
        of->normal = normal_influence(sums_of(net_), place.y.value(), place.z.value()).normal;
      }
      place.torsion.reset();
      StressPoint& point = add(place);
      point.is_strip = true;
      point.shear_detail = if_asked(project_->fatigue.shear);
    }
  }

  /// The flow beside a hole is that of one section, which the hole passes on. What the plate
  /// carries as a whole before and behind it, goes through the strips.
  void add_strips(const CutHole& at) {
    const auto whole = fields_->of(field_.section, {}, taper_);
    for (const PlateStrip& strip : strips_beside(field_, *whole, at.hole, set_)) {
      StressPoint& point = add(strip.point);
      point.is_strip = true;
      point.shear_detail = if_asked(project_->fatigue.shear);
      if (!at.concentration) resist_hole(point, at);
    }
  }

  /// The points at a level, whose direct stress is not judged yet.
  std::span<StressPoint> add_level(const std::string& name, Length z) {
    const std::size_t before = points.size();
    for (const SectionPoint& place : points_at_level(field_, name, z, set_))
      add(place).shear_detail = if_asked(project_->fatigue.shear);
    return std::span(points).subspan(before);
  }

  void add_named(const NamedPoint& named) {
    for (StressPoint& point : add_level(named.name, named.z)) resist(point);
  }

  /// Of places where unlike details lie the same points once more, by each of the others.
  void add_other_details() {
    points.reserve(points.size() + others_.size());
    for (const auto& [number, detail] : others_) {
      StressPoint point = points[number];
      take(detail, point);
      point.yield = false;
      points.push_back(std::move(point));
    }
    others_.clear();
  }

  std::vector<StressPoint> points;

 private:
  /// The plates at a place, and, where the one half is looked at for both, at its mirror image.
  std::vector<PlateOf> plates_here(Length y, Length z) const {
    std::vector<PlateOf> plates = plates_at(materials_, field_.section, y, z);
    if (!project_->part_materials.empty() && set_ == PointSet::in_plane && is_mirrored(field_)) {
      for (PlateOf& of : plates_at(materials_, field_.section, -y, z)) plates.push_back(of);
    }
    return plates;
  }

  /// Of a case that asks for no fatigue nothing resists it.
  void resist(StressPoint& point) { resist(point, point.y, point.z); }

  /// The details of another place of the same wall.
  void resist(StressPoint& point, Length y, Length z) {
    if (!project_->fatigue.asked) return;
    PlaceOfDetails place{place_of(point.part)};
    if (!webs_.empty()) {
      const auto& path = std::get<ThinWalled>(field_.section.outer);
      place = {place_of(part_in(path, webs_, y, z)), true};
    }
    take(details_.at(place, point.plate), point);
  }

  /// The weakest of them; points of the others follow once the places are gathered.
  void take(const std::vector<ResistingDetail>& details, StressPoint& point) {
    take(details.front(), point);
    const auto number = static_cast<std::size_t>(&point - points.data());
    for (std::size_t i = 1; i < details.size(); ++i) others_.emplace_back(number, details[i]);
  }

  static void take(const ResistingDetail& detail, StressPoint& point) {
    point.detail = detail.detail;
    point.in_plate = detail.in_plate;
    point.compression_reduced = detail.compression_reduced;
    point.range_factor = detail.range_factor;
  }

  const Detail* if_asked(const Detail& detail) const {
    return project_->fatigue.asked ? &detail : nullptr;
  }

  /// A hole may have a detail of its own.
  void resist_hole(StressPoint& point, const CutHole& at) {
    const std::optional<BeamDetail>& own = at.of->detail;
    if (!own || !project_->fatigue.asked) return resist(point);
    point.detail = &*own;
    point.compression_reduced = own->detail.compression_reduced;
    point.range_factor = own->stress_factor;
  }

  static void append(std::vector<HoleEdge>& edges, const std::vector<HoleEdge>& others) {
    edges.insert(edges.end(), others.begin(), others.end());
  }

  EdgeBasis edge_basis_of(const Hole& hole, HoleCase hole_case) const {
    EdgeBasis basis;
    basis.hole_case = hole_case;
    basis.in_space = set_ == PointSet::in_space;
    basis.walls = hole.walls;
    basis.diameter = hole.diameter;
    basis.plate_width = plate_width_of(field_.section, field_.holes, hole, hole_case);
    basis.position = hole.position;
    basis.plate = height_of(field_.section.outer);
    basis.gross = gross_;
    basis.net = properties_of(field_.section, field_.holes);
    basis.effective_I = net_.I_y;
    return basis;
  }

  void add_edge(const std::string& name, std::vector<HoleEdge> edges, bool webs, Length plate,
                const CutHole& at, const EdgeConcentration& concentration) {
    // Shear lag leaves less to bend, and raises every stress of bending alike.
    const SectionProperties& whole = concentration.edge.net;
    for (HoleEdge& edge : edges) {
      edge.influence.normal[cut_force::M_y] *= whole.I_y / net_.I_y;
      edge.influence.normal[cut_force::M_z] *= whole.I_z / net_.I_z;
    }
    SectionPoint edge{name, edges.front().y, edges.front().z, {}, {}, {}, {}};
    edge.plate = plate;
    edge.part = webs ? SectionPart::web : SectionPart::fibre;
    edge.influence = edge.prismatic = edges.front().influence;
    StressPoint& point = add(edge);
    point.influence = edges.front().influence;  // of the gross section, as its source has it
    resist_hole(point, at);
    point.concentration = concentration;
    point.edges = std::move(edges);
  }

  void find_webs() {
    const auto* const path = std::get_if<ThinWalled>(&field_.section.outer);
    const std::vector<BeamDetail>& details = project_->fatigue.details;
    const bool wanted = std::any_of(details.begin(), details.end(), [&](const BeamDetail& of) {
      return (of.on == DetailPlace::webs || of.on == DetailPlace::seams) && lies_in(of, station_.s);
    });
    if (path != nullptr && wanted) webs_ = webs_of(*path);
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
    point.part = place.part;
    point.section = field_.section;
    point.gross = gross_;
    point.net = net_;
    point.prismatic = place.prismatic;
    point.torsion = place.torsion;
    point.lag = lags_.flanges;
    point.web_lag = lags_.webs;
    point.influence = influence_in(point, place);
    point.plate = place.plate;
    if (project_->part_materials.empty())
      set_yield(point, {&project_->material, point.plate});
    else
      set_yield(point, first_to_yield(plates_here(place.y, place.z)));
    return points.emplace_back(std::move(point));
  }

  static void set_yield(StressPoint& point, const PlateOf& plate) {
    point.first_to_yield = plate;
    point.yield_strength = yield_strength_of(*plate.material, plate.thickness).value();
  }

  const Project* project_;
  Station station_;
  DetailsAtStation details_;
  PlateMaterials materials_;
  Taper taper_;
  PointSet set_;
  StressFields* fields_;
  std::shared_ptr<const StressField> shared_field_;
  const StressField& field_;  ///< the same
  SectionProperties gross_, net_;
  ShearLags lags_;
  std::vector<std::size_t> webs_;  ///< of a path, where any detail is of webs or seams alone
  std::vector<std::pair<std::size_t, ResistingDetail>> others_;  ///< by the numbers of their points
};

bool are_same(const std::vector<Hole>& some, const std::vector<Hole>& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                    [](const Hole& a, const Hole& b) {
                      const auto& [name, diameter, walls, position] = a;
                      return name == b.name && diameter == b.diameter && walls == b.walls &&
                             position == b.position;
                    });
}

bool are_same(const Taper& some, const Taper& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                    [](const NearbySection& a, const NearbySection& b) {
                      const auto& [section, weight] = a;
                      return section == b.section && weight == b.weight;
                    });
}

}  // namespace

Length seam_throat_of(const StressPoint& point) {
  const auto& box = std::get<Box>(point.section.outer);
  if (box.seam_throat.value() > 0.0) return box.seam_throat;
  return point.y.value() < 0.0 ? box.right_web : box.left_web;
}

StressInfluence influence_in(const StressPoint& point, const SectionPoint& place) {
  StressInfluence influence = place.influence;
  if (point.lag || point.web_lag) {
    influence.normal =
        normal_influence(sums_of(point.net), place.y.value(), place.z.value()).normal;
  }
  return influence;
}

std::shared_ptr<const StressField> StressFields::of(const Section& section,
                                                    const std::vector<Hole>& holes,
                                                    const Taper& taper) {
  const bool kept = keep_ == Keep::all || (taper.empty() && holes.empty());
  if (!kept) return std::make_shared<const StressField>(stress_field_of(section, holes, taper));
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& of) {
    return of.section == section && are_same(of.holes, holes) && are_same(of.taper, taper);
  });
  if (found != known_.end()) return found->field;
  constexpr std::size_t most = 16;
  known_.push_front({section, holes, taper,
                     std::make_shared<const StressField>(stress_field_of(section, holes, taper))});
  if (known_.size() > most) known_.pop_back();
  return known_.front().field;
}

std::vector<StressPoint> stress_points_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station) {
  StressFields fields;
  return stress_points_at(project, zones, station, fields);
}

std::vector<StressPoint> stress_points_at(const Project& project,
                                          const std::vector<BendingZone>& zones,
                                          const Station& station, StressFields& fields) {
  StressPoints gathered(project, zones, station, fields);
  gathered.add_section();
  for (const CutHole& at : holes_cut_at(project, station)) gathered.add_hole(at);
  for (const NamedPoint& named : project.points) {
    if (named.s != station.s) continue;
    gathered.add_named(named);
  }
  gathered.add_other_details();
  return std::move(gathered.points);
}

std::vector<StressPoint> seam_throats_at(const Project& project,
                                         const std::vector<BendingZone>& zones,
                                         const Station& station) {
  StressFields fields;
  StressPoints gathered(project, zones, station, fields);
  gathered.add_throats();
  return std::move(gathered.points);
}

}  // namespace boxbeam
