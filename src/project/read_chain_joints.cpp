#include <fmt/format.h>
#include <Eigen/Geometry>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "read_elasticity.hpp"
#include "read_gearing.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using spatial::ClosingJoint;
using spatial::ClosingKind;
using spatial::Joint;
using spatial::JointKind;
using spatial::Mechanism;

constexpr FunctionOf length{wanted::length, "m", "stroke", "the driver does not move", true};
constexpr FunctionOf angle{wanted::angle, "rad", "angle", "the driver does not move", true};

/// Kinds as they are written: those of closing joints in their order, and one that closes nothing.
const std::vector<std::string> kinds{
    "fixed", "revolute", "prismatic", "cylindrical", "universal", "spherical", "planar",
    "slot",  "distance", "screw",     "gear",        "rack",      "free"};
constexpr std::size_t free_body = 12;

/// A joint as written, with the bodies that it connects.
struct JointDraft {
  Joint joint;
  int carried = spatial::ground;
};

/// What [joints] says: joints that carry bodies, and joints that close loops; bodies in the order
/// of the file.
struct JointDrafts {
  std::vector<JointDraft> carrying;
  std::vector<ClosingJoint> closing;
  std::vector<bool> has_length;  ///< of the closing ones
  std::vector<GearingDraft> gearings;
  std::vector<spatial::Spring> loose;  ///< balls with clearance in their sockets
  std::vector<NamedElasticJoint> giving_way;
};

/// The carrying point and the carried one.
void read_connection(TableReader& table, const Mechanism& mechanism, JointDraft& draft) {
  const char* hint =
      "write connect = [\"leg.C\", \"wheel.C\"], the carrying body first; it may be \"ground\", "
      "whose point is at = [x, y, z]";
  const std::size_t before = table.problems().size();
  const std::vector<std::string> references = table.texts(
      {"connect", "the carrying point, which may be \"ground\", and the carried one"}, true);
  if (table.problems().size() != before) return;
  if (references.size() != 2 || references[1] == "ground") {
    table.problem("connect", "a joint connects two points, and carries the second one's body",
                  hint);
    return;
  }
  if (references[0] == "ground") {
    draft.joint.at =
        table.triple({"at", "the place on the ground"}, wanted::length, Eigen::Vector3d::Zero());
  } else {
    const spatial::Attachment from = point_named(table, "connect", references[0], mechanism);
    draft.joint.parent = from.body;
    draft.joint.at = from.p;
  }
  const spatial::Attachment to = point_named(table, "connect", references[1], mechanism);
  draft.carried = to.body;
  draft.joint.point = to.p;
  if (to.body >= 0 && to.body == draft.joint.parent) {
    table.problem("connect", "a joint connects two different bodies", hint);
  }
}

Eigen::Matrix3d turn_in(TableReader& table) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (const auto& [axis, by] : table.turns(
           {"turn",
            "how the carried body stands at zero: turns about axes, one after the other"})) {
    turn = spatial::composed(turn, spatial::rotation_about(by * axis));
  }
  return turn;
}

/// The directions that a kind of joint wants, in the axes of the carried body where it stands at
/// zero: its axis, or those of its turns.
std::vector<Eigen::Vector3d> read_axes(TableReader& table, std::size_t kind, bool closes) {
  switch (static_cast<ClosingKind>(kind)) {
    case ClosingKind::revolute:
    case ClosingKind::prismatic:
    case ClosingKind::cylindrical:
    case ClosingKind::planar:
    case ClosingKind::slot:
    case ClosingKind::screw:
      return {table.direction(
          {"axis",
           "about or along which it moves, in the carried body's axes; of \"planar\" the "
           "one that stays square to the plane"})};
    case ClosingKind::universal: {
      const Eigen::Vector3d axis = table.direction(
          {"axis",
           "about or along which it moves, in the carried body's axes; of \"planar\" the "
           "one that stays square to the plane"});
      const Eigen::Vector3d second =
          table.direction({"second_axis", "of the carried body, square to the first"});
      if (std::abs(axis.dot(second)) > 1e-9) {
        table.problem("second_axis", "the two axes of a universal joint stand square to each other",
                      "write for example axis = \"y\" and second_axis = \"z\"");
      }
      return {axis, second};
    }
    case ClosingKind::spherical:
      if (!closes && table.has("axes"))
        return table.directions({"axes", "of its turns, one after the other"}, 3);
      break;
    case ClosingKind::fixed:
    case ClosingKind::distance:
    case ClosingKind::gear:
    case ClosingKind::rack: break;
  }
  return {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()};
}

