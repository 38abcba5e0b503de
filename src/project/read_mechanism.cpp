#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::Attachment;
using planar::Joint;
using planar::Mechanism;

planar::Loop read_loop(const std::string& name, TableReader& table, const Mechanism& mechanism) {
  planar::Loop loop{name, planar::TurnSign{}, 1};
  if (!table.says_one_of({{{"turn"}}, {{"along", "direction"}}})) {
    table.texts("turn", false);
    table.texts("along", false);
    table.problem("", fmt::format("loop \"{}\" wants either \"turn\" or \"along\"", name),
                  "turn = [three points] for their sense of turn, along = [two points] with a "
                  "direction for the sense of a vector");
  } else if (table.has("turn")) {
    const auto points = attachments_of(
        table,
        {"turn",
         "three points, \"body.point\": \"+\" where the way over them turns counter-clockwise"},
        3, mechanism);
    loop.measure = planar::TurnSign{points[0], points[1], points[2]};
  } else {
    const auto points = attachments_of(
        table,
        {"along", "two points: \"+\" where the second lies from the first along the direction"}, 2,
        mechanism);
    loop.measure = planar::AlongSign{points[0], points[1],
                                     table.quantity({"direction", "of the sense"}, wanted::angle)};
  }
  loop.sign = table.choice({"sign", "of the branch that is wanted"}, {"+", "-"}) == 0 ? 1 : -1;
  table.finish();
  return loop;
}

/// Forces move what no joint or driver determines, but only over a duration that is given.
void check_count(TableReader& root, const Mechanism& mechanism) {
  const auto coordinates = mechanism.coordinates();
  const auto equations = mechanism.equations();
  if (equations >= coordinates) return;
  const auto missing = coordinates - equations;
  root.problem("joints",
               fmt::format("{} bodies have {} coordinates, joints and drivers give {} equations: "
                           "the motion is not determined",
                           mechanism.bodies.size(), coordinates, equations),
               fmt::format("{} more {} wanted: a joint or a driver is missing; where forces move "
                           "the rest, write [motion] with a duration",
                           missing, missing == 1 ? "equation is" : "equations are"));
}

/// Calls `move` with every attachment of the mechanism.
template <class Move>
void for_each_attachment(Mechanism& mechanism, const Move& move) {
  for (Joint& joint : mechanism.joints) {
    const auto [first, second] = planar::ends_in(joint);
    move(*first);
    move(*second);
  }
  for (planar::AppliedForce& force : mechanism.forces) {
    if (auto* point = std::get_if<planar::PointForce>(&force.kind)) {
      move(point->at);
      continue;
    }
    std::visit(
        [&](auto& kind) {
          if constexpr (requires { kind.b; }) {
            move(kind.a);
            move(kind.b);
          }
        },
        force.kind);
  }
  for (planar::Loop& loop : mechanism.loops) {
    if (auto* turn = std::get_if<planar::TurnSign>(&loop.measure)) {
      move(turn->from);
      move(turn->via);
      move(turn->to);
    } else {
      auto& along = std::get<planar::AlongSign>(loop.measure);
      move(along.from);
      move(along.to);
    }
  }
}

}  // namespace

std::string unknown_hint(std::string_view name, const std::vector<std::string>& known) {
  if (known.empty()) return "there is none that could be named";
  const std::string near = nearest_word(name, known);
  return near.empty() ? fmt::format("known: {}", fmt::join(known, ", "))
                      : fmt::format("did you mean \"{}\"?", near);
}

namespace {

bool is_loose_pin(const Mechanism& mechanism, std::string_view name) {
  return std::any_of(
      mechanism.forces.begin(), mechanism.forces.end(), [&](const planar::AppliedForce& force) {
        return force.name == name && std::holds_alternative<planar::PinWithClearance>(force.kind);
      });
}

template <class AnyMechanism>
int named_body(TableReader& table, const Key& of, const AnyMechanism& mechanism) {
  const std::string_view key = of.name;
  const std::string name = table.text(of);
  if (name.empty()) return -1;
  const int index = body_index(mechanism, name);
  if (index < 0) {
    table.problem(key, fmt::format("there is no body \"{}\"", name),
                  unknown_hint(name, names_of(mechanism.bodies)));
  }
  return index;
}

}  // namespace

