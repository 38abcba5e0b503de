#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frame_reader.hpp"
#include "front_end_reader.hpp"

namespace boxbeam::readers {
namespace {

/// The parts of mechanisms, with what to write instead.
void refuse_moving_parts(TableReader& root) {
  for (const auto& [key, hint] :
       {std::pair{"mechanism", "gravity is a key of [frame]"},
        {"bodies", "what is not verified are [members.<name>]"},
        {"links", "what is not verified are [members.<name>]"},
        {"drivers", "nothing moves; for a beam on a machine write kind = \"planar\""},
        {"forces", "write [loads.<name>]"}}) {
    if (!root.has_misplaced(key)) continue;
    root.problem(key, fmt::format("\"{}\" is not known of frames at rest", key), hint);
  }
}

/// Points of the beam, and where supports and joints hold it, named on its axis.
void add_places(Project& project, const frame::Structure& structure) {
  const auto add = [&](const std::string& name, double at) {
    const Length s = place_near(places_of(project.beam), si<Length>(at));
    const bool known = std::any_of(project.beam.points.begin(), project.beam.points.end(),
                                   [&](const BeamPoint& other) { return other.s == s; });
    if (!known) project.beam.points.push_back({name, s});
  };
  for (const frame::MemberPoint& point : structure.members.front().points) {
    if (point.name != "start" && point.name != "end") add(point.name, point.p.x());
  }
  for (const frame::Joint& joint : structure.joints) {
    for (const frame::Place* at : {&joint.a, &joint.b}) {
      if (at->member == 0) add(joint.name, at->p.x());
    }
  }
}

class FrameReader : public FrontEndReader {
 public:
  using FrontEndReader::FrontEndReader;

  void read(TableReader& root, const Node&) override {
    read_model(root, *project_);
    frame::Structure structure = structure_of(root);
    refuse_moving_parts(root);
    refuse_planar_parts(root, *project_, structure.plane);
    project_->in_space = !structure.plane;
    project_->beam_body = 0;
    if (root.problems().empty()) add_places(*project_, structure);
    structure.members.front().beam = project_->beam;
    project_->mechanism = std::move(structure);
  }

  Changeable changeable() const override {
    static constexpr std::array parts{"frame", "members", "supports", "joints", "loads", "motion"};
    return {parts, "loads.lift.force", "beam"};
  }

  AnyMechanism changed_mechanism(TableReader& root) const override {
    return with_parts(root, beam_);
  }

  void read_loads(TableReader& table, Situation& situation) const override {
    if (!table.has("loads")) {
      table.problem("loads", "which load cases act in the situation is not said",
                    "write how often each counts: loads = { weight = 1.0, lift = 1.2 }");
      return;
    }
    frame::Structure structure =
        situation.changed ? std::get<frame::Structure>(*situation.changed) : frame_of(*project_);
    structure.factors = read_case_factors(table, structure);
    for (std::size_t k = 0; k < structure.cases.size(); ++k) {
      if (structure.factors[k] != 0.0)
        situation.set.push_back(
            fmt::format("{:.5g} {}", structure.factors[k], structure.cases[k].name));
    }
    situation.changed = std::move(structure);
  }

  void read_neighbours(TableReader& root) override {
    if (!root.has("deflection")) return;
    project_->deflection =
        read_deflection(root.table({"deflection", "how far the beam may bend"}), *project_);
  }

  std::vector<Situation> read_combinations(TableReader& root) const override {
    return readers::read_combinations(root, frame_of(*project_));
  }

 private:
  /// The frame with the verified beam as its first member.
  frame::Structure structure_of(TableReader& root) {
    frame::Structure structure;
    read_frame(root, structure);
    TableReader table = root.table({"beam", "the verified beam"});
    read_beam(table, *sections_, *project_);
    frame::Member& beam = structure.members.emplace_back();
    beam.name = "beam";
    beam.beam = project_->beam;
    beam.youngs_modulus = project_->model.youngs_modulus;
    beam.shear_modulus = project_->model.shear_modulus;
    read_member_place(table, structure, beam);
    table.finish();
    beam_ = beam;
    return with_rest(root, std::move(structure));
  }

  /// The same with what a situation changes.
  frame::Structure with_parts(TableReader& root, const frame::Member& beam) const {
    frame::Structure structure;
    read_frame(root, structure);
    structure.members.push_back(beam);
    structure.members.front().beam = project_->beam;
    return with_rest(root, std::move(structure));
  }

  frame::Structure with_rest(TableReader& root, frame::Structure structure) const {
    read_members(root, {sections_, project_}, structure);
    if (!root.problems().empty()) {  // where members are is not known
      for (const char* key : {"supports", "joints", "loads", "motion"}) {
        if (root.has(key)) root.table(key).accept_all();
      }
      return structure;
    }
    read_frame_joints(root, structure);
    read_frame_loads(root, structure, *tables_);
    return structure;
  }

  frame::Member beam_;
};

}  // namespace

std::unique_ptr<FrontEndReader> reader_for(const frame::Structure&, const Sections& sections,
                                           TimeTables& tables, Project& project) {
  return std::make_unique<FrameReader>(sections, tables, project);
}

}  // namespace boxbeam::readers
