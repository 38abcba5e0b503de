#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/mechanism/planar/creep.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "front_end_reader.hpp"
#include "several_beams.hpp"

namespace boxbeam::readers {
namespace {

/// Whether a joint pushes a body: with a force, not with a moment alone.
bool acts_on(const planar::Joint& joint, int body) {
  const auto [a, b] = planar::ends_of(joint);
  if (a.body != body && b.body != body) return false;
  for (int row = 0; row < planar::equations_of(joint); ++row) {
    if (planar::is_length_equation(joint, row)) return true;
  }
  return false;
}

EquivalentMassDemand read_equivalent_mass(TableReader table, const planar::Mechanism& mechanism,
                                          int beam_body) {
  EquivalentMassDemand demand;
  demand.joint = joint_of(table, {"joint", "whose mass is felt"}, mechanism);
  demand.on = body_of(table, {"on", "the body that feels it"}, mechanism);
  demand.adjust = body_of(table, {"adjust", "the body whose mass is adjusted"}, mechanism);
  demand.wanted = si<Mass>(table.positive({"wanted", "the equivalent mass wanted"}, wanted::mass));
  table.finish();
  if (demand.adjust >= 0 && demand.adjust == beam_body) {
    table.problem("adjust", "the mass of the beam comes from its sections and cannot be adjusted",
                  "name another body");
  }
  if (demand.joint >= 0 && demand.on >= 0 &&
      !acts_on(mechanism.joints[static_cast<std::size_t>(demand.joint)], demand.on)) {
    table.problem("on",
                  fmt::format("joint \"{}\" does not push body \"{}\"", table.text("joint"),
                              table.text("on")),
                  "name a body that the joint connects");
  }
  return demand;
}

/// Where a point of a body is written.
Place place_of_point(const Node& root, const std::string& body, const std::string& point) {
  return root.find("bodies")->find(body)->find("points")->find(point)->place;
}

/// The beam body's points, named on the axis.
void add_points_of_body(const Node& root, ProblemList& problems, Project& project) {
  if (project.beam_body == planar::ground) return;
  const Body& body = planar_of(project).bodies[static_cast<std::size_t>(project.beam_body)];
  const double centre = mass_properties_of(project.beam).centre.value();
  const double length = project.beam.length().value();
  for (const BodyPoint& point : body.points) {
    const double s = centre + point.p.x();
    if (s < -1e-9 * length || s > (1.0 + 1e-9) * length) {
      problems.add(place_of_point(root, body.name, point.name),
                   fmt::format("point \"{}\" of the beam body lies off the beam, at s = {:.6g} m",
                               point.name, s),
                   fmt::format("s goes from 0 to {:.6g} m", length));
      continue;
    }
    project.beam.points.push_back({point.name, place_near(places_of(project.beam), si<Length>(s))});
  }
}

/// The joints with dry friction of which a case gives no creep velocity.
std::vector<int> without_creep(const TableReader& root, const planar::Mechanism& mechanism) {
  std::vector<int> found;
  const Node* const joints = root.peek("joints");
  if (joints == nullptr) return found;
  for (const planar::FrictionContact& contact : planar::friction_contacts_of(mechanism)) {
    if (contact.law.coulomb == 0.0) continue;
    const Node* at = joints->find(mechanism.joints[static_cast<std::size_t>(contact.joint)].name);
    if (at != nullptr) at = at->find("friction");
    if (at != nullptr && at->find("creep") == nullptr) found.push_back(contact.joint);
  }
  return found;
}

class PlanarReader : public FrontEndReader {
 public:
  using FrontEndReader::FrontEndReader;