/// One movement of a joint that carries a body.
struct Movement {
  JointKind kind;
  Eigen::Vector3d axis;
};

/// The movements of a joint one after the other.
std::vector<Movement> movements_of(std::size_t kind, const std::vector<Eigen::Vector3d>& axes) {
  const auto turn = [](const Eigen::Vector3d& axis) { return Movement{JointKind::revolute, axis}; };
  const auto shift = [](const Eigen::Vector3d& axis) {
    return Movement{JointKind::prismatic, axis};
  };
  std::vector<Movement> movements;
  if (kind == free_body) {
    for (int k = 0; k < 3; ++k) movements.push_back(shift(Eigen::Vector3d::Unit(k)));
    for (const Eigen::Vector3d& axis : axes) movements.push_back(turn(axis));
    return movements;
  }
  switch (static_cast<ClosingKind>(kind)) {
    case ClosingKind::fixed: return {{JointKind::fixed, Eigen::Vector3d::UnitZ()}};
    case ClosingKind::revolute: return {turn(axes[0])};
    case ClosingKind::prismatic: return {shift(axes[0])};
    case ClosingKind::cylindrical: return {turn(axes[0]), shift(axes[0])};
    case ClosingKind::universal:
    case ClosingKind::spherical: break;
    case ClosingKind::planar: {
      const Eigen::Vector3d u = axes[0].unitOrthogonal();
      return {shift(u), shift(axes[0].cross(u)), turn(axes[0])};
    }
    case ClosingKind::screw: return {{JointKind::screw, axes[0]}};
    case ClosingKind::slot:
    case ClosingKind::distance:
    case ClosingKind::gear:
    case ClosingKind::rack: return {};
  }
  for (const Eigen::Vector3d& axis : axes) movements.push_back(turn(axis));
  return movements;
}

/// Values of the movements of a joint, of turns by one key and of shifts by another where it has
/// several; zero where they are not said.
std::vector<double> read_values(TableReader& table, const std::vector<Movement>& movements,
                                const Key& of_one, const Key& of_shifts,
                                const WantedDimension& of_turn, const WantedDimension& of_shift) {
  const auto is_turn = [](const Movement& movement) { return is_angle(movement.kind); };
  std::vector<double> values(movements.size(), 0.0);
  if (movements.size() == 1) {
    if (movements[0].kind == JointKind::fixed) return values;
    values[0] = table.quantity(of_one, is_turn(movements[0]) ? of_turn : of_shift, 0.0);
    return values;
  }
  const auto read_list = [&](const Key& key, bool turns, const WantedDimension& dimension) {
    const auto count = static_cast<std::size_t>(
        std::count_if(movements.begin(), movements.end(),
                      [&](const Movement& m) { return is_turn(m) == turns; }));
    if (count == 0 || !table.has(key)) return;
    const std::vector<double> given = table.quantities(key, dimension);
    if (given.size() != count) {
      table.problem(key.name, fmt::format("\"{}\" wants {} values", key.name, count),
                    fmt::format("one for each of its {}", turns ? "turns" : "shifts"));
      return;
    }
    auto next = given.begin();
    for (std::size_t k = 0; k < movements.size(); ++k)
      if (is_turn(movements[k]) == turns) values[k] = *next++;
  };
  read_list(of_one, true, of_turn);
  read_list(of_shifts, false, of_shift);
  return values;
}

