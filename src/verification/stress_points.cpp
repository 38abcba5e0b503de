#include "boxbeam/verification/stress_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/path_webs.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "gathered_points.hpp"

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

GatheredPoints::GatheredPoints(const Project& project, const std::vector<BendingZone>& zones,
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

void GatheredPoints::add_section() {
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
  add_feet();
  for (const AttachmentWeld& weld : fatigue.attachments) {
    if (weld.flat && lies_in(weld.detail, station_.s)) add_flat(weld);
  }
}

void GatheredPoints::add_feet() {
  const auto* const box = std::get_if<Box>(&field_.section.outer);
  if (box == nullptr || project_->part_materials.empty()) return;
  int number = 0;
  for (const Stiffener& bar : box->stiffeners) {
    ++number;
    const PlateOf flat{&materials_.of(PlateKind::stiffener), bar.thickness};
    const bool left = bar.plate == BoxPlate::left_web;
    const std::string name = fmt::format("stiffener {} foot", number);
    // On the outer face of its plate, on the safe side.
    std::vector<SectionPoint> places;
    if (!left && bar.plate != BoxPlate::right_web) {
      places = {
          point_on_flange(field_, name, bar.place, bar.plate == BoxPlate::top_flange ? 1.0 : -1.0)};
    } else {
      places = points_at_level(field_, name, bar.place, PointSet::in_space);
      if (places.size() == 2) places.erase(left ? places.begin() + 1 : places.begin());
    }
    for (SectionPoint& place : places) {
      place.name = name;
      const PlateOf plate = first_to_yield(plates_here(place.y, place.z));
      if (yield_strength_of(*flat.material, flat.thickness) >=
          yield_strength_of(*plate.material, plate.thickness))
        continue;
      StressPoint& point = add(place);
      resist(point);
      set_yield(point, flat);
    }
  }
}

void GatheredPoints::add_flat(const AttachmentWeld& weld) {
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
    const DetailPlace on = place.part == SectionPart::web ? DetailPlace::webs : DetailPlace::fibres;
    take(details_at(project_->fatigue, station_, {on, false}, point.plate, &along), point);
    point.shear_detail = if_asked(project_->fatigue.shear);
  }
}

void GatheredPoints::add_throats() {
  for (const SectionPoint& place : points_of(field_, set_)) {
    const bool inner = place.throat && place.throat->name.starts_with("inner");
    if (place.throat && !inner) add_throat(place);
  }
}

void GatheredPoints::add_throat(SectionPoint place) {
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

void GatheredPoints::add_stretches() {
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

std::span<StressPoint> GatheredPoints::add_level(const std::string& name, Length z) {
  const std::size_t before = points.size();
  for (const SectionPoint& place : points_at_level(field_, name, z, set_))
    add(place).shear_detail = if_asked(project_->fatigue.shear);
  return std::span(points).subspan(before);
}

void GatheredPoints::add_named(const NamedPoint& named) {
  for (StressPoint& point : add_level(named.name, named.z)) resist(point);
}

void GatheredPoints::add_other_details() {
  points.reserve(points.size() + others_.size());
  for (const auto& [number, detail] : others_) {
    StressPoint point = points[number];
    take(detail, point);
    point.yield = false;
    points.push_back(std::move(point));
  }
  others_.clear();
}

std::vector<PlateOf> GatheredPoints::plates_here(Length y, Length z) const {
  std::vector<PlateOf> plates = plates_at(materials_, field_.section, y, z);
  if (!project_->part_materials.empty() && set_ == PointSet::in_plane && is_mirrored(field_)) {
    for (PlateOf& of : plates_at(materials_, field_.section, -y, z)) plates.push_back(of);
  }
  return plates;
}

void GatheredPoints::resist(StressPoint& point) { resist(point, point.y, point.z); }

void GatheredPoints::resist(StressPoint& point, Length y, Length z) {
  if (!project_->fatigue.asked) return;
  PlaceOfDetails place{place_of(point.part)};
  if (!webs_.empty()) {
    const auto& path = std::get<ThinWalled>(field_.section.outer);
    place = {place_of(part_in(path, webs_, y, z)), true};
  }
  take(details_.at(place, point.plate), point);
}

void GatheredPoints::take(const std::vector<ResistingDetail>& details, StressPoint& point) {
  take(details.front(), point);
  const auto number = static_cast<std::size_t>(&point - points.data());
  for (std::size_t i = 1; i < details.size(); ++i) others_.emplace_back(number, details[i]);
}

void GatheredPoints::take(const ResistingDetail& detail, StressPoint& point) {
  point.detail = detail.detail;
  point.in_plate = detail.in_plate;
  point.compression_reduced = detail.compression_reduced;
  point.range_factor = detail.range_factor;
}

const Detail* GatheredPoints::if_asked(const Detail& detail) const {
  return project_->fatigue.asked ? &detail : nullptr;
}

void GatheredPoints::find_webs() {
  const auto* const path = std::get_if<ThinWalled>(&field_.section.outer);
  const std::vector<BeamDetail>& details = project_->fatigue.details;
  const bool wanted = std::any_of(details.begin(), details.end(), [&](const BeamDetail& of) {
    return (of.on == DetailPlace::webs || of.on == DetailPlace::seams) && lies_in(of, station_.s);
  });
  if (path != nullptr && wanted) webs_ = webs_of(*path);
}

void GatheredPoints::stop_where(const std::optional<std::string>& unknown) const {
  if (!unknown) return;
  const Segment& segment = project_->beam.segments[segment_at(project_->beam, station_)];
  throw AnalysisError({*unknown, "segment " + segment.name});
}

StressPoint& GatheredPoints::add(const SectionPoint& place) {
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

void GatheredPoints::set_yield(StressPoint& point, const PlateOf& plate) {
  point.first_to_yield = plate;
  point.yield_strength = yield_strength_of(*plate.material, plate.thickness).value();
}

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
  const auto find = [&] {
    return std::make_shared<const StressField>(stress_field_of(section, holes, taper, prismatic_));
  };
  if (!kept) return find();
  const auto found = std::find_if(known_.begin(), known_.end(), [&](const Known& of) {
    return of.section == section && are_same(of.holes, holes) && are_same(of.taper, taper);
  });
  if (found != known_.end()) return found->field;
  constexpr std::size_t most = 16;
  known_.push_front({section, holes, taper, find()});
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
  GatheredPoints gathered(project, zones, station, fields);
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
  GatheredPoints gathered(project, zones, station, fields);
  gathered.add_throats();
  return std::move(gathered.points);
}

}  // namespace boxbeam
