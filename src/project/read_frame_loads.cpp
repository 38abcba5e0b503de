#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "frame_reader.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector3d;
using frame::Structure;

/// Vectors as the case writes them: in world axes, or in those of the member.
struct LoadAxes {
  bool of_member = false;
  bool plane = true;

  /// In the plane a member's axes are x along it and z to its left.
  Vector3d read(TableReader& table, const Key& key, const WantedDimension& wanted,
                const frame::Member& member, std::optional<Vector3d> fallback = {}) const {
    Vector3d written = vector_of(table, key, wanted, plane, fallback);
    if (!of_member) return written;
    if (plane) return member.axes * Vector3d(written.x(), 0.0, written.y());
    return member.axes * written;
  }
};

LoadAxes read_load_axes(TableReader& table, const Structure& structure) {
  const bool of_member =
      table.choice({"axes", "in which forces are written: the world's, or the member's"},
                   {"world", "member"}, 0) == 1;
  return {of_member, structure.plane};
}

/// The member of a place; where that is not known, which has been said, the beam.
const frame::Member& member_at(const Structure& structure, int member) {
  return structure.members[static_cast<std::size_t>(std::max(0, member))];
}

frame::PointAction read_point_action(TableReader& table, const Structure& structure) {
  frame::PointAction action;
  action.at = read_frame_place(table, structure);
  const LoadAxes axes = read_load_axes(table, structure);
  const frame::Member& member = member_at(structure, action.at.member);
  const Vector3d none = Vector3d::Zero();
  action.force = axes.read(table, {"force", "on the member"}, wanted::force, member, none);
  if (structure.plane) {
    action.moment.z() = table.quantity(
        {"moment", "on the member, counter-clockwise; in space three"}, wanted::moment, 0.0);
  } else {
    action.moment = axes.read(table, {"moment", "on the member, counter-clockwise; in space three"},
                              wanted::moment, member, none);
  }
  if (action.force.isZero(0.0) && action.moment.isZero(0.0) && table.problems().empty()) {
    table.problem("", "the load has neither a force nor a moment",
                  structure.plane ? "write for example force = [\"0 kN\", \"-10 kN\"]"
                                  : "write for example force = [\"0 kN\", \"0 kN\", \"-10 kN\"]");
  }
  return action;
}

constexpr FunctionOf driven_force{wanted::force, "N", "force", "the force does not change"};
constexpr FunctionOf driven_couple{wanted::moment, "N m", "moment", "the couple does not change"};

/// A force, or a couple, in a direction: of a constant size, or following a function of time.
std::variant<frame::PointAction, frame::DrivenAction> read_driven(TableReader& table, bool couple,
                                                                  const Structure& structure,
                                                                  TimeTables& tables) {
  frame::DrivenAction action;
  action.at = read_frame_place(table, structure);
  const LoadAxes axes = read_load_axes(table, structure);
  action.couple = couple;
  const frame::Member& member = member_at(structure, action.at.member);
  if (structure.plane && !action.couple) {
    const double angle =
        table.quantity({"direction", "of the force, from the x of its axes"}, wanted::angle);
    action.direction = {std::cos(angle), std::sin(angle), 0.0};
    if (axes.of_member)
      action.direction = member.axes * Vector3d(std::cos(angle), 0.0, std::sin(angle));
  } else if (structure.plane) {
    action.direction = Vector3d::UnitZ();
  } else {
    action.direction = couple
                           ? table.direction({"axis", "about which the couple turns, in its axes"})
                           : table.direction({"direction", "of the force, in its axes"});
    if (axes.of_member) action.direction = member.axes * action.direction;
  }
  const bool constant = table.has("size");
  action.size = read_size(table, action.couple ? driven_couple : driven_force, tables);
  if (!constant) return action;
  const Vector3d load = driver_at(action.size, 0.0).value * action.direction;
  const Vector3d none = Vector3d::Zero();
  return frame::PointAction{action.at, action.couple ? none : load, action.couple ? load : none};
}

/// Two stations of a member, the first before the second; its ends where not said.
std::pair<double, double> read_stretch(TableReader& table, const frame::Member& member) {
  const double length = length_of(member);
  const double from =
      table.quantity({"from", "station; the member's start where not said"}, wanted::length, 0.0);
  const double to =
      table.quantity({"to", "station; the member's end where not said"}, wanted::length, length);
  if (table.problems().empty() &&
      (from < -1e-9 * length || to > length * (1.0 + 1e-9) || !(from < to))) {
    table.problem("to",
                  fmt::format("from {:.6g} to {:.6g} m is no stretch of member \"{}\"", from, to,
                              member.name),
                  fmt::format("stations go from 0 to {:.6g} m, \"from\" before \"to\"", length));
  }
  return {std::max(0.0, from), std::min(to, length)};
}