/// Adds a joint that carries a body; of several movements one after the other, with frames without
/// mass between them: "ball.1" to "ball.3".
void add_carrying(TableReader& table, const JointDraft& whole,
                  const std::vector<Movement>& movements, Mechanism& mechanism,
                  std::vector<JointDraft>& drafts) {
  const bool moves = movements.front().kind != JointKind::fixed;
  const bool forced =
      moves && table.choice({"moved_by",
                             "what moves it where no driver does; without loops drivers "
                             "alone, but where forces are said to"},
                            {"drivers and loops", "forces"}, 0) == 1;
  const std::vector<double> starts =
      read_values(table, movements,
                  {"start",
                   "near which it is sought at t = 0 where no driver moves it; where forces do, "
                   "its place at t = "
                   "0; of several turns one after the other"},
                  {"start_shift", "the same of its shifts"}, wanted::angle, wanted::length);
  const std::vector<double> rates = read_values(
      table, movements, {"start_rate", "at t = 0 where forces move it; of several turns as start"},
      {"start_shift_rate", "the same of its shifts"}, wanted::angular_velocity, wanted::velocity);
  if (!forced && std::any_of(rates.begin(), rates.end(), [](double rate) { return rate != 0.0; })) {
    table.problem("start_rate", "rates at the start are those of what forces move",
                  "write moved_by = \"forces\", or leave them out");
  }
  const std::string name = whole.joint.name;
  JointDraft draft = whole;
  for (std::size_t k = 0; k < movements.size(); ++k) {
    const bool last = k + 1 == movements.size();
    if (movements.size() > 1) draft.joint.name = fmt::format("{}.{}", name, k + 1);
    draft.joint.kind = movements[k].kind;
    // Written in the axes of the carried body where it stands at zero.
    draft.joint.axis = draft.joint.turn * movements[k].axis;
    draft.joint.start = starts[k];
    draft.joint.start_rate = rates[k];
    draft.joint.friction =
        movements[k].kind == JointKind::prismatic ? whole.joint.friction : Friction{};
    draft.joint.moved_by = forced ? spatial::MovedBy::forces : spatial::MovedBy::driver;
    draft.joint.point = last ? whole.joint.point : Eigen::Vector3d::Zero().eval();
    draft.carried = last ? whole.carried : static_cast<int>(mechanism.bodies.size());
    if (!last) mechanism.bodies.emplace_back().name = draft.joint.name;
    drafts.push_back(draft);
    draft.joint.parent = draft.carried;
    draft.joint.at.setZero();
    draft.joint.turn.setIdentity();
  }
}

void add_closing(TableReader& table, const JointDraft& draft, std::size_t kind,
                 const std::vector<Eigen::Vector3d>& axes, JointDrafts& drafts) {
  ClosingJoint joint;
  joint.name = draft.joint.name;
  joint.kind = static_cast<ClosingKind>(kind);
  joint.a = {draft.joint.parent, draft.joint.at};
  joint.b = {draft.carried, draft.joint.point};
  joint.turn = draft.joint.turn;
  joint.axis = joint.turn * axes[0];
  joint.lead = draft.joint.lead;
  if (axes.size() > 1) joint.other = axes[1];
  joint.friction = draft.joint.friction;
  bool has_length = false;
  if (joint.kind == ClosingKind::distance) {
    const Key length_of{"length",
                        "of a rod between the two points; that of a cylinder has a driver"};
    has_length = table.has_quantity(length_of, wanted::length);
    if (has_length) {
      joint.length = PolynomialDriver{{table.positive(length_of, wanted::length)}};
    }
  }
  drafts.closing.push_back(std::move(joint));
  drafts.has_length.push_back(has_length);
}

spatial::Spring loose_ball(const JointDraft& draft, const ClearanceOf& of) {
  spatial::Spring ball;
  ball.name = draft.joint.name;
  ball.a = {draft.joint.parent, draft.joint.at};
  ball.b = {draft.carried, draft.joint.point};
  ball.stiffness = of.stiffness;
  ball.free_length = of.clearance;
  ball.acts = Acts::pulling;
  ball.impact = of.impact;
  ball.clearance = true;
  return ball;
}

/// Of kinds that slide along an axis; refuses that of others.
Friction read_sliding_friction(TableReader& table, std::size_t kind) {
  const bool slot = kind == static_cast<std::size_t>(ClosingKind::slot);
  if (slot || kind == static_cast<std::size_t>(ClosingKind::prismatic) ||
      kind == static_cast<std::size_t>(ClosingKind::cylindrical)) {
    const Friction law = read_friction(table);
    if (slot && law.guide > 0.0) {
      table.problem("friction", "a slot carries no couple that presses on the ends of a guide",
                    "leave out guide_length");
    }
    return law;
  }
  if (table.is_there("friction") && table.has_misplaced("friction")) {
    table.problem("friction", fmt::format("friction in a {} joint is not computed", kinds[kind]),
                  "what slides along an axis may rub: kind = \"prismatic\", \"cylindrical\" or "
                  "\"slot\"; else leave it out");
  }
  return {};
}

