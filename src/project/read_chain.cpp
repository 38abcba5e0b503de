#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using spatial::Body;
using spatial::Joint;
using spatial::JointKind;
using spatial::Mechanism;

constexpr FunctionOf length{wanted::length, "m", "stroke", "the driver does not move", true};
constexpr FunctionOf angle{wanted::angle, "rad", "angle", "the driver does not move", true};

/// Notes an inertia that no distribution of mass has: principal moments are not below zero, and
/// none is above the sum of the other two.
void check_inertia(TableReader& table, const Eigen::Matrix3d& inertia) {
  if (!inertia.allFinite()) return;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  const Eigen::Vector3d& moments = principal.eigenvalues();
  const double slack = 1e-9 * moments.cwiseAbs().maxCoeff();
  if (moments[0] >= -slack && moments[2] <= moments[0] + moments[1] + slack) return;
  table.problem("inertia",
                fmt::format("no body has these principal moments of inertia: {:.4g}, {:.4g} and "
                            "{:.4g} kg m^2",
                            moments[0], moments[1], moments[2]),
                "each is zero or more, and at most the sum of the other two");
}

/// The centre and inertia of a thin rod between two points of the body.
void read_rod(TableReader& table, Body& body) {
  const std::size_t before = table.problems().size();
  const std::vector<std::string> names = table.texts(
      {"uniform_rod", "a uniform thin rod between two of its points: gives centre and inertia"},
      true);
  if (table.problems().size() != before) return;
  std::vector<Eigen::Vector3d> ends;
  for (const std::string& name : names) {
    for (const spatial::BodyPoint& point : body.points) {
      if (point.name == name) ends.push_back(point.p);
    }
  }
  if (names.size() != 2 || ends.size() != 2) {
    table.problem("uniform_rod", "a rod lies between two points of its body",
                  names.size() == 2
                      ? "known: " + fmt::format("{}", fmt::join(names_of(body.points), ", "))
                      : "write uniform_rod = [\"B\", \"C\"]");
    return;
  }
  const Eigen::Vector3d along = ends[1] - ends[0];
  if (along.norm() == 0.0) {
    table.problem("uniform_rod", "the rod has no length: both points are at one place",
                  "name two points apart");
  }
  body.centre = 0.5 * (ends[0] + ends[1]);
  body.inertia = body.mass / 12.0 *
                 (along.squaredNorm() * Eigen::Matrix3d::Identity() - along * along.transpose());
}

void read_mass(TableReader& table, Body& body) {
  body.mass = table.not_negative({"mass", "of the body"}, wanted::mass, 0.0);
  static_cast<void>(table.says_one_of({{{"uniform_rod"}}, {{"centre", "inertia"}, false}, {}}));
  if (table.has("uniform_rod")) {
    if (table.has("centre") || table.has("inertia")) {
      table.problem("uniform_rod", "the rod gives centre and inertia",
                    "remove \"centre\" and \"inertia\", or \"uniform_rod\"");
      table.accept_all();
    }
    read_rod(table, body);
    return;
  }
  body.centre = table.triple({"centre", "centre of mass"}, wanted::length, Eigen::Vector3d::Zero());
  if (table.has("inertia")) {
    body.inertia = table.symmetric(
        {"inertia", "about the centre of mass: xx, yy, zz, or three rows"}, wanted::inertia);
    check_inertia(table, body.inertia);
    if (body.mass == 0.0 && body.inertia.allFinite() && !body.inertia.isZero(0.0)) {
      table.problem("inertia", "a body with inertia has a mass", "write \"mass\"");
    }
  }
}

Body read_body(const std::string& name, TableReader& table, bool is_beam) {
  Body body;
  body.name = name;
  if (name == "ground" || name == "world" || name.empty()) {
    table.problem("",
                  name.empty() ? std::string("a body has a name")
                               : fmt::format("\"{}\" is the world and no body", name),
                  "give the body another name");
  }
  TableReader points = table.table({"points", "of the body, by name, in its own axes"}, false);
  points.accept_all();
  for (const Node::Member& member : points.members("a point")) {
    body.points.push_back(
        {member.key,
         points.triple_in(member.value, fmt::format("point \"{}\"", member.key), wanted::length)});
  }
  if (is_beam)
    refuse_mass(table);
  else
    read_mass(table, body);
  table.finish();
  return body;
}

