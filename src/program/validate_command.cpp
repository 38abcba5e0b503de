#include "program/commands.hpp"

#include <fmt/format.h>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/core/index_by_name.hpp"
#include "boxbeam/project/project.hpp"
#include "program/exit_code.hpp"
#include "program/terminal.hpp"
#include "report/front_end_text.hpp"
#include "report/text_layout.hpp"

namespace boxbeam::program {
namespace {

/// "3: crank, rod, lever"; "" of none.
std::string listed(const std::vector<std::string>& names) {
  if (names.empty()) return "";
  return fmt::format("{}: {}", names.size(), fmt::join(names, ", "));
}

/// What a case consists of, an entry for each part that it has.
class Parts {
 public:
  void add(const char* name, const std::string& says) {
    if (!says.empty()) text_ += layout::entry(name, visible(says));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_mechanism(Parts& parts, const planar::Mechanism& mechanism) {
  std::vector<std::string> joints;
  std::vector<std::string> drivers;
  for (const planar::Joint& joint : mechanism.joints) {
    (is_driver(joint) ? drivers : joints).push_back(joint.name);
  }
  std::vector<std::string> forces, loose;
  for (const planar::AppliedForce& force : mechanism.forces) {
    const bool pin = std::holds_alternative<planar::PinWithClearance>(force.kind);
    (pin ? loose : forces).push_back(force.name);
  }
  parts.add("kind", "planar: rigid bodies in a plane");
  parts.add("bodies", listed(names_of(mechanism.bodies)));
  parts.add("joints", listed(joints));
  parts.add("with clearance", listed(loose));
  parts.add("drivers", listed(drivers));
  parts.add("forces", listed(forces));
  parts.add("loops", listed(names_of(mechanism.loops)));
}

void add_mechanism(Parts& parts, const spatial::Mechanism& mechanism) {
  std::vector<std::string> joints;
  std::vector<std::string> driven, forced;
  for (const spatial::Joint& joint : mechanism.joints) {
    joints.push_back(joint.name);
    if (spatial::is_driven(joint)) driven.push_back(joint.name);
    if (spatial::is_forced(joint)) forced.push_back(joint.name);
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    if (!joint.driver_name.empty()) driven.push_back(joint.name);
  }
  std::vector<std::string> forces = names_of(mechanism.loads);
  for (const spatial::LineForce& line : mechanism.line_forces) forces.push_back(line.name);
  std::vector<std::string> loose;
  for (const spatial::Spring& spring : mechanism.springs)
    (spring.clearance ? loose : forces).push_back(spring.name);
  for (const spatial::TorsionSpring& spring : mechanism.torsion_springs)
    forces.push_back(spring.name);
  parts.add("kind", "spatial: rigid bodies in space");
  parts.add("bodies", listed(names_of(mechanism.bodies)));
  parts.add("joints", listed(joints));
  parts.add("closing loops", listed(names_of(mechanism.closing)));
  if (!mechanism.branches.empty()) parts.add("loops", listed(names_of(mechanism.branches)));
  parts.add("with clearance", listed(loose));
  parts.add("driven", listed(driven));
  if (!forced.empty()) parts.add("moved by forces", listed(forced));
  parts.add("forces", listed(forces));
}

void add_mechanism(Parts& parts, const flexible::Mechanism& mechanism) {
  parts.add("kind", "flexible: elastic links in a plane");
  parts.add("links", listed(names_of(mechanism.links)));
  parts.add("joints", listed(names_of(mechanism.joints)));
  parts.add("loads", listed(names_of(mechanism.loads)));
  if (mechanism.frequency > 0.0) parts.add("frequency", fmt::format("{} Hz", mechanism.frequency));
}

void add_mechanism(Parts& parts, const frame::Structure& structure) {
  parts.add("kind", fmt::format("static: a frame at rest {}",
                                structure.plane ? "in the plane" : "in space"));
  parts.add("members", listed(names_of(structure.members)));
  std::vector<std::string> supports, joints;
  for (const frame::Joint& joint : structure.joints)
    (joint.b.member == frame::ground ? supports : joints).push_back(joint.name);
  parts.add("supports", listed(supports));
  parts.add("joints", listed(joints));
  parts.add("load cases", listed(names_of(structure.cases)));
}

void add_mechanism(Parts& parts, const recorded::Loads& loads) {
  const recorded::Channels& channels = *loads.acting.channels;
  parts.add("kind", loads.as_cuts ? "loads: cut forces over time, from files"
                                  : "loads: forces over time, from files");
  parts.add("time",
            fmt::format("{:.6g} s to {:.6g} s, {} instants", channels.times.front(),
                        channels.times.back(),
                        channels.record ? channels.record->instants() : channels.times.size()));
  std::vector<std::string> names;
  for (const recorded::ChannelSource& of : loads.sources) {
    if (std::find(names.begin(), names.end(), of.load) == names.end()) names.push_back(of.load);
  }
  parts.add(loads.as_cuts ? "stations" : "loads", listed(names));
}

std::vector<std::string> situations_of(const Project& project) {
  std::vector<std::string> names;
  for (const Situation& situation : project.situations) {
    const std::string name = situation.name.empty() ? "the case as written" : situation.name;
    names.push_back(situation.cycles > 0.0 ? fmt::format("{} ({:g} cycles)", name, situation.cycles)
                                           : name);
  }
  return names;
}

std::string text_of(const Project& project) {
  Parts parts;
  parts.add("case", fmt::format("{}: {}", project.name, project.title));
  std::visit([&](const auto& mechanism) { add_mechanism(parts, mechanism); }, project.mechanism);
  parts.add("loads by", project.dynamics == Dynamics::rigorous
                            ? report::front_end_text_of(project)->source_of_loads()
                            : "the published Newton chain");
  parts.add("beams", listed(project.beam_names));
  if (!project.beam_name.empty()) parts.add("of these", project.beam_name);
  parts.add("beam", fmt::format("{:.6g} m, {:.6g} kg", project.beam.length().value(),
                                mass_properties_of(project.beam).mass.value()));
  parts.add("segments", listed(names_of(project.beam.segments)));
  std::vector<std::string> holes;
  for (const BeamHole& hole : project.holes) holes.push_back(hole.hole.name);
  parts.add("holes", listed(holes));
  parts.add("steel", project.material.name);
  for (const PartMaterial& part : project.part_materials) parts.add("steel", part.material.name);
  parts.add("fatigue", project.fatigue.asked ? project.fatigue.beam.detail.name
                                             : "not asked for: strength only");
  std::vector<std::string> details;
  for (const BeamDetail& detail : project.fatigue.details) details.push_back(detail.detail.name);
  parts.add("details", listed(details));
  parts.add("pins", listed(names_of(project.pins)));
  parts.add("rods", listed(names_of(project.rods)));
  parts.add("situations", listed(situations_of(project)));
  std::vector<std::string> files;
  for (const InputFile& file : project.tables) files.push_back(file.written);
  parts.add("tables", listed(files));
  return parts.text();
}

}  // namespace

int run_validate(const CaseOptions& options) {
  const Project project = read_case(options);
  put_text(fmt::format("{}: nothing is wrong\n{}", options.file, text_of(project)));
  return all_pass;
}

}  // namespace boxbeam::program