/// Where a kind of joint keeps a place or a distance, and an angle; teeth are asked nothing.
CanGiveWay where_it_gives(std::size_t kind) {
  if (kind == free_body) return {};
  switch (static_cast<ClosingKind>(kind)) {
    case ClosingKind::fixed:
    case ClosingKind::revolute:
    case ClosingKind::prismatic:
    case ClosingKind::cylindrical:
    case ClosingKind::universal:
    case ClosingKind::planar:
    case ClosingKind::screw: return {true, true};
    case ClosingKind::spherical:
    case ClosingKind::slot:
    case ClosingKind::distance: return {true, false};
    case ClosingKind::gear:
    case ClosingKind::rack: return {};
  }
  return {};
}

void read_elasticity_of(TableReader& table, const std::string& name, std::size_t kind,
                        JointDrafts& drafts) {
  const GivesWay of = read_elasticity(table, where_it_gives(kind));
  if (std::isinf(of.stiffness) && std::isinf(of.turning_stiffness)) return;
  drafts.giving_way.push_back({name,
                               {static_cast<ClosingKind>(kind), of.stiffness, of.damping,
                                of.turning_stiffness, of.turning_damping}});
}

JointDrafts read_joints_of(TableReader& root, Mechanism& mechanism) {
  JointDrafts drafts;
  for (auto& [name, table] :
       root.table({"joints", "which joint carries which body, one for each, and which close loops"})
           .named_tables()) {
    JointDraft draft;
    draft.joint.name = name;
    const std::size_t before = table.problems().size();
    const std::size_t kind = table.kind({"kind", "of joint"}, kinds);
    if (table.problems().size() != before) continue;
    if (kind < free_body && has_teeth(static_cast<ClosingKind>(kind))) {
      GearingDraft gearing = read_gearing(table, static_cast<ClosingKind>(kind), mechanism);
      table.finish();
      gearing.closing = drafts.closing.size();
      drafts.gearings.push_back(std::move(gearing));
      ClosingJoint joint;
      joint.name = name;
      joint.kind = static_cast<ClosingKind>(kind);
      drafts.closing.push_back(std::move(joint));
      drafts.has_length.push_back(false);
      continue;
    }
    const bool only_closes = kind == static_cast<std::size_t>(ClosingKind::slot) ||
                             kind == static_cast<std::size_t>(ClosingKind::distance);
    const bool closes =
        only_closes ||
        (kind != free_body &&
         table.boolean({"closes", "it closes a loop: another joint carries the second body"},
                       false));
    read_connection(table, mechanism, draft);
    // A slot and a distance do not see how the second body stands.
    if (!only_closes) draft.joint.turn = turn_in(table);
    const std::vector<Eigen::Vector3d> axes = read_axes(table, kind, closes);
    if (kind == static_cast<std::size_t>(ClosingKind::screw)) {
      draft.joint.lead = table.not_zero(
          {"lead", "of a screw: its advance along its axis in a turn; positive: right-handed"},
          wanted::length);
    }
    draft.joint.friction = read_sliding_friction(table, kind);
    if (closes && kind == static_cast<std::size_t>(ClosingKind::spherical)) {
      if (const std::optional<ClearanceOf> of = read_clearance(table)) {
        if (table.problems().size() == before) drafts.loose.push_back(loose_ball(draft, *of));
        table.finish();
        continue;
      }
    } else if (table.is_there("clearance") && table.has_misplaced("clearance")) {
      table.problem("clearance",
                    fmt::format("clearance of a {} joint is not computed", kinds[kind]),
                    "a spherical joint with closes = true may have one: a ball in a wider socket; "
                    "of a pin two of them, at both ends of its bearing");
    }
    read_elasticity_of(table, name, kind, drafts);
    if (table.problems().size() == before) {
      if (closes)
        add_closing(table, draft, kind, axes, drafts);
      else
        add_carrying(table, draft, movements_of(kind, axes), mechanism, drafts.carrying);
    }
    table.finish();
  }
  return drafts;
}