/// A joint as written, with the bodies that it connects.
struct JointDraft {
  Joint joint;
  int carried = spatial::ground;
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

/// Three revolutes one after the other through one point, with frames without mass between them.
void add_spherical(TableReader& table, const std::string& name, const JointDraft& whole,
                   Mechanism& mechanism, std::vector<JointDraft>& drafts) {
  std::vector<Eigen::Vector3d> axes{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(),
                                    Eigen::Vector3d::UnitX()};
  if (table.has("axes"))
    axes = table.directions({"axes", "of its three turns, one after the other"}, 3);
  if (axes.size() != 3) return;
  JointDraft draft = whole;
  for (std::size_t k = 0; k < 3; ++k) {
    draft.joint.name = fmt::format("{}.{}", name, k + 1);
    draft.joint.kind = JointKind::revolute;
    draft.joint.axis = draft.joint.turn * axes[k];
    if (k < 2) {
      draft.joint.point.setZero();
      draft.carried = static_cast<int>(mechanism.bodies.size());
      mechanism.bodies.emplace_back().name = draft.joint.name;
    } else {
      draft.joint.point = whole.joint.point;
      draft.carried = whole.carried;
    }
    drafts.push_back(draft);
    draft.joint.parent = draft.carried;
    draft.joint.at.setZero();
    draft.joint.turn.setIdentity();
  }
}

std::vector<JointDraft> read_joints_of(TableReader& root, Mechanism& mechanism) {
  std::vector<JointDraft> drafts;
  for (auto& [name, table] :
       root.table({"joints", "which joint carries which body; one for each"}).named_tables()) {
    JointDraft draft;
    draft.joint.name = name;
    const std::size_t before = table.problems().size();
    const std::size_t kind =
        table.kind({"kind", "of joint"}, {"fixed", "revolute", "prismatic", "spherical"});
    if (table.problems().size() != before) continue;
    read_connection(table, mechanism, draft);
    draft.joint.turn = turn_in(table);
    if (kind == 3) {
      add_spherical(table, name, draft, mechanism, drafts);
    } else {
      draft.joint.kind = static_cast<JointKind>(kind);
      // Written in the axes of the carried body where it stands at zero.
      if (kind > 0)
        draft.joint.axis =
            draft.joint.turn *
            table.direction({"axis", "about or along which it moves, in the carried body's axes"});
      drafts.push_back(draft);
    }
    table.finish();
  }
  return drafts;
}

/// Puts every body behind the one that carries it, and its joint at its place. Notes bodies that no
/// joint carries, that two carry, or that carry each other in a ring.
void sort_tree(TableReader& root, const std::vector<JointDraft>& drafts, Mechanism& mechanism) {
  const std::size_t count = mechanism.bodies.size();
  std::vector<const JointDraft*> carrier(count, nullptr);
  for (const JointDraft& draft : drafts) {
    if (draft.carried < 0) continue;
    const auto alike = std::count_if(drafts.begin(), drafts.end(), [&](const JointDraft& other) {
      return other.joint.name == draft.joint.name;
    });
    if (alike > 1) {
      root.table("joints").problem(
          draft.joint.name, fmt::format("two joints are called \"{}\"", draft.joint.name),
          "a spherical joint \"ball\" is \"ball.1\", \"ball.2\" and \"ball.3\": give the other "
          "another name");
      return;
    }
    const JointDraft*& of = carrier[static_cast<std::size_t>(draft.carried)];
    if (of != nullptr) {
      root.table("joints").problem(
          draft.joint.name,
          fmt::format("body \"{}\" is carried twice, by \"{}\" and by \"{}\"",
                      mechanism.bodies[static_cast<std::size_t>(draft.carried)].name,
                      of->joint.name, draft.joint.name),
          "in space bodies form a tree: one joint carries each; closed loops are known in the "
          "plane only");
      return;
    }
    of = &draft;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (carrier[i] != nullptr) continue;
    root.table("bodies").problem(
        mechanism.bodies[i].name,
        fmt::format("no joint carries body \"{}\"", mechanism.bodies[i].name),
        "write a joint with connect = [\"ground\", ...] or [\"another body's point\", ...]");
    return;
  }
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
        "the tree begins at the ground: one joint has connect = [\"ground\", ...]");
    return;
  }
  mechanism = std::move(sorted);
}

