#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "frame_reader.hpp"
#include "front_end_reader.hpp"
#include "several_beams.hpp"

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
  const int beam = project.beam_body;
  for (const frame::MemberPoint& point : structure.members[static_cast<std::size_t>(beam)].points) {
    if (point.name != "start" && point.name != "end") add(point.name, point.p.x());
  }
  for (const frame::Joint& joint : structure.joints) {
    for (const frame::Place* at : {&joint.a, &joint.b}) {
      if (at->member == beam) add(joint.name, at->p.x());
    }
  }
}

class FrameReader : public FrontEndReader {
 public:
  using FrontEndReader::FrontEndReader;

  void read(TableReader& root, const Node& tree) override {
    read_model(root, *project_);
    project_->beam_body = static_cast<int>(project_->beam_index);
    frame::Structure structure = structure_of(root, tree);
    refuse_moving_parts(root);
    refuse_planar_parts(root, *project_, {.deflection = true});
    project_->in_space = !structure.plane;
    if (root.problems().empty()) add_places(*project_, structure);
    structure.members[project_->beam_index].beam = project_->beam;
    project_->mechanism = std::move(structure);
  }

  Changeable changeable() const override {
    static constexpr std::array parts{"frame", "members", "supports", "joints", "loads", "motion"};
    return {parts, "loads.lift.force", beams_[project_->beam_index].name};
  }

  AnyMechanism changed_mechanism(TableReader& root) const override { return with_parts(root); }

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

  void read_neighbours(TableReader& root) override { read_deflection_of(root, *project_); }

  std::vector<Situation> read_combinations(TableReader& root) const override {
    return readers::read_combinations(root, frame_of(*project_));
  }

 private:
  /// The frame with the verified beam, or all beams of the case, as its first members.
  frame::Structure structure_of(TableReader& root, const Node& tree) {
    frame::Structure structure;
    read_frame(root, structure);
    structure.beams = std::max<std::size_t>(1, root.count_of("beam"));
    for (std::size_t i = 0; i < structure.beams; ++i) {
      TableReader table = beam_table(root, i);
      frame::Member& beam = structure.members.emplace_back();
      beam.name = table.text("name", "beam");
      const bool verified = i == project_->beam_index;
      if (verified) read_beam(table, *sections_, *project_);
      beam.beam = verified ? project_->beam : read_tapered_beam(table, *sections_);
      const ModelInput model = verified ? project_->model : model_of_other(root, tree, i);
      beam.youngs_modulus = model.youngs_modulus;
      beam.shear_modulus = model.shear_modulus;
      read_member_place(table, structure, beam);
      if (verified)
        table.finish();
      else
        table.accept_all();
    }
    beams_ = structure.members;
    return with_rest(root, std::move(structure));
  }

  /// The moduli of another beam, by its material.
  ModelInput model_of_other(TableReader& root, const Node& tree, std::size_t beam) const {
    const Node own = case_of_beam(tree, beam);
    KeyRecorder* const recorder = std::exchange(root.problems().recorder, nullptr);
    TableReader reader(root.problems(), own, "");
    Project other;
    other.mechanism = project_->mechanism;
    read_material(reader, other);
    read_model(reader, other);
    root.problems().recorder = recorder;
    return other.model;
  }

  /// The same with what a situation changes.
  frame::Structure with_parts(TableReader& root) const {
    frame::Structure structure;
    read_frame(root, structure);
    structure.members = beams_;
    structure.beams = beams_.size();
    structure.members[project_->beam_index].beam = project_->beam;
    return with_rest(root, std::move(structure));
  }

  frame::Structure with_rest(TableReader& root, frame::Structure structure) const {
    read_members(root, {sections_, project_}, structure);
    read_frame_joints(root, structure);
    read_frame_loads(root, structure, *tables_);
    return structure;
  }

  std::vector<frame::Member> beams_;
};

}  // namespace

std::unique_ptr<FrontEndReader> reader_for(const frame::Structure&, const Sections& sections,
                                           TimeTables& tables, Project& project) {
  return std::make_unique<FrameReader>(sections, tables, project);
}

}  // namespace boxbeam::readers
