#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "joint_parts.hpp"
#include "joint_tree.hpp"
#include "read_elasticity.hpp"
#include "read_gearing.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using spatial::ClosingJoint;
using spatial::ClosingKind;
using spatial::Mechanism;

/// Kinds as they are written: those of closing joints in their order, and one that closes nothing.
const std::vector<std::string> kinds{
    "fixed", "revolute", "prismatic", "cylindrical", "universal", "spherical", "planar",
    "slot",  "distance", "screw",     "gear",        "rack",      "free"};

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
  read_joint_drivers(root, drafts.has_length, tables, mechanism);
  return true;
}

}  // namespace boxbeam::readers