void read_joint_drivers(TableReader& root, Mechanism& mechanism, TimeTables& tables) {
  std::vector<bool> driven(mechanism.joints.size(), false);
  for (auto& [name, table] :
       root.table({"drivers", "functions of time, one for each joint that moves"}, false)
           .named_tables()) {
    const std::size_t before = table.problems().size();
    const std::string joint_name = table.text(
        {"joint", "the joint, \"hinge\", or of a spherical one \"ball.1\" to \"ball.3\""});
    if (table.problems().size() != before) continue;
    const int index = joint_index(mechanism, joint_name);
    if (index < 0) {
      table.problem("joint", fmt::format("there is no joint \"{}\"", joint_name),
                    unknown_hint(joint_name, names_of(mechanism.joints)));
      continue;
    }
    const auto i = static_cast<std::size_t>(index);
    Joint& joint = mechanism.joints[i];
    if (joint.kind == JointKind::fixed || driven[i]) {
      table.problem("joint",
                    fmt::format("joint \"{}\" {}", joint_name,
                                driven[i] ? "has a driver already" : "is fixed and cannot move"),
                    "one driver for each revolute or prismatic joint");
      continue;
    }
    driven[i] = true;
    const bool turns = joint.kind == JointKind::revolute;
    if (std::optional<Driver> function = read_function(table, turns ? angle : length, tables)) {
      joint.driver = std::move(*function);
      joint.driver_name = name;
      table.finish();
    }
  }
  if (!root.problems().empty()) return;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (driven[i] || joint.kind == JointKind::fixed) continue;
    root.table("joints").problem(
        joint.name.substr(0, joint.name.find('.')),
        fmt::format("nothing drives joint \"{}\"", joint.name),
        fmt::format("write [drivers.<name>] with joint = \"{}\"; where it stands still, kind = "
                    "\"hold\" with its value",
                    joint.name));
  }
}

}  // namespace

Mechanism read_chain(TableReader& root, const std::vector<std::string>& beam_bodies,
                     TimeTables& tables) {
  Mechanism mechanism;
  TableReader general = root.table({"mechanism", "general"});
  mechanism.gravity =
      general.triple({"gravity", "acceleration of free fall, world axes"}, wanted::acceleration);
  general.finish();
  mechanism.duration = read_duration(root);
  for (auto& [name, table] :
       root.table({"bodies", "rigid bodies; one joint carries each"}).named_tables()) {
    mechanism.bodies.push_back(read_body(
        name, table, std::find(beam_bodies.begin(), beam_bodies.end(), name) != beam_bodies.end()));
  }
  const std::size_t before = root.problems().size();
  const std::vector<JointDraft> drafts = read_joints_of(root, mechanism);
  // Without the tree, nothing else can be found in it.
  if (root.problems().size() == before) sort_tree(root, drafts, mechanism);
  if (mechanism.joints.size() != mechanism.bodies.size()) {
    for (const char* key : {"drivers", "forces"}) {
      if (root.has(key)) root.table(key).accept_all();
    }
    return mechanism;
  }
  read_joint_drivers(root, mechanism, tables);
  read_chain_loads(root, mechanism, tables);
  check_functions(root, functions_of(mechanism), mechanism.duration, {"joints", "forces"});
  return mechanism;
}

}  // namespace boxbeam::readers