  void read(TableReader& root, const Node& tree) override {
    read_model(root, *project_);
    TableReader beam = beam_table(root, *project_);
    read_beam(beam, *sections_, *project_);
    const Key body{"body", "the body that is the beam; its mass comes from the sections"};
    beam_body_ = beam.text(body, "");
    others_ = read_other_beams(root, body, *sections_, *project_);
    if (!beam_body_.empty() && index_by_body(beam_body_) < others_.size()) {
      beam.problem("body", fmt::format("two beams are the body \"{}\"", beam_body_),
                   "a body is one beam; join a second body to it by kind = \"rigid\"");
    }
    MechanismDraft draft = read_mechanism(root, names_of_beams(beam_body_, others_), *tables_);
    if (!beam_body_.empty() || !root.has("beam")) {
      // A missing table or unknown name has been noted; any body stands in, so that reading goes
      // on.
      project_->beam_body = std::max(0, body_of(beam, "body", draft.mechanism));
    }
    beam.finish();
    if (root.problems().empty()) {
      elastic_joints_ = draft.elastic;
      project_->mechanism = placed(root, std::move(draft), project_->beam_body);
      for (const OtherBeam& other : others_) {
        const int of = body_index(planar_of(*project_), other.on);
        if (of >= 0) project_->elastic_beside.push_back({other.on, WholeBody{of}, other.beam});
      }
      for (const planar::ElasticJoint& of : elastic_joints_) {
        const auto joint = static_cast<std::size_t>(of.joint);
        project_->elastic_beside.push_back({planar_of(*project_).joints[joint].name, of, {}});
      }
      add_points_of_body(tree, root.problems(), *project_);
    } else {
      project_->mechanism = std::move(draft.mechanism);
    }
    if (root.has("newton_chain")) {
      project_->chain = read_newton_chain(
          root.table(
              {"newton_chain", "the published chain of bodies, for its loads and for comparison"}),
          planar_of(*project_), project_->beam, project_->beam_body);
    }
    if (root.has("equivalent_mass")) {
      project_->equivalent_mass = read_equivalent_mass(
          root.table({"equivalent_mass", "the mass that the mechanism feels like at a joint"}),
          planar_of(*project_), project_->beam_body);
    }
  }

  Changeable changeable() const override { return changeable_of_bodies(beam_body_); }

  AnyMechanism changed_mechanism(TableReader& root) const override {
    MechanismDraft draft = read_mechanism(root, names_of_beams(beam_body_, others_), *tables_);
    refuse_other_joints(root, draft.elastic != elastic_joints_);
    if (!root.problems().empty()) return project_->mechanism;
    return placed(root, std::move(draft), project_->beam_body);
  }

  void read_neighbours(TableReader& root) override {
    readers::read_neighbours(root, *sections_, *project_);
    if (!root.problems().empty()) return;
    for (const RodInput& rod : project_->rods) add_elastic(rod);
  }

 private:
  /// A rod by its section, but for a spring or a joint that has a stiffness of its own, and one
  /// that is a part of a beam.
  void add_elastic(const RodInput& rod) {
    ElasticBeside of;
    of.name = rod.name;
    if (const auto* const link = std::get_if<RodLink>(&rod.place)) {
      const auto has_own = [&](const planar::ElasticJoint& joint) {
        return joint.joint == static_cast<int>(link->index);
      };
      if (link->spring || std::any_of(elastic_joints_.begin(), elastic_joints_.end(), has_own))
        return;
      of.place = *link;
    } else {
      const auto& ends = std::get<PlanarRod>(rod.place);
      if (ends.from.body == project_->beam_body) return;
      for (const ElasticBeside& other : project_->elastic_beside) {
        const auto* const beam = std::get_if<WholeBody>(&other.place);
        if (beam != nullptr && beam->body == ends.from.body) return;
      }
      of.place = ends;
    }
    of.beam.segments = {{"", Length{}, rod.length, rod.section, rod.section}};
    project_->elastic_beside.push_back(std::move(of));
  }

  std::size_t index_by_body(const std::string& name) const {
    return static_cast<std::size_t>(
        std::find_if(others_.begin(), others_.end(),
                     [&](const OtherBeam& other) { return other.on == name; }) -
        others_.begin());
  }

  planar::Mechanism placed(const TableReader& root, MechanismDraft draft, int beam_body) const {
    give_mass(draft, project_->beam, beam_body);
    for (const OtherBeam& other : others_) {
      const int body = body_index(draft.mechanism, other.on);
      if (body >= 0) give_mass(draft, other.beam, body);
    }
    planar::Mechanism mechanism = place_at_centres(std::move(draft));
    planar::fit_creep(mechanism, without_creep(root, mechanism));
    return mechanism;
  }

  std::string beam_body_;
  std::vector<OtherBeam> others_;
  std::vector<planar::ElasticJoint> elastic_joints_;
};

}  // namespace

std::unique_ptr<FrontEndReader> reader_for(const planar::Mechanism&, const Sections& sections,
                                           TimeTables& tables, Project& project) {
  return std::make_unique<PlanarReader>(sections, tables, project);
}

}  // namespace boxbeam::readers