frame::LineAction read_line_action(TableReader& table, const Structure& structure) {
  frame::LineAction action;
  action.member = read_on(table, structure);
  const frame::Member& member = member_at(structure, action.member);
  std::tie(action.from, action.to) = read_stretch(table, member);
  const LoadAxes axes = read_load_axes(table, structure);
  action.at_from =
      axes.read(table, {"force_per_length", "per length of the axis; at \"from\" where it varies"},
                wanted::stiffness, member);
  action.at_to = action.at_from;
  if (table.has("to_force_per_length")) {
    action.at_to = axes.read(table, {"to_force_per_length", "at \"to\", linear between them"},
                             wanted::stiffness, member);
  }
  if (table.boolean({"projected", "per length across the force, as snow lies, not along the axis"},
                    false)) {
    for (Vector3d* force : {&action.at_from, &action.at_to}) {
      if (force->isZero(0.0)) continue;
      *force *= force->normalized().cross(member.axes.col(0)).norm();
    }
  }
  return action;
}

frame::HeatAction read_heat(TableReader& table, const Structure& structure) {
  frame::HeatAction action;
  action.member = read_on(table, structure);
  action.mean = table.quantity({"temperature", "by which the member's axis is warmer"},
                               wanted::temperature, 0.0);
  action.along_z =
      table.quantity({"gradient", "warmer towards +z"}, wanted::temperature_gradient, 0.0);
  if (!structure.plane) {
    action.along_y = table.quantity({"gradient_y", "warmer towards +y, in space"},
                                    wanted::temperature_gradient, 0.0);
  }
  return action;
}

frame::Settlement read_settlement(TableReader& table, const Structure& structure) {
  frame::Settlement action;
  const std::string name = table.text({"support", "that moves"});
  action.joint = index_by_name(structure.joints, name);
  if (action.joint < 0) {
    if (!name.empty()) {
      table.problem("support", fmt::format("there is no support \"{}\"", name),
                    unknown_hint(name, names_of(structure.joints)));
    }
    action.joint = 0;
  }
  action.shift = vector_of(table, {"shift", "of the ground under it, world axes"}, wanted::length,
                           structure.plane, Vector3d(Vector3d::Zero()));
  if (structure.plane) {
    action.turn.z() = table.quantity({"turn", "of the ground, counter-clockwise; in space three"},
                                     wanted::angle, 0.0);
  } else {
    action.turn = table.triple({"turn", "of the ground, counter-clockwise; in space three"},
                               wanted::angle, Vector3d(Vector3d::Zero()));
  }
  return action;
}

frame::Wheels read_wheels(TableReader& table, const Structure& structure) {
  frame::Wheels action;
  action.member = read_on(table, structure);
  const frame::Member& member = member_at(structure, action.member);
  const LoadAxes axes = read_load_axes(table, structure);
  double last = 0.0;
  for (TableReader& wheel :
       table.tables({"wheels", "that run along the member, the first ahead"}, true)) {
    frame::Wheels::Wheel of;
    of.behind = wheel.not_negative({"behind", "the first wheel"}, wanted::length, 0.0);
    of.force = axes.read(wheel, {"force", "of the wheel"}, wanted::force, member);
    wheel.finish();
    last = std::max(last, of.behind);
    action.wheels.push_back(of);
  }
  if (action.wheels.empty() && table.problems().empty()) {
    table.problem("", "no wheel runs",
                  "write wheels = [{ force = [..] }, { behind = \"2 m\", force = [..] }]");
  }
  const double length = length_of(member);
  action.from = table.quantity({"from",
                                "station of the first wheel at the start; where not said that of "
                                "the member, onto which they come one after the other"},
                               wanted::length, 0.0);
  action.to = table.quantity({"to",
                              "and at the end; where not said beyond that of the member, which "
                              "they leave one after the other"},
                             wanted::length, length + last);
  action.speed = table.positive(
      {"speed", "at which they pass, for when they do and how the frame vibrates under them"},
      wanted::velocity, 1.0);
  if (!structure.plane) {
    action.y = table.quantity({"y", "of the rail, off the member's axis"}, wanted::length, 0.0);
  }
  action.z = table.quantity({"z", "likewise"}, wanted::length, 0.0);
  if (table.problems().empty() && !(action.from < action.to)) {
    table.problem(
        "to",
        fmt::format("the wheels have no way to go from {:.6g} to {:.6g} m", action.from, action.to),
        "write \"from\" before \"to\"");
  }
  return action;
}

