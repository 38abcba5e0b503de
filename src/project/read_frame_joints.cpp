#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "frame_reader.hpp"

namespace boxbeam::readers {
namespace {

using Eigen::Vector3d;
using frame::Joint;

constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr const char* rigid_word = "rigid";

/// World axes in the plane, or a first axis along which a roller holds, and others square to it.
Eigen::Matrix3d axes_from(const Vector3d& first) {
  Eigen::Matrix3d axes;
  axes.col(0) = first;
  axes.col(1) = first.unitOrthogonal();
  axes.col(2) = first.cross(axes.col(1));
  return axes;
}

/// The direction of a key, in the plane two numbers or an angle.
Vector3d direction_of(TableReader& table, const Key& key, const frame::Structure& structure,
                      const Vector3d& fallback) {
  if (structure.plane) {
    if (!table.has(key)) return fallback;
    const double angle = table.quantity(key, wanted::angle);
    return {std::cos(angle), std::sin(angle), 0.0};
  }
  return table.direction(key, fallback);
}

/// Axes of a joint whose first is given; in the plane the third stays the world's.
Eigen::Matrix3d joint_axes(const Vector3d& first, bool plane) {
  if (!plane) return axes_from(first);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.col(0) = first;
  axes.col(1) = Vector3d(-first.y(), first.x(), 0.0);
  return axes;
}

/// Springs of a general support or joint: its axes, along these and about them.
void read_springs(TableReader& table, const frame::Structure& structure, Joint& joint) {
  const bool plane = structure.plane;
  joint.axes = joint_axes(
      direction_of(table, {"direction", "of its first axis; the world's x where not said"},
                   structure, Vector3d::UnitX()),
      plane);
  const std::vector<double> along = table.per_direction(
      {"stiffness", "along its axes, in the plane two; \"rigid\" or 0 N/m for none"}, plane ? 2 : 3,
      wanted::stiffness, rigid_word);
  const std::vector<double> about =
      table.per_direction({"turning_stiffness", "about its axes, in the plane one"}, plane ? 1 : 3,
                          wanted::torsional_stiffness, rigid_word, 0.0);
  joint.stiffness = {};
  for (std::size_t k = 0; k < along.size(); ++k) joint.stiffness[k] = along[k];
  for (std::size_t k = 0; k < about.size(); ++k) joint.stiffness[plane ? 5 : 3 + k] = about[k];
}

void read_support(TableReader& table, const std::string& name, frame::Structure& structure) {
  Joint joint;
  joint.name = name;
  const std::size_t before = table.problems().size();
  const std::size_t kind =
      table.kind({"kind", "of support"}, {"fixed", "pinned", "roller", "general"});
  joint.a = read_frame_place(table, structure);
  if (table.problems().size() != before) {
    table.accept_all();
    structure.joints.push_back(std::move(joint));  // what moves with it knows its name
    return;
  }
  joint.b.p = in_world(structure, joint.a);
  const Vector3d up = structure.plane ? Vector3d::UnitY() : Vector3d::UnitZ();
  switch (kind) {
    case 0: joint.stiffness.fill(rigid); break;
    case 1: joint.stiffness = {rigid, rigid, rigid, 0.0, 0.0, 0.0}; break;
    case 2:
      joint.stiffness = {rigid, 0.0, 0.0, 0.0, 0.0, 0.0};
      joint.axes = joint_axes(direction_of(table,
                                           {"direction",
                                            "in which a roller holds; upwards where not said; in "
                                            "the plane an angle"},
                                           structure, up),
                              structure.plane);
      break;
    default: read_springs(table, structure, joint);
  }
  // Of a fork, which keeps a beam in space from turning about its axis.
  if ((kind == 1 || kind == 2) && !structure.plane &&
      table.boolean({"fork", "it holds the member against turning about its axis, too"}, false)) {
    const Vector3d axis = structure.members[static_cast<std::size_t>(joint.a.member)].axes.col(0);
    if (kind == 1) joint.axes = axes_from(axis);
    const Vector3d own = joint.axes.transpose() * axis;
    Eigen::Index nearest = 0;
    if (own.cwiseAbs().maxCoeff(&nearest) < 1.0 - 1e-9) {
      // The roller's other axes turn so that one lies along the member.
      const Vector3d first = joint.axes.col(0);
      joint.axes.col(1) = (axis - first * first.dot(axis)).normalized();
      joint.axes.col(2) = first.cross(joint.axes.col(1));
      nearest = 1;
    }
    joint.stiffness[static_cast<std::size_t>(3 + nearest)] = rigid;
  }
  table.finish();
  structure.joints.push_back(std::move(joint));
}

void read_joint(TableReader& table, const std::string& name, frame::Structure& structure) {
  Joint joint;
  joint.name = name;
  const std::size_t before = table.problems().size();
  const bool placed = before == 0;  // else where members are is not known
  const std::size_t kind =
      structure.plane ? table.kind({"kind", "of joint"}, {"rigid", "hinge", "general"})
                      : table.kind({"kind", "of joint"}, {"rigid", "hinge", "general", "ball"});
  const std::vector<std::string> ends =
      table.texts({"connect", "two points, \"member.point\""}, true);
  if (table.problems().size() == before && ends.size() != 2) {
    table.problem("connect", "a joint connects two points",
                  "write connect = [\"beam.end\", \"strut.start\"]; to the ground leads a support");
  }
  if (table.problems().size() == before) {
    joint.a = frame_point(table, "connect", ends[0], structure);
    joint.b = frame_point(table, "connect", ends[1], structure);
  }
  if (table.problems().size() != before) {
    table.accept_all();
    structure.joints.push_back(std::move(joint));
    return;
  }
  const double apart = (in_world(structure, joint.b) - in_world(structure, joint.a)).norm();
  const double size = length_of(structure.members[static_cast<std::size_t>(joint.a.member)]);
  if (joint.a.member == joint.b.member) {
    table.problem("connect", "a joint connects two different members", "write another point");
  } else if (placed && apart > 1e-6 * size) {
    table.problem("connect", fmt::format("the two points are {:.4g} mm apart", apart * 1e3),
                  "move a member or a point so that they meet; \"from\" and \"to\" take "
                  "\"member.point\", too");
  }
  // A joint that acts at two places is in no balance; but what is round-off beside the place that
  // was written would take its forces off that station, at which they let the cut forces jump.
  if (table.problems().empty()) {
    const frame::Member& b = structure.members[static_cast<std::size_t>(joint.b.member)];
    const Vector3d meeting = b.axes.transpose() * (in_world(structure, joint.a) - b.start);
    if ((meeting - joint.b.p).norm() > 1e-12 * size) joint.b.p = meeting;
  }
  switch (kind) {
    case 0: joint.stiffness.fill(rigid); break;
    case 1:
      joint.stiffness.fill(rigid);
      if (structure.plane) {
        joint.stiffness[5] = 0.0;
      } else {
        joint.axes = axes_from(table.direction({"axis", "about which a hinge turns, world axes"}));
        joint.stiffness[3] = 0.0;
      }
      break;
    case 2: read_springs(table, structure, joint); break;
    default: joint.stiffness = {rigid, rigid, rigid, 0.0, 0.0, 0.0};
  }
  table.finish();
  structure.joints.push_back(std::move(joint));
}

}  // namespace

void read_frame_joints(TableReader& root, frame::Structure& structure) {
  for (auto& [name, table] : root.table({"supports", "what holds the frame"}).named_tables())
    read_support(table, name, structure);
  for (auto& [name, table] : root.table({"joints", "between members"}, false).named_tables()) {
    if (index_by_name(structure.joints, name) >= 0) {
      table.problem("", fmt::format("\"{}\" is already the name of a support", name),
                    "give the joint another name");
    }
    read_joint(table, name, structure);
  }
}

}  // namespace boxbeam::readers
