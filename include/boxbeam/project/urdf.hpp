#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Robots as URDF files describe them, and cases in space that begin with one. SI units, angles in
/// radians. Source: the specification of URDF/XML, elements robot, link, joint (Open Robotics,
/// wiki.ros.org/urdf/XML).
namespace boxbeam::urdf {

/// Mass of a link, in the link's axes: a place p of the inertial frame is at xyz + R p, and
/// inertia = R I R^T.
struct Inertial {
  double mass = 0.0;                                  ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< of mass, from the link's origin [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre [kg m^2]
};

struct Link {
  std::string name;
  std::optional<Inertial> inertial = {};
};

enum class JointType { fixed, revolute, continuous, prismatic, planar, floating };

const char* to_text(JointType type);

/// What a joint may do; none where it is not said. SI units of its coordinate.
struct Limit {
  std::optional<double> lower, upper, effort, velocity;
};

/// The coordinate follows that of another joint: q = multiplier q_other + offset.
struct Mimic {
  std::size_t joint = 0;  ///< index of the other
  double multiplier = 1.0;
  double offset = 0.0;
};

/// Carries a link by another. The carried link's frame is the joint's: where the joint is at zero
/// it stands at xyz in the carrying link's frame, turned by R = Rz(yaw) Ry(pitch) Rx(roll).
struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  std::size_t parent = 0, child = 0;                ///< indices of links
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();    ///< [m]
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();    ///< roll, pitch, yaw [rad]
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< in the joint's frame, of any length
  Limit limit = {};
  std::optional<Mimic> mimic = {};
  std::optional<double> damping = {}, friction = {};
};

/// One of the movements of a joint, as a case in space calls it: "wrist", or of several "base.1".
struct Coordinate {
  std::string name;
  bool turns = true;  ///< else it shifts
};

std::vector<Coordinate> coordinates_of(const Joint& joint);

/// R = Rz(yaw) Ry(pitch) Rx(roll).
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rpy);

/// Links form a tree: one joint carries each but the root.
struct Robot {
  std::string file;  ///< as it was named
  std::string name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::size_t root = 0;                 ///< index of a link
  std::map<std::string, int> left_out;  ///< elements that are not read, and how often they stand

  /// A root without mass is the ground; another one is fixed to it.
  bool is_ground(std::size_t link) const { return link == root && !links[root].inertial; }
};

/// Reads a file. Throws InputError with all problems.
Robot read_robot(const std::string& path);
/// The same from text, under a name for messages.
Robot parse_robot(const std::string& file, const std::string& text);

/// The skeleton of a case in space with the robot's bodies and joints, as the text of a TOML file:
/// it can be verified, and marks as PLACEHOLDER what the robot does not say: section, material,
/// drivers. `beam`: the link that is verified; "": the heaviest that is not the root. Throws
/// InputError where there is no such link.
std::string case_text(const Robot& robot, const std::string& beam);

}  // namespace boxbeam::urdf