/// The joint that carries each body. Notes bodies that no joint carries or that two carry.
std::vector<const JointDraft*> carriers_of(TableReader& root, const JointDrafts& drafts,
                                           const Mechanism& mechanism) {
  std::vector<const JointDraft*> carrier(mechanism.bodies.size(), nullptr);
  for (const JointDraft& draft : drafts.carrying) {
    if (draft.carried < 0) continue;
    const auto same_name = [&](const auto& other) { return other.name == draft.joint.name; };
    const auto alike =
        std::count_if(drafts.carrying.begin(), drafts.carrying.end(),
                      [&](const JointDraft& other) { return same_name(other.joint); }) +
        std::count_if(drafts.closing.begin(), drafts.closing.end(), same_name);
    if (alike > 1) {
      root.table("joints").problem(
          draft.joint.name, fmt::format("two joints are called \"{}\"", draft.joint.name),
          "a spherical joint \"ball\" is \"ball.1\", \"ball.2\" and \"ball.3\": give the other "
          "another name");
      return carrier;
    }
    const JointDraft*& of = carrier[static_cast<std::size_t>(draft.carried)];
    if (of != nullptr) {
      root.table("joints").problem(
          draft.joint.name.substr(0, draft.joint.name.find('.')),
          fmt::format("body \"{}\" is carried twice, by \"{}\" and by \"{}\"",
                      mechanism.bodies[static_cast<std::size_t>(draft.carried)].name,
                      of->joint.name, draft.joint.name),
          "one joint carries each body; write closes = true in the other, which closes a loop");
      return carrier;
    }
    of = &draft;
  }
  for (std::size_t i = 0; i < carrier.size(); ++i) {
    if (carrier[i] != nullptr) continue;
    root.table("bodies").problem(
        mechanism.bodies[i].name,
        fmt::format("no joint carries body \"{}\"", mechanism.bodies[i].name),
        "write a joint with connect = [\"ground\", ...] or [\"another body's point\", ...]");
    return carrier;
  }
  return carrier;
}

/// Puts every body behind the one that carries it, its joint at its place, and the closing joints
/// on them. Notes bodies that carry each other in a ring, and what `carriers_of` notes.
bool sort_tree(TableReader& root, const JointDrafts& drafts, Mechanism& mechanism) {
  const std::size_t before = root.problems().size();
  const std::vector<const JointDraft*> carrier = carriers_of(root, drafts, mechanism);
  if (root.problems().size() != before) return false;
  const std::size_t count = mechanism.bodies.size();
  std::vector<int> place(count, -1);  // in the new order
  Mechanism sorted = mechanism;
  sorted.bodies.clear();
  sorted.joints.clear();
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < count; ++i) {
      const int parent = carrier[i]->joint.parent;
      if (place[i] >= 0 || (parent >= 0 && place[static_cast<std::size_t>(parent)] < 0)) continue;
      place[i] = static_cast<int>(sorted.bodies.size());
      sorted.bodies.push_back(mechanism.bodies[i]);
      sorted.joints.push_back(carrier[i]->joint);
      if (parent >= 0) sorted.joints.back().parent = place[static_cast<std::size_t>(parent)];
      more = true;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (place[i] >= 0) continue;
    root.table("joints").problem(
        carrier[i]->joint.name,
        fmt::format("body \"{}\" is carried by what it carries itself", mechanism.bodies[i].name),
        "the tree begins at the ground: one joint has connect = [\"ground\", ...], and the joint "
        "that closes the ring has closes = true");
    return false;
  }
  sorted.closing = drafts.closing;
  for (ClosingJoint& joint : sorted.closing) {
    for (spatial::Attachment* end : {&joint.a, &joint.b})
      if (end->body >= 0) end->body = place[static_cast<std::size_t>(end->body)];
  }
  sorted.springs = drafts.loose;
  for (spatial::Spring& ball : sorted.springs) {
    for (spatial::Attachment* end : {&ball.a, &ball.b})
      if (end->body >= 0) end->body = place[static_cast<std::size_t>(end->body)];
  }
  mechanism = std::move(sorted);
  return true;
}

/// Reads the drivers into joints that carry and cylinders that close.
class JointDrivers {
 public:
  JointDrivers(TableReader& root, Mechanism& mechanism, TimeTables& tables)
      : root_(&root), mechanism_(&mechanism), tables_(&tables) {}

  void read() {
    for (auto& [name, table] :
         root_->table({"drivers", "functions of time, of joints that move"}, false)
             .named_tables()) {
      const std::size_t before = table.problems().size();
      const std::string joint_name = table.text(
          {"joint", "the joint, \"hinge\", or of one with several movements \"ball.1\""});
      if (table.problems().size() != before) continue;
      if (const int index = joint_index(*mechanism_, joint_name); index >= 0)
        read_into(name, table, mechanism_->joints[static_cast<std::size_t>(index)]);
      else if (const int closing = index_by_name(mechanism_->closing, joint_name); closing >= 0)
        read_into(name, table, mechanism_->closing[static_cast<std::size_t>(closing)]);
      else
        say_unknown(table, joint_name);
    }
  }

