#include "boxbeam/project/robot.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "robot_file.hpp"

namespace boxbeam::robots {
namespace {

/// How a joint stands at its reference: the carried link in the frame of the carrying one.
Pose reference_pose(const Joint& joint) {
  Pose pose{rotation_of(joint.turns), joint.xyz};
  const bool turns = joint.type == JointType::revolute || joint.type == JointType::continuous;
  if (turns) {
    pose.R = pose.R * Eigen::AngleAxisd(joint.reference, joint.axis.normalized());
  } else if (joint.type == JointType::prismatic) {
    pose.p += pose.R * joint.axis.normalized() * joint.reference;
  }
  pose.p -= pose.R * joint.point;
  return pose;
}

/// A movement at an instant: about or along an axis through a place, of the root's frame.
struct RobotMovement {
  std::size_t joint, number;
  bool turns;
  Eigen::Vector3d axis, place;
};

/// The movements of a joint in the posture of reference, in the order of its coordinates.
std::vector<RobotMovement> movements_of(const Joint& joint, std::size_t index, const Pose& link) {
  const auto world = [&](const Eigen::Vector3d& of) -> Eigen::Vector3d { return link.R * of; };
  const Eigen::Vector3d place = link.p + world(joint.point);
  std::vector<RobotMovement> movements;
  const auto add = [&](bool turns, const Eigen::Vector3d& axis) {
    movements.push_back({index, movements.size(), turns, world(axis), place});
  };
  const auto all_turns = [&] {
    for (int k = 2; k >= 0; --k) add(true, Eigen::Vector3d::Unit(k));
  };
  const Eigen::Vector3d axis = joint.axis.normalized();
  switch (joint.type) {
    case JointType::fixed: break;
    case JointType::revolute:
    case JointType::continuous: add(true, axis); break;
    case JointType::prismatic: add(false, axis); break;
    case JointType::planar: {
      const Eigen::Vector3d u = axis.unitOrthogonal();
      add(false, u);
      add(false, axis.cross(u));
      add(true, axis);
      break;
    }
    case JointType::spherical: all_turns(); break;
    case JointType::floating:
      for (int k = 0; k < 3; ++k) add(false, Eigen::Vector3d::Unit(k));
      all_turns();
      break;
  }
  return movements;
}

}  // namespace

const char* to_text(JointType type) {
  switch (type) {
    case JointType::fixed: return "fixed";
    case JointType::revolute: return "revolute";
    case JointType::continuous: return "continuous";
    case JointType::prismatic: return "prismatic";
    case JointType::planar: return "planar";
    case JointType::spherical: return "spherical";
    case JointType::floating: return "floating";
  }
  return "";
}

std::vector<Coordinate> coordinates_of(const Joint& joint) {
  const std::string& name = joint.name;
  switch (joint.type) {
    case JointType::fixed: return {};
    case JointType::revolute:
    case JointType::continuous: return {{name, true}};
    case JointType::prismatic: return {{name, false}};
    case JointType::planar:
      return {{name + ".1", false}, {name + ".2", false}, {name + ".3", true}};
    case JointType::spherical:
      return {{name + ".1", true}, {name + ".2", true}, {name + ".3", true}};
    case JointType::floating:
      return {{name + ".1", false}, {name + ".2", false}, {name + ".3", false},
              {name + ".4", true},  {name + ".5", true},  {name + ".6", true}};
  }
  return {};
}

Eigen::Matrix3d rotation_of(const std::vector<Turn>& turns) {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (const Turn& turn : turns) q = q * Eigen::AngleAxisd(turn.angle, turn.axis.normalized());
  return q.toRotationMatrix();
}

std::vector<std::size_t> carriers_of(const Robot& robot) {
  std::vector<std::size_t> carriers(robot.links.size(), robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) carriers[robot.joints[i].child] = i;
  return carriers;
}

std::vector<Pose> reference_poses(const Robot& robot) {
  const std::vector<std::size_t> carriers = carriers_of(robot);
  std::vector<Pose> poses(robot.links.size());
  std::vector<char> known(robot.links.size(), 0);
  known[robot.root] = 1;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    std::vector<std::size_t> way;  // from the link to one that is known
    for (std::size_t at = i; !known[at]; at = robot.joints[carriers[at]].parent) way.push_back(at);
    for (; !way.empty(); way.pop_back()) {
      const Joint& joint = robot.joints[carriers[way.back()]];
      poses[way.back()] = poses[joint.parent] * reference_pose(joint);
      known[way.back()] = 1;
    }
  }
  return poses;
}