/// The load case of a name, a new one where it is the first of it.
frame::LoadCase& load_case(Structure& structure, const std::string& name) {
  int index = index_by_name(structure.cases, name);
  if (index < 0) {
    index = static_cast<int>(structure.cases.size());
    structure.cases.push_back({name, {}});
  }
  return structure.cases[static_cast<std::size_t>(index)];
}

/// Each of two loads that move may stand anywhere while the other does: their places together are
/// not searched.
void refuse_loads_that_move_apart(const Structure& structure, TableReader& root) {
  std::string moves;
  bool wheels_run = false;
  for (const frame::LoadCase& of : structure.cases) {
    for (const frame::Action& action : of.actions) {
      const bool runs = std::holds_alternative<frame::Wheels>(action.kind);
      if (!runs && !std::holds_alternative<frame::DrivenAction>(action.kind)) continue;
      if (!moves.empty() && (runs || wheels_run)) {
        root.problem(
            "loads",
            fmt::format("wheels \"{}\" and load \"{}\" change independently of each other, "
                        "and the worst of both together is not searched",
                        runs ? action.name : moves, runs ? moves : action.name),
            "write all wheels as one load, or a case of its own for each");
        break;
      }
      moves = action.name;
      wheels_run = wheels_run || runs;
    }
  }
}

/// The weight is there unless somebody places it in a case of its own.
void place_weight(Structure& structure) {
  const bool weighed =
      std::any_of(structure.cases.begin(), structure.cases.end(), [](const frame::LoadCase& of) {
        return std::any_of(of.actions.begin(), of.actions.end(), [](const frame::Action& action) {
          return std::holds_alternative<frame::OwnWeight>(action.kind);
        });
      });
  if (!weighed && index_by_name(structure.cases, "weight") < 0) {
    structure.cases.insert(structure.cases.begin(), {"weight", {{"weight", frame::OwnWeight{}}}});
  } else if (!weighed) {
    load_case(structure, "weight").actions.push_back({"weight", frame::OwnWeight{}});
  }
}

}  // namespace

void read_frame_loads(TableReader& root, Structure& structure, TimeTables& tables) {
  for (auto& [name, table] : root.table({"loads", "what acts"}, false).named_tables()) {
    const std::string of_case =
        table.text({"case", "the load case; one of its own where not said"}, name);
    const std::size_t before = table.problems().size();
    const std::size_t kind =
        table.kind({"kind", "of load"}, {"force", "driven", "driven couple", "line", "weight",
                                         "temperature", "settlement", "wheels"});
    frame::LoadCase& in = load_case(structure, of_case);
    if (table.problems().size() != before) {
      table.accept_all();
      continue;
    }
    if (of_case == "weight" && kind != 4 && !table.has("case")) {
      table.problem(
          "", "\"weight\" is the load case of the members' own weight",
          "give the load another name, or write case = \"weight\" where it comes with it");
    }
    frame::Action action{name, frame::OwnWeight{}};
    switch (kind) {
      case 0: action.kind = read_point_action(table, structure); break;
      case 1:
      case 2:
        std::visit([&](auto of) { action.kind = std::move(of); },
                   read_driven(table, kind == 2, structure, tables));
        break;
      case 3: action.kind = read_line_action(table, structure); break;
      case 4: break;
      case 5: action.kind = read_heat(table, structure); break;
      case 6: action.kind = read_settlement(table, structure); break;
      default: action.kind = read_wheels(table, structure);
    }
    if (index_by_name(structure.joints, name) >= 0) {
      table.problem("", fmt::format("\"{}\" is already the name of a support or joint", name),
                    "give the load another name");
    }
    table.finish();
    in.actions.push_back(std::move(action));
  }
  refuse_loads_that_move_apart(structure, root);
  place_weight(structure);
  structure.factors.assign(structure.cases.size(), 1.0);
  const std::vector<DriverUse> functions = functions_of(structure);
  if (!functions.empty()) {
    structure.duration = read_duration(root);
    if (root.problems().empty())
      check_functions(root, functions, structure.duration, {"supports", "loads"});
  } else if (root.has_misplaced("motion")) {
    root.problem("motion", "no load follows a function of time",
                 "remove [motion], or write a load of kind = \"driven\" with a law");
  }
}

}  // namespace boxbeam::readers