 private:
  void say_unknown(TableReader& table, const std::string& name) {
    std::vector<std::string> known = names_of(mechanism_->joints);
    for (const std::string& closing : names_of(mechanism_->closing)) known.push_back(closing);
    table.problem("joint", fmt::format("there is no joint \"{}\"", name),
                  unknown_hint(name, known));
  }

  /// Notes a second driver of a joint, and one of a joint that `cannot` move.
  bool may_drive(TableReader& table, const std::string& joint, const std::string& before,
                 const char* cannot) {
    if (cannot == nullptr && before.empty()) return true;
    table.problem(
        "joint",
        fmt::format("joint \"{}\" {}", joint, before.empty() ? cannot : "has a driver already"),
        "one driver for each revolute, prismatic or screw joint, or for the length of a distance");
    return false;
  }

  void read_into(const std::string& name, TableReader& table, Joint& joint) {
    const bool fixed = joint.kind == JointKind::fixed;
    if (!may_drive(table, joint.name, joint.driver_name,
                   fixed ? "is fixed and cannot move" : nullptr)) {
      return;
    }
    // Of several movements some may have drivers, and forces move the others.
    if (joint.moved_by == spatial::MovedBy::forces && joint.name.find('.') == std::string::npos) {
      table.problem("joint", fmt::format("forces move joint \"{}\"", joint.name),
                    "remove moved_by from the joint, or the driver");
      return;
    }
    const bool turns = is_angle(joint.kind);
    joint.moved_by = spatial::MovedBy::driver;
    if (std::optional<Driver> function = read_function(table, turns ? angle : length, *tables_)) {
      joint.driver = std::move(*function);
      joint.driver_name = name;
      table.finish();
    }
  }

  void read_into(const std::string& name, TableReader& table, ClosingJoint& joint) {
    const bool distance = joint.kind == ClosingKind::distance;
    if (!may_drive(table, joint.name, joint.driver_name,
                   distance ? nullptr : "closes a loop and follows it")) {
      return;
    }
    if (std::optional<Driver> function = read_function(table, length, *tables_)) {
      joint.length = std::move(*function);
      joint.driver_name = name;
      table.finish();
    }
  }

  TableReader* root_;
  Mechanism* mechanism_;
  TimeTables* tables_;
};

/// What no driver moves is left to the loops. Notes joints that stand still in a tree without
/// loops, and distances whose length is not said once.
void free_the_rest(TableReader& root, const std::vector<bool>& has_length, Mechanism& mechanism) {
  for (Joint& joint : mechanism.joints) {
    if (!is_driven(joint) || !joint.driver_name.empty()) continue;
    if (!mechanism.closing.empty()) {
      joint.moved_by = spatial::MovedBy::loops;
      continue;
    }
    root.table("joints").problem(
        joint.name.substr(0, joint.name.find('.')),
        fmt::format("nothing drives joint \"{}\"", joint.name),
        fmt::format("write [drivers.<name>] with joint = \"{}\"; where it stands still, kind = "
                    "\"hold\" with its value; moved_by = \"forces\" in the joint where these do",
                    joint.name));
  }
  for (std::size_t i = 0; i < mechanism.closing.size(); ++i) {
    const ClosingJoint& joint = mechanism.closing[i];
    const bool driven = !joint.driver_name.empty();
    if (joint.kind != ClosingKind::distance || has_length[i] != driven) continue;
    root.table("joints").problem(
        joint.name,
        fmt::format("the length of \"{}\" is {}", joint.name, driven ? "said twice" : "not known"),
        driven ? "a rod has a length, a cylinder a driver"
               : fmt::format("write length = \"2 m\", or [drivers.<name>] with joint = \"{}\"",
                             joint.name));
  }
}

}  // namespace

bool read_chain_joints(TableReader& root, ChainDraft& chain, TimeTables& tables) {
  const std::size_t before = root.problems().size();
  Mechanism& mechanism = chain.mechanism;
  const JointDrafts drafts = read_joints_of(root, mechanism);
  chain.giving_way = drafts.giving_way;
  if (root.problems().size() != before || !sort_tree(root, drafts, mechanism)) {
    for (const char* key : {"drivers", "forces"}) {
      if (root.has(key)) root.table(key).accept_all();
    }
    return false;
  }
  mesh_gearings(root, drafts.gearings, mechanism);
  JointDrivers(root, mechanism, tables).read();
  if (root.problems().empty()) free_the_rest(root, drafts.has_length, mechanism);
  return true;
}

}  // namespace boxbeam::readers