std::vector<std::vector<bool>> left_to_closings(const Robot& robot) {
  std::vector<std::vector<bool>> left;
  for (const Joint& joint : robot.joints) left.emplace_back(coordinates_of(joint).size(), false);
  if (robot.closings.empty()) return left;
  const std::vector<Pose> poses = reference_poses(robot);
  const std::vector<std::size_t> carriers = carriers_of(robot);
  double size = 0.0;
  for (const Pose& pose : poses) size = std::max(size, pose.p.norm());
  if (size == 0.0) size = 1.0;
  // Which closings a joint moves: 1 where it carries b alone, -1 where a alone.
  const std::size_t joints = robot.joints.size();
  std::vector<std::map<std::size_t, int>> moves(joints);
  for (std::size_t k = 0; k < robot.closings.size(); ++k) {
    const Closing& closing = robot.closings[k];
    for (const auto& [end, sign] : {std::pair{closing.a, -1}, std::pair{closing.b, 1}})
      for (std::size_t at = end; carriers[at] < joints; at = robot.joints[carriers[at]].parent)
        moves[carriers[at]][k] += sign;
  }
  // Mimicked ones keep their drivers where they can, as actuated ones; of the others those that are
  // carried last are left first. Gram and Schmidt's method says what is independent.
  std::vector<bool> keeps(joints, false);
  for (std::size_t i = 0; i < joints; ++i) {
    if (robot.joints[i].actuated) keeps[i] = true;
    if (robot.joints[i].mimic) keeps[i] = keeps[robot.joints[i].mimic->joint] = true;
  }
  std::vector<Eigen::VectorXd> basis;
  const auto rows = static_cast<Eigen::Index>(6 * robot.closings.size());
  for (const bool kept : {false, true}) {
    for (std::size_t i = joints; i-- > 0;) {
      if (keeps[i] != kept || moves[i].empty()) continue;
      const Joint& joint = robot.joints[i];
      std::vector<RobotMovement> movements = movements_of(joint, i, poses[joint.child]);
      for (std::size_t m = movements.size(); m-- > 0;) {
        const RobotMovement& of = movements[m];
        Eigen::VectorXd column = Eigen::VectorXd::Zero(rows);
        for (const auto& [k, sign] : moves[i]) {
          if (sign == 0) continue;
          const Closing& closing = robot.closings[k];
          const Eigen::Vector3d place = poses[closing.b].p + poses[closing.b].R * closing.p_b;
          const auto row = static_cast<Eigen::Index>(6 * k);
          column.segment<3>(row) =
              of.turns ? of.axis.cross(place - of.place).eval() / size : of.axis;
          if (closing.kind == Closing::Kind::weld && of.turns) column.segment<3>(row + 3) = of.axis;
          column.segment<6>(row) *= sign;
        }
        const double whole = column.norm();
        for (int pass = 0; pass < 2; ++pass)
          for (const Eigen::VectorXd& of_basis : basis) column -= of_basis.dot(column) * of_basis;
        if (!(column.norm() > 1e-6 * whole) || whole == 0.0) continue;
        basis.push_back(column.normalized());
        left[i][m] = true;
      }
    }
  }
  return left;
}

}  // namespace boxbeam::robots
