#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "front_end_reader.hpp"
#include "several_beams.hpp"

namespace boxbeam::readers {
namespace {

/// A place of interest under a place in beam axes, if the beam is there; one of a kind at a place.
void add_point_under(const std::string& name, const Eigen::Vector3d& at, Project& project) {
  const double length = project.beam.length().value();
  if (at.x() < -1e-9 * length || at.x() > (1.0 + 1e-9) * length) return;
  const BeamPoint point{name, place_near(places_of(project.beam), si<Length>(at.x()))};
  const auto same = [&](const BeamPoint& other) {
    return other.name == point.name && other.s == point.s;
  };
  std::vector<BeamPoint>& points = project.beam.points;
  if (std::none_of(points.begin(), points.end(), same)) points.push_back(point);
}

/// The beam's own points in space, projected on its axis, and what loads at points of other bodies
/// that do not move against it stand over.
void add_points_on_axis(Project& project) {
  const spatial::Mechanism& mechanism = spatial_of(project);
  const auto body = static_cast<std::size_t>(project.beam_body);
  for (const spatial::BodyPoint& point : mechanism.bodies[body].points) {
    add_point_under(point.name, in_beam(project.placement, point.p), project);
  }
  for (const spatial::AppliedLoad& load : mechanism.loads) {
    if (load.on != project.beam_body || load.at.body == project.beam_body) continue;
    for (const spatial::LastingPlace& place : lasting_places_of(mechanism, project.placement)) {
      if (place.name == load.name) add_point_under(place.name, place.at, project);
    }
  }
}

class SpatialReader : public FrontEndReader {
 public:
  using FrontEndReader::FrontEndReader;

  void read(TableReader& root, const Node&) override {
    read_model(root, *project_);
    project_->in_space = true;
    TableReader beam = beam_table(root, *project_);
    read_beam(beam, *sections_, *project_);
    const Key body{"body", "the body that is the beam; its mass comes from the sections"};
    beam_body_ = beam.text(body, "");
    others_ = read_other_beams(root, body, *sections_, *project_);
    ChainDraft chain = read_chain(root, names_of_beams(beam_body_, others_), *tables_);
    giving_way_ = std::move(chain.giving_way);
    spatial::Mechanism& mechanism = chain.mechanism;
    project_->beam_body = std::max(0, body_of(beam, "body", mechanism));
    if (root.problems().empty()) {
      project_->placement = read_placement(beam, mechanism, project_->beam_body);
    } else {
      for (const char* key : {"start", "axis", "z"}) static_cast<void>(beam.has(key));
    }
    beam.finish();
    refuse_planar_parts(root, *project_, {.deflection = true, .neighbours = true, .loops = true});
    if (root.problems().empty()) {
      project_->elastic_beside = place_others(root, mechanism);
      for (const NamedElasticJoint& joint : giving_way_)
        project_->elastic_beside.push_back({joint.name, joint.of, {}});
      place_beam(root, project_->beam, project_->placement, mechanism);
      project_->hand_formulas = read_hand_formulas(root, mechanism);
    } else {
      for (const char* key : {"hand_formulas", "hand_symbols"}) static_cast<void>(root.has(key));
    }
    project_->mechanism = std::move(mechanism);
    if (root.problems().empty()) add_points_on_axis(*project_);
  }

  Changeable changeable() const override { return changeable_of_bodies(beam_body_); }

  AnyMechanism changed_mechanism(TableReader& root) const override {
    ChainDraft chain = read_chain(root, names_of_beams(beam_body_, others_), *tables_);
    refuse_other_joints(root, chain.giving_way != giving_way_);
    if (!root.problems().empty()) return project_->mechanism;
    spatial::Mechanism& mechanism = chain.mechanism;
    spatial::BeamPlacement placement = project_->placement;
    placement.body = body_index(mechanism, beam_body_);
    static_cast<void>(place_others(root, mechanism));
    place_beam(root, project_->beam, placement, mechanism);
    return AnyMechanism(std::move(mechanism));
  }

  void read_neighbours(TableReader& root) override {
    const auto directions = readers::read_neighbours(root, *sections_, *project_);
    if (!root.problems().empty()) return;
    for (std::size_t i = 0; i < directions.size(); ++i)
      add_elastic_rod(project_->rods[i], directions[i]);
  }

 private:
  /// A rod by its section, but for a spring or a joint that has a stiffness of its own, and one
  /// that is a part of a beam.
  void add_elastic_rod(const RodInput& rod, const std::optional<Eigen::Vector3d>& z) {
    const spatial::Mechanism& mechanism = spatial_of(*project_);
    ElasticBeside of;
    of.name = rod.name;
    if (const auto* const link = std::get_if<RodLink>(&rod.place)) {
      if (link->spring) return;
      const std::string& joint = mechanism.closing[link->index].name;
      if (std::any_of(giving_way_.begin(), giving_way_.end(),
                      [&](const NamedElasticJoint& own) { return own.name == joint; }))
        return;
      of.place = *link;
    } else {
      const auto& ends = std::get<SpatialRod>(rod.place);
      const std::string& body = mechanism.bodies[static_cast<std::size_t>(ends.from.body)].name;
      if (body == beam_body_ ||
          std::any_of(others_.begin(), others_.end(),
                      [&](const OtherBeam& other) { return other.on == body; }))
        return;
      RodBody place{{ends.from.body, ends.from.p, {}}, z.has_value()};
      const Eigen::Vector3d along = (ends.to.p - ends.from.p).normalized();
      const Eigen::Vector3d across = z ? *z : along.unitOrthogonal();
      place.placement.axes.col(0) = along;
      place.placement.axes.col(1) = across.cross(along).normalized();
      place.placement.axes.col(2) = along.cross(place.placement.axes.col(1));
      of.place = place;
    }
    of.beam.segments = {{"", Length{}, rod.length, rod.section, rod.section}};
    project_->elastic_beside.push_back(std::move(of));
  }

  /// Gives the other beams' bodies their mass; where they lie.
  std::vector<ElasticBeside> place_others(TableReader& root, spatial::Mechanism& mechanism) const {
    std::vector<ElasticBeside> beside;
    std::size_t next = 0;
    for (const OtherBeam& other : others_) {
      if (next == project_->beam_index) ++next;
      TableReader table = root.one_of_tables("beam", next++);
      const int body = body_index(mechanism, other.on);
      if (other.on == beam_body_) {
        table.problem("body", fmt::format("two beams are the body \"{}\"", beam_body_),
                      "a body is one beam; join a second body to it by kind = \"fixed\"");
      }
      if (body < 0 || !root.problems().empty()) continue;
      const spatial::BeamPlacement placement = read_placement(table, mechanism, body);
      if (!root.problems().empty()) continue;
      place_beam(root, other.beam, placement, mechanism);
      beside.push_back({other.on, WholeBody{body, placement}, other.beam});
    }
    return beside;
  }

  std::string beam_body_;
  std::vector<OtherBeam> others_;
  std::vector<NamedElasticJoint> giving_way_;
};

}  // namespace

std::unique_ptr<FrontEndReader> reader_for(const spatial::Mechanism&, const Sections& sections,
                                           TimeTables& tables, Project& project) {
  return std::make_unique<SpatialReader>(sections, tables, project);
}

}  // namespace boxbeam::readers
