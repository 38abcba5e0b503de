#include <fmt/format.h>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using spatial::Mechanism;

constexpr FunctionOf force{wanted::force, "N", "force", "the force does not change"};
constexpr FunctionOf moment{wanted::moment, "N m", "moment", "the couple does not change"};
constexpr FunctionOf line{wanted::stiffness, "N/m", "line force", "the line force does not change"};

/// The body in whose axes a direction is given; the world where nothing is said.
int axes_in(TableReader& table, const Mechanism& mechanism) {
  const Key axes{"axes", "\"world\", or the body in whose axes the direction is"};
  if (table.text(axes, "world") == "world") return spatial::ground;
  return body_of(table, axes, mechanism);
}

void read_load(const std::string& name, TableReader& table, spatial::LoadKind kind,
               Mechanism& mechanism, TimeTables& tables) {
  spatial::AppliedLoad load;
  load.name = name;
  load.kind = kind;
  load.at = attachment_of(table, {"point", "where it acts, \"body.point\""}, mechanism);
  load.on = table.has("on") ? body_of(table, {"on", "another body that feels it"}, mechanism)
                            : load.at.body;
  load.axes = axes_in(table, mechanism);
  load.direction = table.direction({"direction", "of the force, or the axis of the couple"});
  load.size = read_size(table, kind == spatial::LoadKind::couple ? moment : force, tables);
  // A wrong name has been noted; nothing is then computed.
  if (load.on >= 0) mechanism.loads.push_back(std::move(load));
}

void read_line(const std::string& name, TableReader& table, Mechanism& mechanism,
               TimeTables& tables) {
  spatial::LineForce load;
  load.name = name;
  const spatial::Attachment from =
      attachment_of(table, {"from", "where it begins, \"body.point\""}, mechanism);
  const spatial::Attachment to = attachment_of(table, {"to", "where it ends"}, mechanism);
  load.on = from.body;
  load.from = from.p;
  load.to = to.p;
  load.axes = axes_in(table, mechanism);
  load.direction = table.direction({"direction", "of the force"});
  load.size = read_size(table, line, tables);
  if (from.body < 0 || to.body < 0) return;
  if (from.body != to.body || (from.p - to.p).norm() == 0.0) {
    table.problem("to", "a line force lies between two points of one body",
                  "write from = \"leg.B\" and to = \"leg.foot\"");
  }
  mechanism.line_forces.push_back(std::move(load));
}

/// "body.point", or "ground" with its place in "at".
spatial::Attachment end_of(TableReader& table, const std::string& reference,
                           const Mechanism& mechanism) {
  if (reference == "ground")
    return {spatial::ground, table.triple({"at", "the place on the ground"}, wanted::length)};
  return point_named(table, "connect", reference, mechanism);
}

void read_spring(const std::string& name, TableReader& table, Mechanism& mechanism) {
  const std::size_t before = table.problems().size();
  const std::vector<std::string> ends =
      table.texts({"connect", "its ends, \"body.point\", or \"ground\" for one of them"}, true);
  if (table.problems().size() != before) return;
  table.wants_with("at", "connect", "ground");
  spatial::Spring spring;
  spring.name = name;
  if (ends.size() == 2) {
    spring.a = end_of(table, ends[0], mechanism);
    spring.b = end_of(table, ends[1], mechanism);
  }
  if (ends.size() != 2 || (spring.a.body == spring.b.body && table.problems().size() == before)) {
    table.problem("connect", "a spring connects two bodies, or a body and the ground",
                  "write connect = [\"leg.B\", \"strut.B\"], or \"ground\" for one of them");
  }
  read_spring_law(table, spring);
  if (table.problems().size() == before) mechanism.springs.push_back(std::move(spring));
}

void read_torsion_spring(const std::string& name, TableReader& table, Mechanism& mechanism) {
  const std::size_t before = table.problems().size();
  const Key joint_of{"joint", "a revolute joint that carries a body, which it turns back"};
  const std::string joint = table.text(joint_of);
  spatial::TorsionSpring spring;
  spring.name = name;
  spring.joint = joint_index(mechanism, joint);
  const auto turns = [](const spatial::Joint& of) {
    return of.kind == spatial::JointKind::revolute;
  };
  if (!joint.empty() &&
      (spring.joint < 0 || !turns(mechanism.joints[static_cast<std::size_t>(spring.joint)]))) {
    std::vector<std::string> names;
    for (const spatial::Joint& of : mechanism.joints)
      if (turns(of)) names.push_back(of.name);
    table.problem(joint_of.name,
                  fmt::format("there is no revolute joint \"{}\" that carries a body", joint),
                  unknown_hint(joint, names));
  }
  const TorsionOf of = read_torsion(table);
  spring.stiffness = of.stiffness;
  spring.free_angle = of.free_angle;
  spring.damping = of.damping;
  if (table.problems().size() == before) mechanism.torsion_springs.push_back(std::move(spring));
}

}  // namespace

void read_chain_loads(TableReader& root, Mechanism& mechanism, TimeTables& tables) {
  for (auto& [name, table] :
       root.table({"forces", "forces and couples over time, and springs"}, false).named_tables()) {
    const std::size_t before = table.problems().size();
    const std::size_t kind = table.kind(
        {"kind", "of load"}, {"force", "couple", "line force", "spring", "torsion spring"});
    if (table.problems().size() != before) continue;
    switch (kind) {
      case 0: read_load(name, table, spatial::LoadKind::force, mechanism, tables); break;
      case 1: read_load(name, table, spatial::LoadKind::couple, mechanism, tables); break;
      case 2: read_line(name, table, mechanism, tables); break;
      case 3: read_spring(name, table, mechanism); break;
      default: read_torsion_spring(name, table, mechanism); break;
    }
    table.finish();
  }
}

}  // namespace boxbeam::readers