int body_of(TableReader& table, const Key& of, const Mechanism& mechanism) {
  return named_body(table, of, mechanism);
}

int body_of(TableReader& table, const Key& of, const spatial::Mechanism& mechanism) {
  return named_body(table, of, mechanism);
}

int joint_of(TableReader& table, const Key& of, const Mechanism& mechanism) {
  const std::string_view key = of.name;
  const std::string name = table.text(of);
  if (name.empty()) return -1;
  const int index = joint_index(mechanism, name);
  if (index < 0 && is_loose_pin(mechanism, name)) {
    table.problem(key,
                  fmt::format("joint \"{}\" has a clearance, and this wants one that fits", name),
                  "leave it out; what the contact does to the beam is a load on it");
  } else if (index < 0) {
    table.problem(key, fmt::format("there is no joint \"{}\"", name),
                  unknown_hint(name, names_of(mechanism.joints)));
  }
  return index;
}

void check_name(TableReader& table, const std::string& name, const char* what,
                const Mechanism& mechanism) {
  if (is_loose_pin(mechanism, name)) {
    table.problem("", fmt::format("\"{}\" is already the name of a joint", name),
                  fmt::format("give the {} another name", what));
    return;
  }
  const int joint = joint_index(mechanism, name);
  if (joint < 0) return;
  const bool driver = is_driver(mechanism.joints[static_cast<std::size_t>(joint)]);
  table.problem(
      "", fmt::format("\"{}\" is already the name of a {}", name, driver ? "driver" : "joint"),
      fmt::format("give the {} another name", what));
}

MechanismDraft read_mechanism(TableReader& root, const std::vector<std::string>& beam_bodies,
                              TimeTables& tables) {
  MechanismDraft draft;
  Mechanism& mechanism = draft.mechanism;
  TableReader general = root.table({"mechanism", "general"});
  mechanism.gravity = general.pair({"gravity", "acceleration of free fall"}, wanted::acceleration);
  general.finish();
  mechanism.duration = read_duration(root);

  read_bodies(root, beam_bodies, draft);
  read_joints(root, draft);
  read_drivers(root, mechanism, tables);
  read_forces(root, mechanism, tables);
  TableReader loops = root.table({"loops", "which way of assembly is meant"}, false);
  for (auto& [name, table] : loops.named_tables()) {
    mechanism.loops.push_back(read_loop(name, table, mechanism));
  }
  check_functions(root, functions_of(mechanism), mechanism.duration, {});
  // Of nothing that drives and too few equations, the one follows from the other.
  if (root.problems().empty() && mechanism.duration.length == 0.0) check_count(root, mechanism);
  return draft;
}

void give_mass(MechanismDraft& draft, const TaperedBeam& beam, int body) {
  if (body == planar::ground) return;
  const auto index = static_cast<std::size_t>(body);
  const MassProperties properties = mass_properties_of(beam);
  draft.mechanism.bodies[index].mass = properties.mass.value();
  draft.mechanism.bodies[index].inertia = properties.inertia.value();
  draft.centres[index] = {properties.centre.value(), 0.0};
}

Mechanism place_at_centres(MechanismDraft draft) {
  Mechanism& mechanism = draft.mechanism;
  for_each_attachment(mechanism, [&](Attachment& attachment) {
    if (attachment.body != planar::ground) {
      attachment.p -= draft.centres[static_cast<std::size_t>(attachment.body)];
    }
  });
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    Body& body = mechanism.bodies[i];
    for (BodyPoint& point : body.points) point.p -= draft.centres[i];
    const Eigen::Vector2d to_centre = Eigen::Rotation2Dd(body.sketch.angle) * draft.centres[i];
    body.sketch.centre += to_centre;
    body.start_velocity.head<2>() +=
        body.start_velocity.z() * Eigen::Vector2d(-to_centre.y(), to_centre.x());
  }
  return std::move(mechanism);
}

}  // namespace boxbeam::readers
